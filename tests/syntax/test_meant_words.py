"""Words of other formats and habits: what they mean, and where two things may be meant."""

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.frontends.features.actions.code_actions import quick_fixes
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.language.text.edits import apply_edits

MOMENTS = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")
ROBOT = """Robot R {
RobotBase base {
    children {
        upper via turn
    }
}
link upper {
    id = 1
    inertia_params {
        mass = 1.5
        CoM = (0.0, 0.0, 0.0)
        Ix = 1.1
        Iy = 1.2
        Iz = 1.3
        Ixy = 0.1
        Ixz = 0.2
        Iyz = 0.3
    }
    children {}
}
r_joint turn {
    ref_frame {
        translation = (0.0, 0.0, 0.0)
        rotation = (0.0, 0.0, 0.0)
    }
}
}
"""


def changed(old: str, new: str) -> Analysis:
    assert old in ROBOT
    return analyse(ROBOT.replace(old, new, 1))


def titles(analysis: Analysis, code: str) -> list[list[str]]:
    """The titles of the fixes of each finding of a rule."""
    found = [d for d in analysis.findings if d.code == code]
    return [[f.title for f in d.choices or ((d.fix,) if d.fix else ())] for d in found]


@pytest.mark.parametrize(
    ("word", "meant"),
    [
        ("joint", ["r_joint", "p_joint"]),
        ("Joint", ["r_joint", "p_joint"]),
        ("revolute", ["r_joint"]),
        ("revolute_joint", ["r_joint"]),
        ("prismatic", ["p_joint"]),
        ("slider", ["p_joint"]),
        ("rjoint", ["r_joint"]),
    ],
)
def test_a_kind_of_joint_is_chosen_where_two_may_be_meant(word: str, meant: list[str]) -> None:
    analysis = changed("r_joint", word)
    expected = [f"Replace '{word}' with '{each}'" for each in meant]
    assert titles(analysis, "KD010") == [expected]
    place = analysis.text.index(f"{word} turn")
    offered = [a for a in quick_fixes(analysis, place, place) if a.title.startswith("Replace")]
    assert [a.title for a in offered] == expected
    assert not any(a.is_preferred for a in offered)
    for action, each in zip(offered, meant, strict=True):
        assert apply_edits(analysis.text, action.edits) == ROBOT.replace("r_joint", each)


def test_a_lost_kind_of_joint_is_chosen() -> None:
    assert titles(changed("r_joint turn", "turn"), "KD001") == [
        ["Insert 'r_joint'", "Insert 'p_joint'"]
    ]


def test_a_name_that_is_as_near_to_two_others_is_chosen() -> None:
    text = ROBOT.replace("upper via turn", "uppxr via turn").replace("link upper", "link uppar")
    second = text[text.index("link") : text.index("r_joint")].replace("uppar", "upper")
    analysis = analyse(text.replace("r_joint", second.replace("id = 1", "id = 2") + "r_joint"))
    expected = [f"Replace 'uppxr' with '{name}'" for name in ("uppar", "upper")]
    assert titles(analysis, "KD105") == [expected]


@pytest.mark.parametrize("value", ["π", "-π", "π/2.0", "2.0*π", "𝜋"])
def test_the_letter_pi_is_the_number(value: str) -> None:
    analysis = changed("rotation = (0.0", f"rotation = ({value}")
    letter = value.strip("-/2.0*")
    assert titles(analysis, "KD408") == [[f"Replace '{letter}' with 'PI'"]]
    assert "KD401" not in [found.code for found in analysis.findings]


@pytest.mark.parametrize(
    ("block", "statement"),
    [
        ("link", "parent = base"),
        ("link", "parent base"),
        ("link", "parent {\n        base via turn\n    }"),
        ("joint", "parent = base"),
        ("joint", "child = upper"),
    ],
)
def test_relatives_are_left_out_and_never_become_children(block: str, statement: str) -> None:
    place = {"link": "    id = 1\n", "joint": "    ref_frame {"}[block]
    analysis = changed(place, f"    {statement}\n{place}")
    word = statement.split()[0]
    told = f"a {block} has no '{word}': parents list their links and joints under 'children'"
    (found,) = [d for d in analysis.findings if d.code.startswith("KD0")]
    assert found.message == told
    assert found.fix is not None
    assert apply_edits(analysis.text, found.fix.edits).split() == ROBOT.split()


