"""What names tell of wrong parents and exchanged joints."""

from itertools import pairwise

import pytest

from kindsl.robots.limbs.attachments import Attachment, LimbNames

LEGS = ("LF", "RF", "LH", "RH")


def legs(*changes: tuple[str, str, str], names: tuple[str, ...] = LEGS) -> tuple[Attachment, ...]:
    """Return legs of hip, thigh and shank; changes are link, parent and joint."""
    made = {}
    for leg in names:
        parts = [f"{leg}_{part}" for part in ("hip", "thigh", "shank")]
        carriers = ["trunk", *parts[:2]]
        joints = [f"{leg}_{joint}" for joint in ("HAA", "HFE", "KFE")]
        for link, parent, joint in zip(parts, carriers, joints, strict=True):
            made[link] = Attachment(link, parent, joint)
    return tuple((made | {link: Attachment(link, *rest) for link, *rest in changes}).values())


def misplaced(*attachments: Attachment) -> tuple[list[object], list[object]]:
    names = LimbNames(attachments)
    return (
        [(each.attachment.link, each.meant) for each in names.elsewhere],
        [(each.attachment.link, each.meant) for each in names.crossed],
    )


@pytest.mark.parametrize(
    ("changes", "elsewhere", "crossed"),
    [
        ((), [], []),
        ([("RF_shank", "LF_thigh", "RF_KFE")], [("RF_shank", "RF_thigh")], []),
        ([("RF_shank", "trunk", "RF_KFE")], [("RF_shank", "RF_thigh")], []),
        ([("RF_shank", "RF_hip", "RF_KFE")], [("RF_shank", "RF_thigh")], []),
        (
            [("RF_shank", "RF_thigh", "RF_HFE"), ("RF_thigh", "RF_hip", "RF_KFE")],
            [],
            [("RF_thigh", "RF_HFE"), ("RF_shank", "RF_KFE")],
        ),
        (
            [("RF_shank", "RF_thigh", "LF_KFE"), ("LF_shank", "LF_thigh", "RF_KFE")],
            [],
            [("LF_shank", "LF_KFE"), ("RF_shank", "RF_KFE")],
        ),
        # Who attaches many things so means it.
        ([(f"{leg}_shank", "trunk", f"{leg}_KFE") for leg in ("LF", "RF")], [], []),
        ([(f"{leg}_shank", "LF_thigh", f"{leg}_KFE") for leg in LEGS], [], []),
    ],
)
def test_links_that_are_not_attached_as_their_peers(
    changes: list[tuple[str, str, str]], elsewhere: list[object], crossed: list[object]
) -> None:
    assert misplaced(*legs(*changes)) == (elsewhere, crossed)


@pytest.mark.parametrize(
    ("exchanged", "crossed"),
    [
        # Each has the joint of the other side.
        (("LF_shank", "RF_shank"), [("LF_shank", "LF_KFE"), ("RF_shank", "RF_KFE")]),
        # One of two sides has its joints exchanged, nothing says which.
        (
            ("RF_thigh", "RF_shank"),
            [
                *(("LF_thigh", "LF_KFE"), ("RF_thigh", "RF_HFE")),
                *(("LF_shank", "LF_HFE"), ("RF_shank", "RF_KFE")),
            ],
        ),
    ],
)
def test_joints_of_two_legs_that_are_exchanged(
    exchanged: tuple[str, str], crossed: list[object]
) -> None:
    made = {each.link: each for each in legs(names=("LF", "RF"))}
    one, other = (made[link] for link in exchanged)
    made |= {one.link: one._replace(joint=other.joint), other.link: other._replace(joint=one.joint)}
    assert misplaced(*made.values()) == ([], crossed)


