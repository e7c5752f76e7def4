"""Twins of a link, told by where the joints are."""

import random
import re
from collections.abc import Callable

import pytest
from tests.support.amount import usually
from tests.support.bodies import significant
from tests.support.legged import COPIED, REFLECTED, SIDES, Legs, Walker

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.diagnosis.surroundings import is_same_body
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.text.edits import apply_edits
from kindsl.mechanics.rigid.body import MassDistribution, shifted
from kindsl.mechanics.rigid.pose import Rotation, Vector3
from kindsl.robots.limbs.peer_frames import peer_frames

CAUSES = ("KD306", "KD307", "KD308")
INERTIA = Settings(select=("KD301", "KD302", *CAUSES))
EXACT = significant(9)
N_WALKERS = usually(20, thoroughly=40)
Slip = Callable[[MassDistribution], MassDistribution]


def negated(*chosen: int) -> Slip:
    def plant(body: MassDistribution) -> MassDistribution:
        moments = tuple(-m if i in chosen else m for i, m in enumerate(body.moments))
        return body._replace(moments=moments)

    return plant


def other_side(axis: int) -> Slip:
    def plant(body: MassDistribution) -> MassDistribution:
        x, y, z = (-c if i == axis else c for i, c in enumerate(body.com))
        return body._replace(com=(x, y, z))

    return plant


def about_com(body: MassDistribution) -> MassDistribution:
    return shifted(body, -1.0)


SLIPS = {
    **{f"sign of the CoM's {axis}": other_side(i) for i, axis in enumerate("xyz")},
    **{f"sign of I{axes}": negated(3 + i) for i, axes in enumerate(("xy", "xz", "yz"))},
    "signs of all products": negated(3, 4, 5),
    "about the CoM": about_com,
}


def diagonals(found: list[Rotation]) -> list[Vector3]:
    """Return the signs of the axes, where axes are not exchanged."""
    return [(C[0][0], C[1][1], C[2][2]) for C in found]


def model_of(walker: Walker) -> Model:
    return analyse(walker.document(walker.bodies, EXACT)).model


@pytest.mark.parametrize("legs", [SIDES, REFLECTED])
@pytest.mark.parametrize("seed", range(20))
def test_joints_tell_which_axes_of_a_peer_are_reversed(legs: Legs, seed: int) -> None:
    walker = Walker(random.Random(seed), legs)
    model = model_of(walker)
    for one, mine in walker.signs.items():
        for other, others in walker.signs.items():
            if one != other and one.split("_")[1] == other.split("_")[1]:
                links = model.body_named[one], model.body_named[other]
                expected = tuple(a * b for a, b in zip(mine, others, strict=True))
                assert diagonals(peer_frames(model.tree, *links, {}))[0] == expected


POSE = "ref_frame { translation = (%s) rotation = (%s) }"
HIPS = """Robot Biped {
RobotBase trunk { children { left via left_hip right via right_hip } }
link left { id = 1 children { foot via ankle } }
link right { id = 2 children { } }
link foot { id = 3 children { } }
r_joint left_hip { ref_frame { translation = (%s) rotation = (%s) } }
r_joint right_hip { ref_frame { translation = (%s) rotation = (%s) } }
r_joint ankle { ref_frame { translation = (0.0, 0.0, 0.4) rotation = (0.0, 0.0, 0.0) } }
}
"""
QUARTER = "PI/2.0, 0.0, 0.0"
STRAIGHT = "0.0, 0.0, 0.0"


def signs_of(text: str, one: str, other: str, **values: float) -> list[Vector3]:
    model = analyse(text).model
    links = model.body_named[one], model.body_named[other]
    return diagonals(peer_frames(model.tree, *links, values))


