"""Where a rule has a threshold: what it says of a value just on this side of it and just beyond."""

from collections.abc import Callable

import pytest
from tests.support.example_documents import document_of
from tests.support.examples import inertia, joint, link, pitched_joint, robot
from tests.support.one_rule import section

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding

EVERY_RULE = Settings(select=("KD",))
FOR_ROBCOGEN2 = EVERY_RULE._replace(targets=frozenset(("robcogen2",)))
Writes = Callable[[str], str]


def found(code: str, text: str, settings: Settings = EVERY_RULE) -> list[Diagnostic]:
    return [f for f in analyse(document_of(text), settings).findings if f.code == code]


def moved_by(x: str) -> str:
    return joint("elbow").replace("(0.0, 0.0, 0.3)", f"({x}, 0.0, 0.3)")


def second_of_two(rotation: str = "0.0, 0.0, PI/4.0", x: str = "0.0", kind: str = "r") -> str:
    """Return a shoulder and an elbow at a pose, both of one kind."""
    elbow = joint("elbow", rotation=rotation).replace("(0.0, 0.0, 0.3)", f"({x}, 0.0, 0.3)")
    links = link("upper", 1, "lower via elbow"), link("lower", 2)
    text = robot(*links, joint("shoulder"), elbow, base="upper via shoulder")
    return text.replace("r_joint", f"{kind}_joint")


def ball(mass: str = "4.1", ix: str = "0.0041", iz: str = "0.0041", products: str = "") -> str:
    written = inertia(mass, "0.0", ix, ix, iz)
    for product in products.split():
        written = written.replace(f"{product.partition('=')[0]}=0.0", product)
    return link("ball", 1, inertia=written)


def far_com(x: str) -> str:
    """Return a body that is impossible so far from its CoM."""
    return link("ball", 1, inertia=section(2.0, f"{x}, 0.0, 0.0", 0.01, 0.01, 0.01))


def two_arms(right: str) -> str:
    """Return two mirrored arms; the right one's Iz is given."""
    arm = "inertia_params { mass = 1.0 CoM = (0.1, %s, 0.0) Ix=0.021 Iy=0.031 Iz=%s"
    arm += " Ixy=0.0 Ixz=0.0 Iyz=0.0 }"
    return robot(
        link("left_arm", 1, inertia=arm % ("0.05", "0.0410")),
        link("right_arm", 2, inertia=arm % ("-0.05", right)),
        base="left_arm via left right_arm via right",
        joints="left right",
    )


def with_product(name: str) -> Writes:
    """Return what writes two mirrored arms, the right one with this product of inertia."""

    def write(right: str) -> str:
        arm = "inertia_params { mass = 1.0 CoM = (0.1, %s, 0.02) Ix=0.021 Iy=0.031 Iz=0.041"
        arm += " Ixy=0.004 Ixz=0.004 Iyz=0.004 }"
        signs = {"Ixy": "-0.004", "Ixz": "0.004", "Iyz": "-0.004", name: right}
        other = arm % "-0.05"
        for product, value in signs.items():
            other = other.replace(f"{product}=0.004", f"{product}={value}")
        return robot(
            link("left_arm", 1, inertia=arm % "0.05"),
            link("right_arm", 2, inertia=other),
            base="left_arm via left right_arm via right",
            joints="left right",
        )

    return write


def in_a_frame(com: str) -> str:
    """Return an arm of 0.3 m with its CoM above a frame at its end."""
    about_frame = f"{1.2 * float(com) ** 2 + 0.0005:.4f}"
    section = inertia("1.2", com, about_frame, about_frame, "0.0010")
    arm = link("arm", 1, "hand via wrist", section.replace("}", "ref_frame = f }"))
    pose = "translation = (0.0, 0.0, 0.3) rotation = (0.0, 0.0, 0.0)"
    arm = f"{arm.removesuffix('}' + chr(10))} frames {{ f {{ {pose} }} }} }}\n"
    joints = joint("elbow"), joint("wrist", 0.3)
    return robot(arm, link("hand", 2), *joints, base="arm via elbow")


def framed(user: str) -> str:
    """Return a link with a frame that lies on its own, and an inertia in this frame."""
    section = inertia("4.1", "0.0", "0.0041", "0.0041", "0.0041")
    head = link("head", 1, inertia=section.replace("}", f"{user} }}")).removesuffix("}\n")
    poses = "{ translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }"
    return f"{head} frames {{ camera {poses} }} }}\n"


