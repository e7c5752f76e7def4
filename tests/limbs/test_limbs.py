"""Limbs of random robots, whose frames lie anyhow: alike as they are, and with one slip in one."""

import random
import re
from itertools import pairwise

import pytest
from tests.support.amount import usually
from tests.support.bodies import significant
from tests.support.examples import placed_joint
from tests.support.legged import COPIED, REFLECTED, Legs, Walker

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.language.text.edits import apply_edits
from kindsl.mechanics.rigid.pose import Vector3
from kindsl.robots.limbs.limb import limbs_of

LIMB_CODES = ("KD208", "KD209", "KD210", "KD509", "KD510")
JOINT = re.compile(r"r_joint (\w+) \{ ref_frame \{ translation = \((.*?)\) rotation = \((.*?)\) ")
ALL_LEGS = pytest.mark.parametrize("legs", [REFLECTED, COPIED], ids=["reflected", "copied"])


def told(analysis: Analysis) -> list[Diagnostic]:
    assert analysis.faults == ()
    return [finding for finding in analysis.findings if finding.code in LIMB_CODES]


def walker(seed: int, legs: Legs) -> str:
    robot = Walker(random.Random(seed), legs)
    return robot.document(robot.bodies, significant(9))


@ALL_LEGS
@pytest.mark.parametrize("seed", range(usually(10, 200)))
def test_limbs_that_are_alike_are_left_in_peace(seed: int, legs: Legs) -> None:
    assert told(analyse(walker(seed, legs))) == []


@ALL_LEGS
@pytest.mark.parametrize("seed", range(usually(10, 200)))
def test_another_number_in_one_limb_is_named_and_put_right(seed: int, legs: Legs) -> None:
    text = walker(seed, legs)
    generator = random.Random(seed)
    joint = generator.choice([j for j in JOINT.finditer(text) if "knee" in j[1]])
    numbers = joint[2].split(", ")
    place = generator.randrange(3)
    numbers[place] = f"{float(numbers[place]) + generator.choice((-0.2, 0.3)):.9f}"
    spoilt = text[: joint.start(2)] + ", ".join(numbers) + text[joint.end(2) :]
    (finding,) = told(analyse(spoilt))
    assert finding.code == "KD509"
    assert finding.message.startswith(f"translation of '{joint[1]}' is ({', '.join(numbers)}), by")
    assert finding.fix is not None
    (fixed,) = (
        j for j in JOINT.finditer(apply_edits(spoilt, finding.fix.edits)) if j[1] == joint[1]
    )
    meant = [float(number) for number in joint[2].split(", ")]
    assert [float(number) for number in fixed[2].split(", ")] == pytest.approx(meant, abs=1e-6)


@pytest.mark.parametrize("seed", range(usually(5, 50)))
def test_two_slips_in_two_limbs_are_meant(seed: int) -> None:
    text = walker(seed, COPIED)
    places = {j[1]: j for j in JOINT.finditer(text)}
    for leg in ("LF", "LH"):
        old = places[f"{leg}_knee"][2]
        first, rest = old.split(", ", 1)
        text = text.replace(f"({old})", f"({float(first) + 0.1:.9f}, {rest})")
    assert told(analyse(text)) == []


SUSPENDED = {"LF": (1.0, 0.4), "RF": (1.0, -0.4), "LH": (-1.0, 0.4), "RH": (-1.0, -0.4)}
CAR_LINK = """link %s { id = %d inertia_params { mass = 2.0 CoM = (0.0, 0.0, %s)
    Ix=0.12 Iy=0.12 Iz=0.02 Ixy=0.0 Ixz=0.0 Iyz=0.0 } children { %s } }\n"""