@pytest.mark.parametrize(
    ("left", "right", "signs"),
    [
        # Hips on the y-axis may be reflected in y or turned half round x or z; y changes least.
        (("0.0, 0.1, 0.0", STRAIGHT), ("0.0, -0.1, 0.0", STRAIGHT), (1.0, -1.0, 1.0)),
        # The frame's z is the trunk's -y after a quarter turn about x.
        (("0.0, 0.1, 0.0", QUARTER), ("0.0, -0.1, 0.0", QUARTER), (1.0, 1.0, -1.0)),
        # Within two per cent of the distance; without, the right leg is moved along y.
        (("0.0, 0.1, 0.0", STRAIGHT), ("0.0, -0.1015, 0.0", STRAIGHT), (1.0, -1.0, 1.0)),
        (("0.0, 0.1, 0.0", STRAIGHT), ("0.0, -0.103, 0.0", STRAIGHT), (1.0, 1.0, 1.0)),
        # A hind leg that is a copy.
        (("0.4, 0.1, 0.0", STRAIGHT), ("-0.3, 0.1, 0.0", STRAIGHT), (1.0, 1.0, 1.0)),
        # Height is the same within two per cent of 0.37 m, or it is moved along two axes.
        (("0.4, 0.1, 0.2", STRAIGHT), ("-0.3, 0.1, 0.207", STRAIGHT), (1.0, 1.0, 1.0)),
        (("0.4, 0.1, 0.2", STRAIGHT), ("-0.3, 0.1, 0.22", STRAIGHT), None),
        # One that is reflected and moved.
        (("0.4, 0.1, 0.2", STRAIGHT), ("-0.3, -0.1, 0.2", STRAIGHT), (1.0, -1.0, 1.0)),
        # Axes that are neither kept nor reversed, though the joints are at mirrored places.
        (("0.4, 0.1, 0.2", STRAIGHT), ("0.4, -0.1, 0.2", "0.0, 0.5, 0.0"), None),
        # Moved along two axes.
        (("0.4, 0.1, 0.2", STRAIGHT), ("-0.3, 0.3, 0.2", STRAIGHT), None),
        # At one place nothing is reflected.
        (("0.0, 0.1, 0.0", STRAIGHT), ("0.0, 0.1, 0.0", STRAIGHT), None),
        (("0.2, 0.1, 0.3", STRAIGHT), ("0.2, 0.1, 0.3", STRAIGHT), None),
        # A place that is not known.
        (("0.0, 0.1, 0.0", STRAIGHT), ("0.0, -hip, 0.0", STRAIGHT), None),
    ],
)
def test_joints_anywhere(
    left: tuple[str, str], right: tuple[str, str], signs: Vector3 | None
) -> None:
    found = signs_of(HIPS % (*left, *right), "left", "right")
    assert found[:1] == [signs] * (signs is not None)


def test_values_of_parameters_place_a_peer() -> None:
    text = HIPS % ("0.0, hip, 0.0", STRAIGHT, "0.0, -hip, 0.0", STRAIGHT)
    assert signs_of(text, "left", "right", hip=0.2)[0] == (1.0, -1.0, 1.0)


@pytest.mark.parametrize(("one", "other"), [("left", "foot"), ("foot", "left"), ("foot", "right")])
def test_a_link_is_no_peer_of_what_lies_deeper(one: str, other: str) -> None:
    text = HIPS % ("0.0, 0.1, 0.0", STRAIGHT, "0.0, -0.1, 0.0", STRAIGHT)
    assert signs_of(text, one, other) == []


def test_a_loop_has_no_peers() -> None:
    text = HIPS % ("0.0, 0.1, 0.0", STRAIGHT, "0.0, -0.1, 0.0", STRAIGHT)
    text = text.replace("left via left_hip ", "")
    text = text.replace("id = 3 children { }", "id = 3 children { left via left_hip }")
    assert signs_of(text, "left", "right") == []


@pytest.mark.parametrize(("height", "is_peer"), [("0.4", True), ("0.407", True), ("0.41", False)])
def test_peers_lie_alike_in_all_that_carries_them(height: str, is_peer: bool) -> None:
    text = HIPS % ("0.0, 0.1, 0.0", STRAIGHT, "0.0, -0.1, 0.0", STRAIGHT)
    text = text.replace("id = 2 children { }", "id = 2 children { toes via heel }")
    pose = POSE % (f"0.0, 0.0, {height}", STRAIGHT)
    more = f"link toes {{ id = 4 children {{ }} }}\nr_joint heel {{ {pose} }}\n}}\n"
    text = f"{text.rstrip().removesuffix('}')}{more}"
    assert bool(signs_of(text, "foot", "toes")) == is_peer


def test_what_no_joint_places_has_no_peer() -> None:
    text = HIPS % ("0.0, 0.1, 0.0", STRAIGHT, "0.0, -0.1, 0.0", STRAIGHT)
    assert signs_of(text.replace("via right_hip", "via hip"), "left", "right") == []


def fixed_bodies(text: str, victim: str) -> list[MassDistribution]:
    """Return the inertia of a link after each fix that its document is offered."""
    fixes = [f.fix for f in analyse(text, INERTIA).findings if f.code in CAUSES]
    models = [analyse(apply_edits(text, fix.edits)).model for fix in fixes if fix is not None]
    inertias = [model.body_named[victim].inertia for model in models]
    bodies = [mass_distribution(inertia, {}) for inertia in inertias if inertia is not None]
    return [body for body in bodies if body is not None]


