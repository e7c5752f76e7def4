import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.text.nearest import did_you_mean, hint

NAMES = ("upper_arm", "forearm", "LF_hip", "wrist", "link3", "j1")


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("foream", "forearm"),
        ("fore_arm", "forearm"),
        ("wirst", "wrist"),
        ("Wrist", "wrist"),
        ("uper_arm", "upper_arm"),
        ("LF_hpi", "LF_hip"),
        ("gripper", None),
        ("link4", None),
        ("j2", None),
        ("x", None),
    ],
)
def test_slips_are_seen_through(written: str, meant: str | None) -> None:
    assert did_you_mean(written, NAMES) == meant


def test_of_equally_close_names_the_first_is_meant() -> None:
    assert did_you_mean("elbox", ("elbow", "elboy")) == "elbow"
    assert did_you_mean("elbox", ("elboy", "elbow")) == "elboy"


def test_hint_ends_a_message() -> None:
    assert hint("wrist") == "; did you mean 'wrist'?"
    assert hint(None) == ""


@settings(deadline=None)
@given(st.text("abcde", min_size=5, max_size=9), st.integers(0, 4), st.sampled_from("xyz"))
def test_one_wrong_letter_is_seen_through(name: str, place: int, letter: str) -> None:
    wrong = name[:place] + letter + name[place + 1 :]
    assert did_you_mean(wrong, ("quite_different", name)) == name
