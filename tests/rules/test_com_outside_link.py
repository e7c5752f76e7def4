"""KD309 says what a link's length, its CoM and its radius of gyration say, in any direction."""

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.support.examples import joint, link, robot
from tests.support.one_rule import section, told, with_base

from kindsl.judgement.analysis.analysis import analyse
from kindsl.mechanics.rigid.body import MassDistribution, moments_of, shifted

DOCUMENT = """Robot R {{
RobotBase base {{ children {{ upper via shoulder }} }}
link upper {{ id = 1
    inertia_params {{ mass = 2.0 CoM = {com} {moments} }}
    children {{ hand via wrist }} }}
link hand {{ id = 2 children {{ }} }}
r_joint shoulder {{ ref_frame {{ translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }} }}
r_joint wrist {{ ref_frame {{ translation = {end} rotation = (0.0, 0.0, 0.0) }} }}
}}
"""
MASS = 2.0
NAMES = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")

directions = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: np.hypot(*v[:2]) > 0.1)
lengths = st.floats(-1.5, 0.0).map(lambda power: 10.0**power)
places = st.floats(-3.0, 0.5).map(lambda power: 10.0**power)
ratios = st.floats(-2.0, 2.0).map(lambda power: 10.0**power)


def document(end: np.ndarray, com: np.ndarray, radius: float) -> str:
    s = MASS * radius**2 / 3.0
    about_com = MassDistribution(MASS, tuple(com), moments_of((s, s, s, 0.0, 0.0, 0.0)))
    moments = zip(NAMES, shifted(about_com).moments, strict=True)
    return DOCUMENT.format(
        com=_triple(com), end=_triple(end), moments=" ".join(f"{n} = {v:.15f}" for n, v in moments)
    )


def _triple(vector: np.ndarray) -> str:
    return "({:.12f}, {:.12f}, {:.12f})".format(*vector)


def distance_to_link(com: np.ndarray, end: np.ndarray) -> float:
    shares = np.linspace(0.0, 1.0, 2001)
    return float(np.linalg.norm(com - shares[:, None] * end, axis=1).min())


@settings(max_examples=70, deadline=None, derandomize=True)
@given(directions, lengths, directions, places, ratios)
def test_the_mass_is_reported_where_the_link_is_not(
    along: tuple[float, ...], length: float, aside: tuple[float, ...], away: float, ratio: float
) -> None:
    end = length * np.array(along) / np.linalg.norm(along)
    com = away * np.array(aside) / np.linalg.norm(aside)
    distance, radius = distance_to_link(com, end), ratio * (length + away)
    far, wide = length + 3.0 * radius, 5.0 * (length + away)
    assume(abs(distance / far - 1.0) > 0.01 and abs(radius / wide - 1.0) > 0.01)
    found = analyse(document(end, com, radius)).findings
    told = [finding.message for finding in found if finding.code == "KD309"]
    if distance > far:
        assert len(told) == 1 and told[0].startswith("CoM of 'upper' lies ")
    elif radius > wide:
        is_light = any(f.code in ("KD308", "KD310", "KD311", "KD314") for f in found)
        expected = [] if is_light else ["radius of gyration of 'upper' is "]
        assert [message[: len("radius of gyration of 'upper' is ")] for message in told] == expected
    else:
        assert told == []


def arm_to(place: str, com: str, *moments: str, mass: str = "1.0") -> str:
    """Return an arm with its wrist at a place."""
    arm = link("arm", 1, "hand via wrist", section(mass, com, *moments))
    joints = joint("elbow"), joint("wrist").replace("0.0, 0.0, 0.3", place)
    return robot(arm, link("hand", 2), *joints, base="arm via elbow")


def turned(numbers: Sequence[str], turns: int) -> Sequence[str]:
    """Return what is along x, y and z after so many turns of x to y, y to z and z to x."""
    return [numbers[(axis - turns) % 3] for axis in range(3)]