def hand_at(height: str, com: str = "2.0", ix: str = "4.01", iz: str = "0.01") -> str:
    """Return an arm whose only known length is the height of its wrist."""
    arm = link("arm", 1, "hand via wrist", inertia("1.0", com, ix, ix, iz))
    joints = joint("elbow"), joint("wrist").replace("0.3)", f"{height})")
    return robot(arm, link("hand", 2), *joints, base="arm via elbow")


@pytest.mark.parametrize(
    ("code", "write", "within", "beyond"),
    [
        ("KD303", ball, "0.001", "0.0"),
        ("KD303", ball, "0.001", "-0.001"),
        ("KD305", lambda iz: ball("1.0", "0.1", iz), "0.0000000004", "0.0000000001"),
        ("KD309", hand_at, "0.02", "0.0201"),
        ("KD309", lambda end: hand_at(end, "0.0", "15000.0", "0.0"), "10.0", "9.99"),
        ("KD309", in_a_frame, "0.38", "0.39"),
        ("KD312", with_product("Ixy"), "-0.004", "0.004"),
        ("KD312", with_product("Ixz"), "0.004", "-0.004"),
        ("KD312", with_product("Iyz"), "-0.004", "0.004"),
        ("KD312", two_arms, "0.0390", "0.0389"),
        ("KD312", two_arms, "0.0431", "0.0432"),
        ("KD408", pitched_joint, "omega", "\N{GREEK SMALL LETTER PI}"),
        ("KD408", pitched_joint, "\N{GREEK SMALL LETTER OMEGA}", "\N{GREEK PI SYMBOL}"),
        ("KD501", pitched_joint, "6.2894", "6.2895"),
        ("KD501", pitched_joint, "-6.2894", "-6.2895"),
        ("KD501", pitched_joint, "1e999", "1e300"),
        ("KD502", moved_by, "10.0", "10.001"),
        ("KD502", moved_by, "-10.0", "-10.001"),
        ("KD502", far_com, "5.0", "-5.001"),
        ("KD503", pitched_joint, "1.6", "1.57"),
        ("KD503", pitched_joint, "1.560", "1.570"),
        ("KD503", pitched_joint, "1.56", "1.58"),
        ("KD503", pitched_joint, "1.57078", "1.57079"),
        ("KD503", pitched_joint, "1.57081", "1.57080"),
        ("KD504", lambda ry: joint("j", rotation=f"0.1, {ry}, 0.1"), "1.57069", "1.57071"),
        ("KD504", lambda ry: joint("j", rotation=f"0.1, {ry}, 0.1"), "-1.57069", "-1.57071"),
        ("KD504", lambda rx: joint("j", rotation=f"{rx}, PI/2.0, 0.1"), "0.0", "0.000001"),
        ("KD504", lambda rz: joint("j", rotation=f"0.1, PI/2.0, {rz}"), "0.0", "0.000001"),
        ("KD506", lambda rx: second_of_two(f"{rx}, 0.0, 0.0"), "0.0000011", "0.0000009"),
        ("KD506", lambda ry: second_of_two(f"0.0, {ry}, 0.0"), "0.0000011", "0.0000009"),
        ("KD506", lambda x: second_of_two(x=x), "0.0000011", "0.0000009"),
        ("KD507", moved_by, "0.000005", "0.0000049"),
        ("KD507", moved_by, "-0.000005", "-0.0000049"),
        ("KD507", moved_by, "0.0", "0.0000000001"),
        ("KD507", lambda ixy: ball(products=f"Ixy={ixy}"), "0.0000004", "0.0000005"),
        ("KD507", lambda ixy: ball(products=f"Ixy={ixy}"), "-0.0000004", "-0.0000005"),
        ("KD507", lambda ixz: ball(products=f"Ixy=0.5 Ixz={ixz}"), "0.00001", "0.000001"),
        ("KD508", ball, "4.12345678", "4.123456789"),
        ("KD508", ball, "0.00000412345678", "0.000004123456789"),
        ("KD508", moved_by, "1.23456789", "1.234567891"),
        ("KD703", framed, "ref_frame = camera", ""),
    ],
)
def test_threshold(code: str, write: Writes, within: str, beyond: str) -> None:
    settings = FOR_ROBCOGEN2 if code == "KD507" else EVERY_RULE
    assert found(code, write(within), settings) == []
    assert len(found(code, write(beyond), settings)) == 1


@pytest.mark.parametrize(
    ("written", "is_safe"), [("1.5708", True), ("1.571", False), ("3.1416", True), ("3.142", False)]
)
def test_five_digits_make_a_fraction_of_pi_sure(written: str, is_safe: bool) -> None:
    (finding,) = found("KD503", pitched_joint(written))
    assert finding.fix is not None
    assert finding.fix.is_safe == is_safe


