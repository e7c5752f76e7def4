"""No rule fails on what is there in part: a value without a number, a section or block left out."""

import re

import pytest

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding

POSE = "{ translation = (0.1, 1.0/0.0, 0.000001) rotation = (0.1, PI/2.0, 0.1) }"
INERTIA = """inertia_params {
    mass = 2.0 CoM = (m, 0.2, 9.0)
    Ix=0.1 Iy=0.1 Iz=0.123456789012 Ixy=0.000001 Ixz=0.0 Iyz=0.0 ref_frame = tip
}"""


def _link(name: str, number: int, children: str) -> str:
    frames = f"frames {{ tip {POSE} {name}_end {POSE} }}"
    return f"link {name} {{ id = {number} {INERTIA} children {{ {children} }} {frames} }}\n"


DOCUMENT = f"""Robot R {{
RobotBase base floating {{ {INERTIA} children {{ left_arm via a right_arm via b hand via c }} }}
{_link("left_arm", 5, "left_hand via d")}{_link("right_arm", 2, "right_hand via e")}
{_link("left_hand", 3, "")}{_link("right_hand", 1, "left_arm via a")}{_link("hand", 3, "")}
"""
DOCUMENT += "".join(f"r_joint {name} {{ id = 1 ref_frame {POSE} }}\n" for name in "abcde") + "}\n"
PIECES = {
    "number": r"(?<=[ (=])\d+\.\d+(?=[ ,)])",
    "triple": r"(?<= = )\([^)]*\)",
    "id": r"id = \d",
    "mass": r"mass = \S+",
    "moment": r"I[xyz]+=\S+",
    "vector": r"\w+ = \([^)]*\)",
    "frame of an inertia": r"ref_frame = \w+",
    "inertia": re.escape(INERTIA),
    "pair": r"\w+ via \w+",
    "pose": re.escape(POSE),
    "frame": rf"\w+ {re.escape(POSE)}",
    "block": r"^(?:link|r_joint|RobotBase) .*(?:\n.*?)*?\n(?=link|r_joint|\}\Z|$)",
}


SETTINGS = Settings(select=("KD",), bindings={"m": Binding(0.1, 0.0, 0.5)})


@pytest.mark.parametrize("kind", PIECES)
def test_a_piece_left_out_or_unknown(kind: str) -> None:
    places = list(re.finditer(PIECES[kind], DOCUMENT, re.MULTILINE))
    assert len(places) > 4
    for place in places[:20]:
        for instead in ("", "unknown"):
            text = DOCUMENT[: place.start()] + instead + DOCUMENT[place.end() :]
            assert analyse(text, SETTINGS).faults == (), text[place.start() - 40 : place.end()]