FAR = "CoM of 'arm' lies {} m from a link 0.5 m long"
WIDE = "radius of gyration of 'arm' is {} m, the link is 0.5 m long"


@pytest.mark.parametrize(
    ("com", "moments", "message"),
    [
        ("2.0, 0.0, 0.0", ("0.0", "4.25", "4.25"), None),
        ("2.25, 0.0, 0.0", ("0.0", "5.3125", "5.3125"), FAR.format("2.25")),
        ("0.0, 0.0, -2.25", ("5.3125", "5.3125", "0.0"), FAR.format("2.25")),
        ("0.0, 0.0, 2.25", ("5.3125", "5.3125", "0.0"), None),
        ("0.0, 0.0, 2.75", ("7.8125", "7.8125", "0.0"), FAR.format("2.25")),
        ("2.25, 0.0, 0.25", ("0.0625", "5.375", "5.3125"), FAR.format("2.25")),
        ("0.5, 0.0, 0.0", ("0.0", "0.25", "0.25"), None),
        ("0.75, 0.0, 0.0", ("0.0", "0.5625", "0.5625"), FAR.format("0.75")),
        ("0.7, 0.0, 0.0", ("0.0", "0.49", "0.49"), FAR.format("0.7")),
        ("0.75, 0.0, 0.0", ("0.0", "0.0", "0.0"), None),
        ("0.75, 0.0, 0.0", ("0.0", "0.5", "0.5"), None),
        ("10.0, 0.0, 0.0", ("0.0", "100.25", "100.25"), FAR.format("10")),
        ("-10.0, 0.0, 0.0", ("0.0", "100.25", "100.25"), FAR.format("10")),
        ("10.25, 0.0, 0.0", ("0.0", "105.3125", "105.3125"), None),
        ("0.0, 0.0, 0.0", ("0.0", "6.25", "6.25"), None),
        ("0.0, 0.0, 0.0", ("0.0", "7.5625", "7.5625"), WIDE.format("2.75")),
        ("0.0, 0.0, 0.5", ("0.25", "7.8125", "7.5625"), None),
        ("0.0, 0.0, 0.5", ("0.25", "25.25", "25.0"), None),
        ("0.0, 0.0, 0.5", ("0.25", "30.5", "30.25"), WIDE.format("5.5")),
    ],
)
def test_the_mass_is_where_the_link_is(
    com: str, moments: tuple[str, ...], message: str | None
) -> None:
    """Of rods and points beside a link of half a metre: 0.5 m and three radii are far."""
    for turns in range(3):
        place = ", ".join(turned(("0.0", "0.0", "0.5"), turns))
        there = ", ".join(turned(com.split(", "), turns))
        for mass, expected in (("1.0", message), ("0.25", message), ("-2.0", None)):
            scaled = [f"{float(mass) * float(moment):.8f}" for moment in turned(moments, turns)]
            text = arm_to(place, there, *scaled, mass=mass)
            assert told("KD309", text) == ([] if expected is None else [expected])


@pytest.mark.parametrize("length", [0.05, 0.5, 5.0])
@pytest.mark.parametrize("mass", [0.25, 4.0])
def test_far_and_wide_are_multiples_of_the_length(length: float, mass: float) -> None:
    """A rod along x, five times as wide as the link is long; a point as far away."""
    for share, is_told in ((0.99, False), (1.01, True)):
        moment = f"{mass * (share * 5.0 * length) ** 2:.9f}"
        wide = arm_to(f"0.0, 0.0, {length}", "0.0, 0.0, 0.0", "0.0", moment, moment, mass=f"{mass}")
        assert bool(told("KD309", wide)) == is_told
        away = share * length
        moment = f"{mass * away**2:.9f}"
        far = arm_to(
            f"0.0, 0.0, {length}", f"{away}, 0.0, 0.0", "0.0", moment, moment, mass=f"{mass}"
        )
        assert bool(told("KD309", far)) == is_told