def car(com: str) -> str:
    """Return a car whose front wheels are carried by knuckles; its left one has this CoM."""
    links, joints, heads = [], [], []
    for corner, place in SUSPENDED.items():
        parts = ("arm", "knuckle", "wheel") if corner[1] == "F" else ("arm", "wheel")
        names = [f"{corner}_{part}" for part in parts]
        heads.append(f"{names[0]} via {names[0]}_joint")
        for name, below in zip(names, [*names[1:], ""], strict=True):
            height = com if name == "LF_wheel" else "0.1"
            children = f"{below} via {below}_joint" if below else ""
            links.append(CAR_LINK % (name, len(links) + 1, height, children))
            at = (*place, 0.0) if name == names[0] else (0.0, 0.3, 0.0)
            joints.append(placed_joint(f"{name}_joint", "{}, {}, {}".format(*at), "0.0, 0.0, 0.0"))
    head = f"Robot Car {{\nRobotBase body {{ children {{ {' '.join(heads)} }} }}\n"
    return f"{head}{''.join(links)}{''.join(joints)}}}\n"


@pytest.mark.parametrize(("com", "codes"), [("0.1", []), ("-0.1", ["KD510"])])
def test_limbs_may_have_other_links_in_front_than_behind(com: str, codes: list[str]) -> None:
    assert [f.code for f in told(analyse(car(com)))] == codes


# Like fingers, mounted anyhow, and a thumb, which is none of them.
HAND = {
    1: ("(0.0, 0.045, -0.001) rotation = (-0.09, 0.0, 0.0)", "0.016", "0.054", "0.038"),
    2: ("(0.0, 0.0, 0.003) rotation = (0.0, 0.0, 0.0)", "0.016", "0.054", "0.038"),
    3: ("(0.01, -0.05, 0.0) rotation = (0.12, 0.03, 0.0)", "0.016", "0.054", "0.038"),
    4: ("(0.0, -0.02, -0.05) rotation = (0.0, 0.4, 1.2)", "0.01", "0.05", "0.04"),
}
HEADS = " ".join(f"finger_{n}_0 via joint_{n}_0" for n in HAND)


def hand() -> str:
    links, joints = "", ""
    for n, (mount, *lengths) in HAND.items():
        places = [mount, *(f"({x}, 0.0, 0.0) rotation = (PI/2.0, 0.0, 0.0)" for x in lengths)]
        for part, place in enumerate(places):
            child = f"finger_{n}_{part + 1} via joint_{n}_{part + 1}" if part < 3 else ""
            links += (
                f"link finger_{n}_{part} {{ id = {4 * n + part - 3} children {{ {child} }} }}\n"
            )
            joints += f"r_joint joint_{n}_{part} {{ ref_frame {{ translation = {place} }} }}\n"
    return f"Robot hand {{\nRobotBase palm {{ children {{ {HEADS} }} }}\n{links}{joints}}}\n"


def test_a_finger_is_compared_however_it_is_mounted() -> None:
    text = hand()
    assert told(analyse(text)) == []
    joint = text.index("r_joint joint_2_2")
    spoilt = text[:joint] + text[joint:].replace("0.054", "0.045", 1)
    (finding,) = told(analyse(spoilt))
    assert finding.code == "KD509"
    assert "by its twins (0.054, 0.0, 0.0)" in finding.message
    assert finding.fix is not None
    assert apply_edits(spoilt, finding.fix.edits) == text


def gripper(left: str, right: str) -> str:
    """Return two fingers whose joints begin at one point, with these rotations."""
    inertia = (
        "inertia_params { mass = 0.015 CoM = (0.0, 0.01, 0.02)"
        " Ix = 0.00001 Iy = 0.000008 Iz = 0.000004 Ixy = 0.0 Ixz = 0.0 Iyz = 0.000003 }"
    )
    turns = {"left": left, "right": right}
    heads = " ".join(f"{side}_finger via {side}_joint" for side in turns)
    links, joints = "", ""
    for n, (side, rotation) in enumerate(turns.items(), 1):
        links += f"link {side}_finger {{ id = {n} {inertia} children {{ }} }}\n"
        place = f"translation = (0.0, 0.0, 0.1654) rotation = {rotation}"
        joints += f"p_joint {side}_joint {{ ref_frame {{ {place} }} }}\n"
    return f"Robot gripper {{\nRobotBase palm {{ children {{ {heads} }} }}\n{links}{joints}}}\n"


