"""No text makes a rule fail: every finding lies in the text, every fix can be applied."""

import random

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from tests.support.finding_checks import EVERYTHING, assert_sound
from tests.support.models import Style, random_model

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.rules import missing_names
from kindsl.judgement.rules.reference_defects import MOST_SUGGESTIONS

WORDS = (
    "Robot R {", "RobotBase b {", "RobotBase b floating {", "link l {", "link b {", "link l2 {",
    "r_joint j {", "p_joint j {", "r_joint l {", "id = 1", "id = -1", "id = 99999999999999999999",
    "inertia_params {", "mass = 1.0", "mass = x", "mass = -0.0", "CoM = (0.0, x, 1e300)",
    "CoM = (1.0)", "CoM = (0.0, 0.0, 0.3)", "Ix = 1.0", "Iy = k", "Iz = 1e308", "Ixy = 0.0",
    "Ixz = -1.0/0.0", "Iyz = x/x", "ref_frame = f", "ref_frame {", "children {", "l via j",
    "l2 via j", "b via j", "j via l", "l via", "frames {", "f {", "translation = (x, 1000.0, pi)",
    "rotation = (90.0, PI/0.0, <k>)", "rotation = (1.5708, PI/2.0, <k=1>)", "}", "}", "}", "}", "(",
    ",", "// kindsl: ignore[KD3]", "/*", "*/", "\n", "\r", "^x", "\u00e9",
)  # fmt: skip
MODEL = random_model(5, 4, Style(has_expressions=True))


def check(text: str) -> None:
    assert_sound(analyse(text, EVERYTHING))


@settings(max_examples=100, deadline=None)
@given(st.lists(st.sampled_from(WORDS), max_size=60))
@example([])
def test_any_row_of_words(words: list[str]) -> None:
    check(" ".join(words))


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10**9), cuts=st.integers(1, 6))
def test_any_cut_and_pasted_model(seed: int, cuts: int) -> None:
    generator = random.Random(seed)
    text = MODEL
    for _ in range(cuts):
        a, b = sorted(generator.randrange(len(text) + 1) for _ in range(2))
        at = generator.randrange(len(text) + 1)
        text = text[:at] + text[a : min(b, a + 400)] + text[at:]
        gone = generator.randrange(len(text))
        text = text[:gone] + text[gone + generator.randrange(30) :]
    check(text)


NUMBERS = (
    "0.0", "-0.0", "1.0", "0.3", "1e308", "-1e308", "1e-308", "5e-324", "1e999", "-1e999",
    f"{'9' * 400}.0", f"0.{'0' * 400}1", "1e-999999", "1e999999", "x", "k", "offset", "1.0/x",
)  # fmt: skip


@settings(max_examples=150, deadline=None)
@given(st.lists(st.sampled_from(NUMBERS), min_size=16, max_size=16))
def test_any_numbers(numbers: list[str]) -> None:
    mass, x, y, z, ix, iy, iz, ixy, ixz, iyz, *pose = numbers
    inertia = f"inertia_params {{ mass = {mass} CoM = ({x}, {y}, {z}) Ix={ix} Iy={iy} Iz={iz}"
    rotated = f"translation = ({', '.join(pose[:3])}) rotation = ({', '.join(pose[3:])})"
    text = f"{inertia} Ixy={ixy} Ixz={ixz} Iyz={iyz} }}"
    link = f"link a {{ id = 1 {text} children {{ c via e }} frames {{ f {{ {rotated} }} }} }}\n"
    joints = "".join(f"r_joint {name} {{ ref_frame {{ {rotated} }} }}\n" for name in "bde")
    other = f"link c {{ id = 2 {text} children {{}} }}\n"
    base = f"RobotBase g floating {{ {text} children {{ a via b }} }}\n"
    check(f"Robot R {{\n{base}{link}{other}{joints}}}\n")


def test_a_document_of_wrong_names_only_is_linted_in_linear_time(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Each name is compared with all others only where that is told of it."""
    asked: list[str] = []
    compared = missing_names.nearest_names
    monkeypatch.setattr(
        missing_names,
        "nearest_names",
        lambda name, known: asked.append(name) or compared(name, known),
    )
    links = "".join(
        f"link a{n} {{ id = {n} children {{ q{n}x via r{n}y }} }}\n" for n in range(1, 101)
    )
    joints = "".join(f"r_joint s{n}z {{ }}\n" for n in range(100))
    found = analyse(f"Robot R {{\nRobotBase b {{ children {{}} }}\n{links}{joints}}}\n").findings
    assert sum(f.code == "KD105" for f in found) == 100
    assert len(set(asked)) == 2 * MOST_SUGGESTIONS