def test_prismatic_joints_are_parallel_wherever_they_are() -> None:
    (finding,) = found("KD506", second_of_two(x="0.5", kind="p"))
    assert finding.message == "joint 'elbow' slides along the axis of joint 'shoulder' before it"
    assert found("KD506", second_of_two(x="0.5")) == []


@pytest.mark.parametrize(
    ("value", "minimum", "maximum", "message"),
    [
        (0.2, 0.2, 0.5, None),
        (0.5, 0.2, 0.5, None),
        (0.19, 0.2, 0.5, "parameter 'x' is 0.19, below its minimum 0.2"),
        (0.51, 0.2, 0.5, "parameter 'x' is 0.51, above its maximum 0.5"),
        (0.19, None, 0.5, None),
        (0.51, 0.2, None, None),
    ],
)
def test_ends_of_a_range_are_in_it(
    value: float, minimum: float | None, maximum: float | None, message: str | None
) -> None:
    bound = Settings(bindings={"x": Binding(value, minimum, maximum)})
    told = [f.message for f in found("KD410", moved_by("x"), bound)]
    assert told == ([] if message is None else [message])


@pytest.mark.parametrize(
    ("base", "below", "moments", "count"),
    [
        ("wheelA via a cartB via b roue via c", "", ("1.28825", "1.28825", "2.10573"), 0),
        ("wheelA via a cartB via b roue via c", "", ("1.3", "1.3", "2.1"), 1),
        ("wheelA via a cartB via b", "roue via c", ("1.28825", "1.28825", "2.10573"), 1),
    ],
)
def test_one_part_is_mounted_several_times(
    base: str, below: str, moments: tuple[str, str, str], count: int
) -> None:
    section = inertia("39.4427", "0.0603226", *moments)
    names, carried = ("wheelA", "cartB", "roue"), ("", below, "")
    links = [link(name, n, carried[n - 1], section) for n, name in enumerate(names, 1)]
    assert len(found("KD310", robot(*links, base=base, joints="a b c"))) == count


@pytest.mark.parametrize(("iy", "count"), [("2.6e-07", 0), ("3.2e-07", 1)])
def test_parts_that_carry_equally_many_links_may_be_one_part(iy: str, count: int) -> None:
    knuckles, tips = ("ffknuckle", "mfknuckle", "thknuckle"), ("fftip", "mftip", "thtip")
    section = inertia("0.008", "0.0", "3.2e-07", iy, iy)
    links = [
        link(knuckle, 2 * n, f"{tip} via {tip}_joint", section) + link(tip, 2 * n + 1)
        for n, (knuckle, tip) in enumerate(zip(knuckles, tips, strict=True), 1)
    ]
    base = " ".join(f"{knuckle} via {knuckle}_joint" for knuckle in knuckles)
    joints = " ".join(f"{name}_joint" for name in (*knuckles, *tips))
    told = [f.message for f in found("KD310", robot(*links, base=base, joints=joints))]
    assert sum("ffknuckle" in message for message in told) == count


@pytest.mark.parametrize(("iy", "count"), [("2.6e-07", 0), ("3.2e-07", 1)])
def test_ends_of_one_part_are_one_part(iy: str, count: int) -> None:
    middles, ends = ("index1", "ring1", "thumb1"), ("index2", "ring2", "thumb2")
    of_middle = inertia("0.008", "0.0", "3.2e-07", iy, iy)
    of_end = inertia("0.002", "0.0", "6.5e-09", "6.5e-09", "6.5e-09")
    links = [
        link(middle, 2 * n, f"{end} via {end}_joint", of_middle) + link(end, 2 * n + 1, "", of_end)
        for n, (middle, end) in enumerate(zip(middles, ends, strict=True), 1)
    ]
    base = " ".join(f"{middle} via {middle}_joint" for middle in middles)
    joints = " ".join(f"{name}_joint" for name in (*middles, *ends))
    told = [f.message for f in found("KD310", robot(*links, base=base, joints=joints))]
    assert sum("index2" in message for message in told) == count


@pytest.mark.parametrize(("names", "count"), [("abc", 1), ("ab", 0), ("LF_a RF_a b", 0)])
def test_three_different_parts_alike_are_suspicious(names: str, count: int) -> None:
    words = names.split() if " " in names else list(names)
    section = inertia("1.5", "0.1", "0.03", "0.03", "0.01")
    links = [link(name, number, inertia=section) for number, name in enumerate(words, 1)]
    joints = [f"to_{name}" for name in words]
    base = " ".join(f"{name} via to_{name}" for name in words)
    assert len(found("KD310", robot(*links, base=base, joints=" ".join(joints)))) == count