@pytest.mark.parametrize("name", ["parent", "child"])
def test_relatives_are_names_where_names_stand(name: str) -> None:
    frames = f"frames {{\n{name} {{ translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }} }}"
    for analysis in (
        changed("children {}", f"children {{}} {frames}"),
        analyse(ROBOT.replace("upper", name)),
        analyse(ROBOT.replace("turn", name)),
    ):
        assert [d.message for d in analysis.findings if d.code.startswith("KD0")] == []


@pytest.mark.parametrize(
    ("format_", "words"),
    [
        ("tensor", "I11 I22 I33 I12 I13 I23"),
        ("J", "Jxx Jyy Jzz Jxy Jxz Jyz"),
        ("transposed", "ixx iyy izz iyx izx izy"),
    ],
)
def test_six_moments_are_six_words(format_: str, words: str) -> None:
    text = _written(words.split())
    assert _mended(text) == ROBOT


def test_a_whole_matrix_keeps_its_upper_half() -> None:
    lower = "        iyx = 0.1\n        izx = 0.2\n        izy = 0.3\n    }\n    children"
    upper = _written(["ixx", "iyy", "izz", "ixy", "ixz", "iyz"])
    text = upper.replace("    }\n    children", lower, 1)
    assert _mended(text).split() == ROBOT.split()


_letters = st.sampled_from("IiJxyzw1_ab")


@settings(max_examples=25, deadline=None)
@given(st.lists(st.text(_letters, min_size=1, max_size=4), min_size=6, max_size=6))
def test_two_words_of_a_section_never_become_the_same(words: list[str]) -> None:
    """Whatever stands where the moments do, no two of different spelling are mended to one."""
    analysis = analyse(_written(words))
    new: dict[str, str] = {}
    for found in analysis.findings:
        for edit in found.fix.edits if found.fix and found.code in ("KD001", "KD010") else ():
            if edit.text in MOMENTS:
                written = analysis.text[edit.start : edit.end]
                assert new.setdefault(edit.text, written) == written
                assert edit.text not in words


def _written(words: list[str]) -> str:
    text = ROBOT
    for moment, word in zip(MOMENTS, words, strict=True):
        text = re.sub(rf"^( +){moment} =", rf"\g<1>@{word} =", text, count=1, flags=re.M)
    return text.replace("@", "")


def _mended(text: str) -> str:
    for _ in range(20):
        fixes = [d.fix for d in analyse(text).findings if d.code.startswith("KD0")]
        if not fixes or fixes[0] is None:
            break
        text = apply_edits(text, fixes[0].edits)
    return text


CASES = (str.lower, str.upper, str.capitalize, str.swapcase, lambda word: word + word[-1])


@pytest.mark.parametrize(
    "word",
    ("Robot", "RobotBase", "link", "id", "inertia_params", "mass", "CoM", *MOMENTS, "children",
     "via", "r_joint", "ref_frame", "translation", "rotation"),
)  # fmt: skip
@pytest.mark.parametrize("parameter", [None, "mass", "CoM", "Ix", "id", "link"])
def test_a_keyword_in_other_letters_is_what_is_meant(word: str, parameter: str | None) -> None:
    """Though a parameter is named like a keyword, it is not given already."""
    text = ROBOT if parameter is None else ROBOT.replace("1.3", parameter).replace("0.2", parameter)
    place = re.search(rf"\b{word}\b", text)
    assert place is not None
    for changing in CASES:
        other = changing(word)
        if other in (word, "idd", "Ixx", "Iyy", "Izz", "Ixyy", "Iyzz", "Ixzz"):
            continue
        wrong = f"{text[: place.start()]}{other}{text[place.end() :]}"
        found = [f for f in analyse(wrong).findings if f.code in ("KD008", "KD009", "KD010")]
        assert [f.code for f in found] == ["KD010"], (other, [f.message for f in found])
        assert f"'{other}'" in found[0].message
        assert found[0].fix is not None
        assert apply_edits(wrong, found[0].fix.edits) == text


def test_a_section_in_other_letters_beside_itself_is_a_second_one() -> None:
    found = changed("mass = 1.5", "mass = 1.5 Mass = 1.5").findings
    assert [f.message for f in found] == ["second 'mass', written 'Mass'"]
    found = changed("mass = 1.5", "mass = 1.5 Mass = mass").findings
    assert "KD009" not in [f.code for f in found]