def test_of_two_sides_that_is_wrong_whose_joints_are_not_called_as_their_links() -> None:
    arms = [
        Attachment(
            f"{side}_{link}", f"{side}_{above}" if above else "trunk", f"{side}_{link}_joint"
        )
        for side in ("left", "right")
        for above, link in pairwise(("", "shoulder", "upper_arm", "elbow"))
    ]
    joints = [arms[1].joint, arms[0].joint, *(arm.joint for arm in arms[2:])]
    arms = [arm._replace(joint=joint) for arm, joint in zip(arms, joints, strict=True)]
    told = [("left_shoulder", "left_shoulder_joint"), ("left_upper_arm", "left_upper_arm_joint")]
    assert misplaced(*arms) == ([], told)


@pytest.mark.parametrize(
    ("change", "elsewhere"),
    [
        (("RF_shank", "RF_hip", "RF_KFE"), [("LF_shank", "LF_hip"), ("RF_shank", "RF_thigh")]),
        (("RF_thigh", "trunk", "RF_HFE"), [("LF_thigh", "trunk"), ("RF_thigh", "RF_hip")]),
        # The other side has no such body.
        (("RF_shank", "RF_tail", "RF_KFE"), []),
    ],
)
def test_of_a_left_and_a_right_link_either_may_be_misplaced(
    change: tuple[str, str, str], elsewhere: list[object]
) -> None:
    extra = Attachment("RF_tail", "trunk", "tail")
    assert misplaced(*legs(change, names=("LF", "RF")), extra) == (elsewhere, [])


def test_wheels_on_the_front_and_the_rear_of_one_chain() -> None:
    """Three of four are on the rear: the one that is called front is wrong, not the fourth."""
    chain = [Attachment("front_frame", "rear_frame", "hinge")]
    rows = [f"{row}_{side}" for row in ("front", "rear") for side in ("left", "right")]
    wheels = [Attachment(f"{n}_wheel", f"{n.split('_')[0]}_frame", f"{n}_axle") for n in rows]
    assert misplaced(*chain, *wheels) == ([], [])
    wheels[1] = wheels[1]._replace(parent="rear_frame")
    assert misplaced(*chain, *wheels) == ([("front_right_wheel", "front_frame")], [])


@pytest.mark.parametrize("carrier", ["head", "front_mast"])
def test_a_front_and_a_rear_part_need_not_be_alike(carrier: str) -> None:
    names = ("front", "rear")
    masts = [Attachment(f"{n}_mast", "trunk", f"{n}_fix") for n in names]
    cameras = [
        Attachment("front_camera", carrier, "front_pan"),
        Attachment("rear_camera", "trunk", "rear_pan"),
    ]
    assert misplaced(*masts, *cameras) == ([], [])


def test_numbered_limbs() -> None:
    names = ("leg1", "leg2", "leg3")
    assert misplaced(*legs(names=names)) == ([], [])
    changed = legs(("leg2_shank", "leg1_thigh", "leg2_KFE"), names=names)
    assert misplaced(*changed) == ([("leg2_shank", "leg2_thigh")], [])


@pytest.mark.parametrize("finger", ["1", "2", "3"])
def test_the_middle_link_of_a_finger_is_no_row_of_its_own(finger: str) -> None:
    def hand(tip: str) -> list[Attachment]:
        names = [(f"upper_link_{n}", f"middle_link_{n}", f"lower_link_{n}") for n in "123"]
        made = []
        for upper, middle, lower in names:
            made += [
                Attachment(upper, "palm", f"a_{upper}"),
                Attachment(middle, upper, f"a_{middle}"),
            ]
            on = tip if lower.endswith(finger) else middle
            made.append(Attachment(lower, on, f"a_{lower}"))
        return made

    assert misplaced(*hand(f"middle_link_{finger}")) == ([], [])
    other = "middle_link_1" if finger == "3" else "middle_link_3"
    assert misplaced(*hand(other))[0] == [(f"lower_link_{finger}", f"middle_link_{finger}")]


def test_of_two_links_the_one_numbered_before_its_carrier_is_misplaced() -> None:
    wheels = [Attachment("left_wheel", "base", "a"), Attachment("right_wheel", "mast", "b")]
    wheels.append(Attachment("mast", "base", "c"))
    assert LimbNames(wheels).elsewhere == []
    (found,) = LimbNames(wheels, {"right_wheel"}).elsewhere
    assert (found.attachment.link, found.meant) == ("right_wheel", "base")