def framed(frames: str, frame: str = "", children: str = "", com: str = "0.0, 0.0, 5.0") -> str:
    moment = f"{float(com.split()[2]) ** 2 + 0.01:.6f}"
    given = section("1.0", com, moment, moment, "0.01")
    given = given.replace("}", f"ref_frame = {frame} }}") if frame else given
    arm = link("arm", 1, children, given).removesuffix("}\n")
    return f"{arm} frames {{ {frames} }} }}\n" if frames else f"{arm} }}\n"


def eye(name: str, place: str) -> str:
    return f"{name} {{ translation = ({place}) rotation = (0.0, 0.0, 0.0) }}"


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (framed(""), 0),
        (framed(eye("tip", "0.0, 0.0, 0.3")), 1),
        (framed(eye("tip", "0.0, 0.0, 0.0")), 0),
        (framed(eye("tip", "0.0, 0.0, 0.0") + eye("toe", "0.0, 0.0, 0.3")), 1),
        (framed(eye("tip", "0.0, 0.0, x") + eye("toe", "0.0, 0.0, 0.3")), 1),
        (framed(eye("tip", "0.0, 0.0, 4.8") + eye("toe", "0.0, 0.0, 0.3")), 0),
        (framed(eye("tip", "0.3, 0.0, 0.0"), "tip"), 1),
        (framed(eye("tip", "0.3, 0.0, 0.0"), "gone"), 0),
        (
            framed(
                eye("tip", "0.0, 0.0, -0.3") + eye("toe", "0.0, 0.0, 0.3"),
                "tip",
                com="0.0, 0.0, 0.3",
            ),
            0,
        ),
        (framed(eye("tip", "0.0, 0.0, x") + eye("toe", "0.0, 0.0, 0.3"), "tip"), 0),
        (robot(framed("", children="hand via lost"), link("hand", 2)), 0),
        (framed("", children="hand via wrist") + joint("wrist").replace("0.3", "x"), 0),
    ],
)
def test_the_link_is_where_its_frames_and_joints_are(text: str, count: int) -> None:
    assert len(told("KD309", text)) == count


@pytest.mark.parametrize(("word", "count"), [("", 0), ("floating", 1)])
def test_the_mass_of_a_fixed_base_is_anywhere(word: str, count: int) -> None:
    assert (
        len(
            told(
                "KD309", with_base(word, section("1.0", "0.0, 0.0, 5.0", "25.01", "25.01", "0.01"))
            )
        )
        == count
    )


@pytest.mark.parametrize(("com", "count"), [("0.0, 0.0, -0.9", 0), ("0.0, 0.0, 0.36", 1)])
def test_an_inertia_is_in_the_frame_that_it_names(com: str, count: int) -> None:
    """Of two frames, at the wrist and aside from it."""
    square = float(com.split()[2]) ** 2
    moments = f"{square + 0.0001:.6f}", f"{square + 0.0001:.6f}", "0.0001"
    given = section("1.0", com, *moments).replace("}", "ref_frame = tip }")
    frames = eye("toe", "0.0, 0.0, -0.3") + eye("tip", "0.0, 0.0, 0.3")
    arm = link("arm", 1, "", given).removesuffix("}\n") + f" frames {{ {frames} }} }}\n"
    assert len(told("KD309", arm)) == count


@pytest.mark.parametrize(
    ("com", "radius", "of_arm", "of_rail"),
    [(0.4, 0.01, "CoM", "CoM"), (0.0, 0.2, "radius", ""), (0.02, 0.01, "", "")],
)
def test_a_rail_is_as_long_as_its_slide_goes(
    com: float, radius: float, of_arm: str, of_rail: str
) -> None:
    text = document(np.array([0.03, 0.0, 0.0]), np.array([com, 0.0, 0.0]), radius)
    for kind, expected in (("r_joint", of_arm), ("p_joint", of_rail)):
        found = analyse(text.replace("r_joint wrist", f"{kind} wrist")).findings
        told = "".join(each.message for each in found if each.code == "KD309")
        assert told.startswith(expected) and bool(told) == bool(expected)
