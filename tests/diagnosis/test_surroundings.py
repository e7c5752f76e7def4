"""What the places of joints and frames, and links of the same part, say of a link's inertia."""

from math import sqrt

import pytest
from tests.support.bodies import document_of_bodies
from tests.support.one_rule import row

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.diagnosis.evidence import MassShape
from kindsl.judgement.diagnosis.slips import Hypothesis, Slip
from kindsl.judgement.diagnosis.surroundings import (
    LinkSurroundings,
    is_mirror_image,
    is_same_body,
    reasons_of_end,
    same_moments,
    surroundings,
)
from kindsl.judgement.diagnosis.suspects import suspects_of
from kindsl.language.semantics.parameters import Binding
from kindsl.mechanics.rigid.body import MassDistribution, Symmetric, eigensystem
from kindsl.mechanics.rigid.pose import Vector3

EXACT: Symmetric = (0.0,) * 6  # type: ignore[assignment]
BODY = MassDistribution(1.0, (0.3, 0.2, 0.1), (5.0, 4.0, 3.0, 0.3, 0.2, 0.1))
SECTION = "inertia_params { mass = %s CoM = (0.0, 0.0, 0.0) Ix=0.10 Iy=0.10 Iz=%s"
SECTION += " Ixy=0.0 Ixz=0.0 Iyz=0.0 }"
WRONG, RIGHT = SECTION % ("1.0", "0.30"), SECTION % ("1.0", "0.10")


def said(
    second_moments: Vector3, *points: Vector3, slip: Slip = Slip.SIGNS, com: Vector3 = (0.0,) * 3
) -> tuple[str, ...]:
    """Return what points say in words of a body with these second moments along its axes."""
    matrix = (*second_moments, 0.0, 0.0, 0.0)
    shape = MassShape(matrix, EXACT, eigensystem(matrix))
    h = Hypothesis((slip,), BODY._replace(com=com), BODY, 1.0)
    return tuple(reasons_of_end(h, shape, LinkSurroundings(points, peers=()).end))


LONG = "long towards its next joint"
ACROSS = "though then long across its link"
AHEAD = "CoM on the side of its next joint"


@pytest.mark.parametrize(
    ("second_moments", "points", "reasons"),
    [
        ((1.0, 0.1, 0.1), [], ()),
        ((1.0, 0.1, 0.1), [(0.3, 0.0, 0.0)], (LONG,)),
        ((1.0, 0.1, 0.1), [(-0.3, 0.0, 0.0)], (LONG,)),
        ((1.0, 0.1, 0.1), [(0.0, 0.3, 0.0)], (ACROSS,)),
        # The farthest one counts.
        ((1.0, 0.1, 0.1), [(0.0, 0.3, 0.0), (0.4, 0.0, 0.0)], (LONG,)),
        ((1.0, 0.1, 0.1), [(0.0, 0.3, 0.3), (0.4, 0.0, 0.0)], (ACROSS,)),
        # Towards it is within 32 degrees, whose cosine is 0.85.
        ((1.0, 0.1, 0.1), [(0.86, 0.0, -sqrt(1.0 - 0.86**2))], (LONG,)),
        ((1.0, 0.1, 0.1), [(0.84, 0.0, -sqrt(1.0 - 0.84**2))], ()),
        ((0.1, 1.0, 0.1), [(0.0, 0.086, sqrt(1.0 - 0.86**2) / 10.0)], (LONG,)),
        # Long is what has two and a half times the next second moment.
        ((2.6, 1.0, 0.1), [(0.3, 0.0, 0.0)], (LONG,)),
        ((2.4, 1.0, 0.1), [(0.3, 0.0, 0.0)], ()),
        ((1.0, -1.0, -0.1), [(0.3, 0.0, 0.0)], (LONG,)),
        ((0.0, -1.0, -0.1), [(0.3, 0.0, 0.0)], ()),
    ],
)
def test_links_are_long_towards_their_joints(
    second_moments: Vector3, points: list[Vector3], reasons: tuple[str, ...]
) -> None:
    assert said(second_moments, *points) == reasons