def test_fingers_that_open_away_from_each_other_at_one_place_are_alike() -> None:
    assert told(analyse(gripper("(-PI/2.0, PI/4.0, 0.0)", "(PI/2.0, -PI/4.0, PI)"))) == []


def test_a_finger_that_begins_elsewhere_may_be_put_where_the_other_is() -> None:
    text = gripper("(PI/2.0, 0.0, PI)", "(-PI/2.0, 0.0, 0.0)")
    right = text.index("p_joint right_joint")
    spoilt = text[:right] + text[right:].replace("(0.0, 0.0, 0.1654)", "(0.1654, 0.0, 0.0)")
    (finding,) = told(analyse(spoilt))
    assert finding.code == "KD510"
    assert text in [apply_edits(spoilt, fix.edits) for fix in finding.choices]


def star() -> str:
    """Return three numbered limbs whose first joints are at one place, each turned from another."""
    inertia = (
        "inertia_params { mass = 0.5 CoM = (0.08, 0.0, 0.01)"
        " Ix = 0.0008 Iy = 0.0041 Iz = 0.0041 Ixy = 0.0 Ixz = 0.0004 Iyz = 0.0 }"
    )
    links, joints, heads = "", "", ""
    for n, angle in enumerate((0.0, 2.094395, -2.094395)):
        heads += f"upper_{n} via shoulder_{n} "
        links += f"link upper_{n} {{ id = {2 * n + 1} children {{ lower_{n} via elbow_{n} }} }}\n"
        links += f"link lower_{n} {{ id = {2 * n + 2} {inertia} children {{ }} }}\n"
        for joint, place in (
            (f"shoulder_{n}", f"(0.0, 0.0, 0.29) rotation = (0.0, PI/2.0, {angle})"),
            (f"elbow_{n}", "(0.014, 0.02, 0.16) rotation = (0.0, 0.0, PI/2.0)"),
        ):
            joints += f"r_joint {joint} {{ ref_frame {{ translation = {place} }} }}\n"
    return f"Robot star {{\nRobotBase base {{ children {{ {heads}}} }}\n{links}{joints}}}\n"


@pytest.mark.parametrize("number", range(3))
def test_limbs_may_begin_at_one_place(number: int) -> None:
    text = star()
    assert told(analyse(text)) == []
    at = text.index("mass = 0.5", text.index(f"link lower_{number}"))
    spoilt = f"{text[:at]}mass = 0.4{text[at + 10 :]}"
    (finding,) = told(analyse(spoilt))
    assert finding.message == f"mass of 'lower_{number}' is 0.4, by its twins 0.5"
    assert finding.fix is not None
    assert apply_edits(spoilt, finding.fix.edits) == text


@pytest.mark.parametrize(("deep", "base"), [(3, (-0.3, 0.0, 0.0)), (30, (0.0, 0.0, 0.0))])
def test_the_base_is_nowhere_where_the_way_to_it_is_not_gone_to_its_end(
    deep: int, base: Vector3
) -> None:
    pose = "ref_frame { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }"
    names = ["spine0", *(f"spine{n}" for n in range(1, deep))]
    below = {names[-1]: ("left_arm", "right_arm"), **{a: (b,) for a, b in pairwise(names)}}
    listed = {a: " ".join(f"{b} via {b}_joint" for b in all_b) for a, all_b in below.items()}
    links = [*names, "left_arm", "right_arm"]
    text = "Robot R { RobotBase base { children { spine0 via spine0_joint } }\n" + "".join(
        f"link {name} {{ id = {n} children {{ {listed.get(name, '')} }} }}\n"
        f"r_joint {name}_joint {{ {pose} }}\n"
        for n, name in enumerate(links, 1)
    )
    model = analyse(text + "}").model
    ((_, (limbs,)),) = limbs_of(model, {}).items()
    assert limbs.base == pytest.approx(base)
