import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.language.text.nearest import hint, is_near, nearest_name, nearest_word, slips

NAMES = ("upper_arm", "forearm", "LF_hip", "wrist", "link3", "j1")


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("foream", "forearm"),
        ("fore_arm", "forearm"),
        ("wirst", "wrist"),
        ("Wrist", "wrist"),
        ("WRIST", "wrist"),
        ("fore", None),
        ("arms", None),
        ("uper_arm", "upper_arm"),
        ("LF_hpi", "LF_hip"),
        ("gripper", None),
        ("link4", None),
        ("j2", None),
        ("x", None),
    ],
)
def test_slips_are_seen_through(written: str, meant: str | None) -> None:
    assert nearest_name(written, NAMES) == meant


def test_of_equally_close_names_the_first_is_meant() -> None:
    assert nearest_name("elbox", ("elbow", "elboy")) == "elbow"
    assert nearest_name("elbox", ("elboy", "elbow")) == "elboy"


def test_hint_ends_a_message() -> None:
    assert hint("wrist") == "; did you mean 'wrist'?"
    assert hint("lint", after=",") == ", did you mean 'lint'?"
    assert hint(None) == ""


KEYWORDS = ("children", "frames", "inertia_params", "mass", "CoM", "Ix", "Ixy", "PI", "via")


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("chidren", "children"),
        ("Children", "children"),
        ("inertia", "inertia_params"),
        ("params", "inertia_params"),
        ("com", "CoM"),
        ("ixy", "Ixy"),
        ("pi", "PI"),
        ("vai", "via"),
        ("ix", "Ix"),
        ("Iz", None),
        ("for", None),
        ("fra", None),
        ("elbow", None),
    ],
)
def test_words_that_all_know_may_be_short_or_in_another_case(
    written: str, meant: str | None
) -> None:
    assert nearest_word(written, KEYWORDS) == meant
    assert any(is_near(written, word) for word in KEYWORDS) == (meant is not None)


def test_of_equally_near_words_the_alphabet_decides() -> None:
    assert nearest_word("Iyy", ("Ixy", "Iyz", "Iy")) == "Ixy"
    assert nearest_word("Iyy", ("Iyz", "Ixy")) == "Ixy"
    assert nearest_word("any", ()) is None


words = st.text("abcAB1", max_size=7)


@settings(deadline=None, max_examples=300)
@given(words, words, words, st.sampled_from([0.5, 1.0, 1.5, 2.5, 9.0]))
def test_slips_are_a_distance(one: str, other: str, third: str, most: float) -> None:
    """Looking at no more than `most` slips changes no answer within them."""
    exact = slips(one, other, 99.0)
    assert slips(one, other, most) == (exact if exact <= most else float("inf"))
    assert slips(other, one, 99.0) == exact
    assert (exact == 0.0) == (one == other)
    # A wrong case costs half: at most so much as writing every letter anew.
    assert exact <= max(len(one), len(other))
    assert slips(one.lower(), other.lower(), 99.0) <= exact
    assert slips(one + third, other + third, 99.0) <= exact


@settings(deadline=None)
@given(st.text("abcde", min_size=5, max_size=9), st.integers(0, 4), st.sampled_from("xyz"))
def test_one_wrong_letter_is_seen_through(name: str, place: int, letter: str) -> None:
    wrong = name[:place] + letter + name[place + 1 :]
    assert nearest_name(wrong, ("quite_different", name)) == name