@pytest.mark.parametrize(
    ("com", "reasons"),
    [
        ((0.1, 0.0, 0.0), (AHEAD,)),
        ((0.1, -0.05, 0.0), (AHEAD,)),
        ((0.1, -0.2, 0.0), ()),
        ((0.1, -0.1, 0.5), ()),
        ((-0.1, 0.0, 0.0), ()),
    ],
)
def test_a_com_is_mostly_on_the_side_of_the_next_joint(
    com: Vector3, reasons: tuple[str, ...]
) -> None:
    ball = (1.0, 1.0, 1.0)
    point = (0.3, 0.3, 0.0)
    assert said(ball, point, slip=Slip.COM_SIGN, com=com) == reasons
    assert said(ball, point, slip=Slip.SIGNS, com=com) == ()
    rod = said((1.0, 0.1, 0.1), (0.3, 0.1, 0.0), slip=Slip.COM_SIGN, com=(0.1, 0.0, 0.0))
    assert rod == (LONG, AHEAD)


def changed(place: int, change: float) -> MassDistribution:
    """Return the body with one of its ten numbers changed."""
    ten = [BODY.mass, *BODY.com, *BODY.moments]
    ten[place] += change
    mass, x, y, z, *moments = ten
    return MassDistribution(mass, (x, y, z), tuple(moments))  # type: ignore[arg-type]


@pytest.mark.parametrize("place", range(10))
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_bodies_are_the_same_within_a_fiftieth_of_the_greatest_number(
    place: int, sign: float
) -> None:
    greatest = 1.0 if place == 0 else 0.3 if place < 4 else 5.0
    near, far = (changed(place, sign * share * greatest) for share in (0.0195, 0.0205))
    assert is_same_body(BODY, near) and is_same_body(near, BODY)
    assert not is_same_body(BODY, far) and not is_same_body(far, BODY)


def test_a_fiftieth_is_near() -> None:
    assert is_same_body(BODY._replace(mass=50.0), BODY._replace(mass=49.0))


@pytest.mark.parametrize("x", [1.0, -1.0])
@pytest.mark.parametrize("y", [1.0, -1.0])
@pytest.mark.parametrize("z", [1.0, -1.0])
def test_a_mirror_image_has_some_axes_reversed(x: float, y: float, z: float) -> None:
    a, b, c = BODY.com
    *plain, xy, xz, yz = BODY.moments
    moments = (*plain, x * y * xy, x * z * xz, y * z * yz)
    image = MassDistribution(BODY.mass, (x * a, y * b, z * c), moments)  # type: ignore[arg-type]
    assert is_mirror_image(BODY, image)
    assert is_same_body(BODY, image) == (x == y == z == 1.0)
    for place in range(1, 10):
        ten = [image.mass, *image.com, *image.moments]
        assert not is_mirror_image(BODY, negated(ten, place))


def negated(ten: list[float], place: int) -> MassDistribution:
    mass, x, y, z, *moments = (-v if n == place else v for n, v in enumerate(ten))
    return MassDistribution(mass, (x, y, z), tuple(moments))  # type: ignore[arg-type]


def around(text: str, **values: float) -> LinkSurroundings:
    """Return what is known of the first link that needs an explanation."""
    bindings = {name: Binding(value) for name, value in values.items()}
    analysis = analyse(text, Settings(bindings=bindings))
    found = suspects_of(analysis.model, analysis.context.values)[0]
    return surroundings(analysis.model, analysis.context.values, found)


POSE = "{ translation = (%s) rotation = (0.0, 0.0, 0.0) }"
ARM = f"""Robot Arm {{
RobotBase ground {{ children {{ arm via shoulder }} }}
link arm {{ id = 1 {WRONG} children {{ hand via wrist }} frames {{ tool {POSE} other {POSE} }} }}
link hand {{ id = 2 children {{}} }}
r_joint shoulder {{ ref_frame {POSE % "0.5, 0.0, 0.0"} }}
r_joint wrist {{ ref_frame {POSE} }}
}}
"""