@pytest.mark.parametrize(
    ("numbers", "is_placeholder"),
    [
        (("1.0", "1.0", "1.0", "1.0"), True),
        (("1.1", "1.0", "1.0", "1.0"), True),
        (("1.0", "1.1", "1.0", "1.0"), False),
        (("1.0", "1.0", "1.1", "1.0"), False),
        (("1.0", "1.0", "1.0", "1.1"), False),
    ],
)
def test_only_ones_are_a_placeholder(numbers: tuple[str, ...], is_placeholder: bool) -> None:
    mass, ix, iy, iz = numbers
    assert bool(found("KD310", link("a", 1, inertia=inertia(mass, "0.0", ix, iy, iz)))) == (
        is_placeholder
    )


def without_moments(mass: str, height: str) -> str:
    return link("point", 1, inertia=inertia(mass, height, "0.0", "0.0", "0.0"))


def test_a_point_mass_may_have_a_parameter() -> None:
    assert found("KD405", without_moments("m[1.0]", "0.0")) == []
    assert len(found("KD405", ball("m[4.1]"))) == 1


@pytest.mark.parametrize(
    ("height", "end", "is_told"),
    [("0.3000", 0.9, False), ("0.3000", 0.905, True), ("0.3", 0.9, False), ("0.3", 0.905, True)],
)
def test_a_body_is_impossible_from_a_value_on(height: str, end: float, is_told: bool) -> None:
    """Of 0.0811 kg·m² about the origin, `m` at 0.3 m has 0.09 m; a dropped zero is likely."""
    section = inertia("m", height, "0.0811", "0.0811", "0.0001")
    bound = Settings(select=("KD",), bindings={"m": Binding(0.4, 0.3, end)})
    told = [f.message for f in found("KD411", link("a", 1, inertia=section), bound)]
    expected = f"inertia of 'a' is physically impossible at m = {end:g}"
    assert told == ([expected] if is_told else [])


@pytest.mark.parametrize(
    ("parent", "child", "other", "count"),
    [
        (2, 1, 3, 1),
        (3, 2, 1, 1),
        (1, 2, 3, 0),
        (3, 1, 1, 0),
        (3, 1, 3, 0),
        (2, 1, 2, 0),
        (9, 1, 2, 0),
    ],
)
def test_numbers_that_are_wrong_otherwise_have_no_order(
    parent: int, child: int, other: int, count: int
) -> None:
    links = link("a", parent, "b via jb"), link("b", child), link("c", other)
    text = robot(*links, base="a via ja c via jc", joints="ja jb jc")
    assert len(found("KD110", text)) == count


@pytest.mark.parametrize(("n_below", "n_shown"), [(3, 3), (20, 20), (21, 20)])
def test_twenty_other_places_are_shown(n_below: int, n_shown: int) -> None:
    names = [f"part{letter}" for letter in "abcdefghijklmnopqrstuvwxyz"[:n_below]]
    section = inertia("1.5", "0.1", "0.03", "0.03", "0.01")
    children = " ".join(f"{name} via to_{name}" for name in names)
    trunk = link("trunk", 1, children, section)
    limbs = [link(name, number, inertia=section) for number, name in enumerate(names, 2)]
    text = robot(trunk, *limbs, joints=" ".join(f"to_{name}" for name in names))
    (orphan,) = found("KD203", text)
    assert orphan.message == f"link 'trunk' has no parent; {n_below} more links attached to it"
    assert [r.message for r in orphan.related] == [
        f"'{name}' is attached to it" for name in names[:n_shown]
    ]
    (alike,) = found("KD310", text)
    assert alike.message == (
        f"'trunk' and {n_below} differently shaped links share the same mass and moments"
    )
    assert [r.message for r in alike.related] == [
        f"inertia of '{name}'" for name in names[:n_shown]
    ]


def test_twenty_wrong_names_may_be_slips() -> None:
    """Of what is lost beyond that nothing is suggested."""
    names = [f"elbow_{letter}" for letter in "abcdefghijklmnopqrstuvwxyz"[:22]]
    children = " ".join(f"x_{name} via {name}x" for name in names)
    links = [link(f"x_{name}", number) for number, name in enumerate(names, 1)]
    told = found("KD106", robot(*links, base=children, joints=" ".join(names)))
    assert ["did you mean" in finding.message for finding in told] == [True] * 20 + [False] * 2