# Usually each slip in one kind of legs.
@pytest.mark.parametrize(
    ("legs", "slip"),
    [
        (legs, slip)
        for n, legs in enumerate((COPIED, SIDES, REFLECTED))
        for slip in [*SLIPS][usually(n, 0) :: usually(3, 1)]
    ],
)
def test_a_fix_makes_a_link_its_peers_mirror_image(legs: Legs, slip: str) -> None:
    generator = random.Random(f"{slip} of one in {len(legs)}")
    n_told = n_fixed = 0
    for _ in range(N_WALKERS):
        walker, write = Walker(generator, legs), significant(generator.randrange(3, 7))
        if analyse(walker.document(walker.bodies, write), INERTIA).findings:
            continue
        victim = generator.choice(list(walker.bodies))
        meant = walker.bodies[victim]
        text = walker.document({**walker.bodies, victim: SLIPS[slip](meant)}, write)
        n_told += bool(analyse(text, INERTIA).findings)
        for fixed in fixed_bodies(text, victim):
            assert is_same_body(fixed, meant)
            n_fixed += 1
    assert n_told >= 0.375 * N_WALKERS
    assert n_fixed >= 0.4 * n_told


IN_A_FRAME = (
    r"link \1 \2 ref_frame = \1_own } children {\3}"
    r" frames { \1_own { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }"
)


@pytest.mark.parametrize("legs", [SIDES, REFLECTED, COPIED])
@pytest.mark.parametrize("slip", ["sign of the CoM's y", "sign of Ixz", "signs of all products"])
def test_peers_that_lie_anyhow_make_no_wrong_fix(legs: Legs, slip: str) -> None:
    """An inertia in a frame of its own has axes of which the joints tell nothing."""
    generator = random.Random(f"{slip} in a frame")
    for _ in range(N_WALKERS):
        walker, write = Walker(generator, legs), significant(generator.randrange(3, 7))
        victim = generator.choice(list(walker.bodies))
        meant = walker.bodies[victim]
        text = walker.document({**walker.bodies, victim: SLIPS[slip](meant)}, write)
        text, count = re.subn(r"link (\w+) (.*Iyz=\S+) \} children \{(.*)\} \}", IN_A_FRAME, text)
        assert count == len(walker.bodies)
        for fixed in fixed_bodies(text, victim):
            assert is_same_body(fixed, meant)


LEG = """link {side}_hip {{ id = {hip} children {{ {side}_leg via {side}_knee }} }}
link {side}_leg {{ id = {leg}
    inertia_params {{ mass = 2.16 CoM = (0.148, {y}, 0.0)
        Ix=0.004785 Iy=0.076166 Iz=0.078576 Ixy={xy} Ixz=0.0 Iyz=0.0 }}
    children {{}} }}
r_joint {side}_knee {{
    ref_frame {{ translation = (0.1, 0.0, 0.0) rotation = ({bend}, 0.0, 0.0) }} }}
r_joint {side} {{ ref_frame {{ translation = ({place}, 0.0) rotation = ({down}) }} }}
"""
LEFT = {"down": "0.0, -PI/2.0, PI", "bend": "PI/2.0"}
RIGHT = {"down": "0.0, PI/2.0, 0.0", "bend": "-PI/2.0"}


def test_three_wrong_legs_may_be_wrong_in_two_ways() -> None:
    """They fit the fourth if their CoMs are wrong, or if it is the mirror image of a leg."""
    legs = (
        LEG.format(side="LF", hip=1, leg=2, y="-0.03", xy="0.0072", place="0.4, 0.2", **LEFT),
        LEG.format(side="RF", hip=3, leg=4, y="-0.03", xy="0.0072", place="0.4, -0.2", **RIGHT),
        LEG.format(side="LH", hip=5, leg=6, y="0.03", xy="-0.0072", place="-0.4, 0.2", **LEFT),
        LEG.format(side="RH", hip=7, leg=8, y="-0.03", xy="-0.0072", place="-0.4, -0.2", **RIGHT),
    )
    hips = " ".join(f"{side}_hip via {side}" for side in REFLECTED)
    text = f"Robot Dog {{ RobotBase trunk {{ children {{ {hips} }} }}\n{''.join(legs)}}}\n"
    told = [f for f in analyse(text, INERTIA).findings if f.code in CAUSES]
    assert len(told) == 3
    for finding in told:
        assert finding.fix is None
        said = " ".join((finding.message, *(related.message for related in finding.related)))
        assert "y of the CoM" in said
        assert "sign of Ixy" in said