def test_points_are_those_of_frames_and_of_the_next_joints() -> None:
    found = around(ARM % ("0.0, 0.0, 0.3", "0.1, 0.0, 0.0", "0.0, 0.2, 0.0"))
    assert found.points == ((0.0, 0.0, 0.3), (0.1, 0.0, 0.0), (0.0, 0.2, 0.0))
    assert found.end == (0.0, 0.0, 0.3)


def test_a_joint_that_does_not_exist_is_nowhere() -> None:
    text = ARM % ("0.0, 0.0, 0.3", "0.1, 0.0, 0.0", "0.0, 0.2, 0.0")
    found = around(text.replace("hand via wrist", "hand via wirst"))
    assert found.points == ((0.0, 0.0, 0.3), (0.1, 0.0, 0.0))


def test_points_near_the_origin_say_nothing() -> None:
    found = around(ARM % ("0.0, 0.0, 0.021", "0.012, 0.012, 0.0", "0.0, 0.019, 0.0"))
    assert found.points == ((0.0, 0.0, 0.021),)


def test_points_may_depend_on_parameters() -> None:
    text = ARM % ("0.0, 0.0, reach", "0.1, 0.0, 0.0", "0.0, far, 0.0")
    assert around(text, reach=0.7).points == ((0.0, 0.0, 0.7), (0.1, 0.0, 0.0))


def test_points_are_not_compared_with_an_inertia_in_another_frame() -> None:
    text = ARM % ("0.0, 0.0, 0.3", "0.1, 0.0, 0.0", "0.0, 0.2, 0.0")
    assert around(text.replace("Iyz=0.0 }", "Iyz=0.0 ref_frame = tool }")).points == ()


def legs(**sections: str) -> str:
    """Return a star of links with these names and inertias."""
    text = document_of_bodies(list(sections.values()))
    for number, name in reversed(list(enumerate(sections, 1))):
        text = text.replace(f"body{number} ", f"{name} ")
    return text


@pytest.mark.parametrize(
    ("sections", "peers"),
    [
        ({"left_leg": WRONG, "right_leg": RIGHT}, ["right_leg"]),
        ({"right_leg": WRONG, "left_leg": RIGHT}, ["left_leg"]),
        ({"LF_leg": WRONG, "LH_leg": RIGHT, "RF_leg": RIGHT}, ["LH_leg", "RF_leg"]),
        ({"left_leg": WRONG, "right_arm": RIGHT}, []),
        ({"left_leg": WRONG, "right_leg": WRONG}, []),
        # Links of the same part are peers if they are possible, and of the same mass but for tens.
        (
            {"LF_leg": WRONG, "RF_leg": WRONG, "LH_leg": RIGHT, "RH_leg": RIGHT},
            ["LH_leg", "RH_leg"],
        ),
        ({"LF_leg": WRONG, "LH_leg": RIGHT, "RH_leg": SECTION % ("1.03", "0.10")}, ["LH_leg"]),
        (
            {"LF_leg": WRONG, "LH_leg": RIGHT, "RH_leg": SECTION % ("0.99", "0.10")},
            ["LH_leg", "RH_leg"],
        ),
        ({"leg1": SECTION % ("50.0", "0.30"), "leg2": SECTION % ("49.0", "0.10")}, ["leg2"]),
        ({"leg1": SECTION % ("2.0", "0.30"), "leg2": SECTION % ("2.03", "0.10")}, ["leg2"]),
        ({"left_leg": WRONG, "right_leg": RIGHT.replace("1.0", "unbound")}, []),
        # Of very many only the first eight are seen.
        (
            {"leg1": WRONG, **{f"leg{n}": RIGHT for n in range(2, 12)}},
            [f"leg{n}" for n in range(2, 9)],
        ),
    ],
)
def test_peers_are_possible_links_of_the_same_part_and_mass(
    sections: dict[str, str], peers: list[str]
) -> None:
    found = around(legs(**sections))
    assert [peer.name for peer in found.peers] == peers