@pytest.mark.parametrize(
    "feet", ["LF_foot RF_foot LH_foot RH_foot", "part_5 part_8 part_11 part_14"]
)
def test_numbered_joints_of_numbered_limbs(feet: str) -> None:
    def legs(second: tuple[str, str]) -> list[Attachment]:
        joints = [("hip_1", "ankle_1"), second, ("hip_3", "ankle_3"), ("hip_4", "ankle_4")]
        made = []
        for n, (foot, (upper, lower)) in enumerate(zip(feet.split(), joints, strict=True), 1):
            made += [Attachment(f"aux_{n}", "trunk", upper), Attachment(foot, f"aux_{n}", lower)]
        return made

    assert misplaced(*legs(("hip_2", "ankle_2"))) == ([], [])
    elsewhere, crossed = misplaced(*legs(("ankle_2", "hip_2")))
    assert (elsewhere, crossed[0]) == ([], ("aux_2", "hip_2"))


@pytest.mark.parametrize("name", ["torso_l", "neck"])
def test_a_side_without_another_side_tells_nothing(name: str) -> None:
    chain = ("base", name, "head")
    pairs = pairwise(chain)
    assert misplaced(*(Attachment(b, a, f"{b}_joint") for a, b in pairs)) == ([], [])


@pytest.mark.parametrize(
    ("joints", "expected"),
    [
        ("joint1 joint2 joint3 joint4", []),
        ("joint1 joint3 joint2 joint4", [("link2", "joint2"), ("link3", "joint3")]),
        ("joint0 joint2 joint1 joint3", [("link2", "joint1"), ("link3", "joint2")]),
        ("joint1 joint3 joint2 elbow", []),
        ("joint4 joint3 joint2 joint1", []),
    ],
)
def test_joints_of_an_arm_that_are_named_after_each_other_s_links(
    joints: str, expected: list[object]
) -> None:
    chain = [f"link{number}" for number in range(5)]
    arm = [Attachment(b, a, j) for (a, b), j in zip(pairwise(chain), joints.split(), strict=True)]
    assert misplaced(*arm) == ([], expected)


def test_joints_of_an_arm_that_have_their_links_words() -> None:
    parts = ("shoulder", "upper_arm", "elbow", "wrist")
    arm = [Attachment(f"{p}_link", "any", f"{p}_joint") for p in parts]
    one, other = (arm[k]._replace(joint=arm[3 - k].joint) for k in (1, 2))
    crossed = [arm[0], one, other, arm[3]]
    assert misplaced(*arm) == ([], [])
    assert misplaced(*crossed) == (
        [],
        [("upper_arm_link", "upper_arm_joint"), ("elbow_link", "elbow_joint")],
    )


@pytest.mark.parametrize(
    "names",
    [
        "torso mid back",
        "front mid back",
        "front_body mid_body rear_body",
        "front_body rear_body",
        "carriage_left carriage_right",
        "LF RF",
        "left middle right",
        "spine_front spine_mid spine_rear",
    ],
)
@pytest.mark.parametrize("joint", ["{}_joint", "joint_{}", "j{}"])
@pytest.mark.parametrize("fins", [(), ("left_fin", "right_fin")])
def test_links_on_one_chain_are_no_repeated_limb(
    names: str, joint: str, fins: tuple[str, ...]
) -> None:
    chain = ["base", *names.split()]
    pairs = [*pairwise(chain), *((chain[1], fin) for fin in fins)]
    assert misplaced(*(Attachment(b, a, joint.format(b)) for a, b in pairs)) == ([], [])


def test_ring_and_little_fingers_are_not_of_a_right_and_a_left_side() -> None:
    fingers = [
        Attachment(f"{finger}_prox_{side}", f"palm_{side}", f"{finger}_mcp_{side}")
        for side in "lr"
        for finger in ("if", "mf", "rf", "lf")
    ]
    assert misplaced(*fingers) == ([], [])