@pytest.mark.parametrize(
    ("mine", "others", "is_expected"),
    [("", "", True), ("ref_frame = f ", "", False), ("", "ref_frame = f ", False)],
)
def test_a_peer_expects_nothing_in_another_frame(mine: str, others: str, is_expected: bool) -> None:
    """The joints are one above the other, so that one leg is a copy of the other."""
    one, other = (
        text.replace("Iyz=0.0 }", f"Iyz=0.0 {frame}}}")
        for text, frame in ((WRONG, mine), (RIGHT, others))
    )
    (peer,) = around(legs(leg1=one, leg2=other)).peers
    assert peer.expected == (peer.body if is_expected else None)


def test_a_peer_that_nothing_is_known_of_is_none() -> None:
    text = legs(left_leg=WRONG, right_leg=RIGHT, L_leg="")
    assert [peer.name for peer in around(text).peers] == ["right_leg"]


def test_nameless_links_are_of_no_part() -> None:
    assert around(legs(left=WRONG, right=RIGHT)).peers == ()


def test_the_part_of_the_same_number_is_the_peer_in_a_chain() -> None:
    """Of an arm of many numbered links not the first eight, but the one on the other side."""
    names = " ".join(f"{side}_arm_{n}" for side in ("left", "right") for n in range(1, 8))
    numbers = [SECTION % (f"{2.0 + 0.1 * n:.1f}", "0.10") for n in range(1, 8)]
    sections = [*numbers[:-1], numbers[-1].replace("Iz=0.10", "Iz=0.30"), *numbers]
    analysis = analyse(row(*sections, names=names))
    (found,) = suspects_of(analysis.model, analysis.context.values)
    around = surroundings(analysis.model, analysis.context.values, found)
    assert [peer.name for peer in around.peers] == ["right_arm_7"]


@pytest.mark.parametrize("moment", ["1.0e999", "1.7e308"])  # robcogen2 reads the first as inf
def test_a_moment_beyond_all_numbers_is_a_copy_of_none(moment: str) -> None:
    told = "inertia_params { mass = 7.8261 CoM = (-0.0491, 0.1772, -0.1023) Ix = %s Iy = %s"
    told += " Iz = 0.367571 Ixy = -0.067875 Ixz = 0.039114 Iyz = -0.141291 }"
    texts = [told % ("0.1234567", "0.0419"), told % (moment, moment)]
    assert analyse(document_of_bodies(texts), Settings(frozenset({"robcogen2"}))).faults == ()


def test_of_equal_moments_those_of_another_part_are_copied() -> None:
    """A head has the left arm's: its own are unlike those of the other head, an arm's are not."""
    own, copied = (
        f"inertia_params {{ mass = 1.0 CoM = ({com}) Ix={moment}013 Iy={moment}217 Iz={moment}335"
        " Ixy=0.0 Ixz=0.0 Iyz=0.0 }"
        for com, moment in (("0.0123, 0.0456, 0.0789", "0.02"), ("0.0321, 0.0654, 0.0987", "0.03"))
    )
    same_com = copied.replace("0.0321, 0.0654, 0.0987", "0.0123, 0.0456, 0.0789")
    arms = {"left_arm": copied, "right_arm": copied}
    model = analyse(legs(**arms, front_head=same_com, rear_head=own)).model
    copies = {
        name: [*same_moments(model, model.body_named[name])] for name in (*arms, "front_head")
    }
    assert copies["front_head"] == ["left_arm", "right_arm"]
    assert copies["left_arm"] == []
    # That a part has another's CoM alone says nothing of its moments.
    assert [*same_moments(model, model.body_named["rear_head"])] == []
