"""An inertia given in another frame: the same body, short numbers, only where both are known."""

import random
from itertools import permutations

import pytest
from tests.features.samples import ARM
from tests.support.amount import usually
from tests.support.cursor import at_cursor
from tests.support.kept import errors
from tests.support.mechanisms import assert_same_mechanism, mechanics_by_name

from kindsl.frontends.features.actions.code_actions import quick_fixes
from kindsl.frontends.features.actions.move_inertia import move_inertia
from kindsl.judgement.analysis.analysis import analyse

FRAME = "{name} {{ translation = ({x}, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }}"
TO_COM = "Give the inertia of 'upper' about its CoM, in a new frame 'upper_com'"
LINK_FRAME = "Give the inertia of 'upper' in its link frame"


def upper(inertia: str, frames: str = "", before_children: str = " ") -> str:
    """Return the arm with another inertia and with frames of its upper link."""
    start, end = ARM.index("    inertia_params {\n        mass = 2.0"), ARM.index("link lower")
    section = (
        f"    inertia_params {{ $0{inertia} }}{before_children}children {{ lower via elbow }}\n"
    )
    return f"{ARM[:start]}{section}    frames {{ {frames} }}\n}}\n\n{ARM[end:]}"


def offered(marked: str) -> dict[str, str]:
    """Return what the text would be after each change that is offered."""
    analysis, offset = at_cursor(marked)
    return {
        action.title: analysis.edited(action.edits).text
        for action in move_inertia(analysis, offset, offset)
    }


TEN = "mass = 2.0 CoM = (0.25, 0.0, 0.0) Ix=0.01 Iy=0.2 Iz=0.2 Ixy=0.0 Ixz=0.0 Iyz=0.0"


def test_an_inertia_can_be_given_in_each_of_the_link_s_frames() -> None:
    frames = " ".join(FRAME.format(name=name, x=0.1) for name in ("a", "b"))
    there = [f"Give the inertia of 'upper' in '{name}'" for name in ("a", "b")]
    assert [*offered(upper(TEN, frames))] == [*there, TO_COM]
    assert [*offered(upper(f"{TEN} ref_frame = b", frames))] == [LINK_FRAME, there[0], TO_COM]


@pytest.mark.parametrize(
    "frames",
    [
        FRAME.format(name="a", x="x"),
        FRAME.format(name="a", x="x[1.0]"),
        FRAME.format(name="a", x="1e999"),
        FRAME.format(name="a", x=0.1) + FRAME.format(name="a", x=0.2),
        "a { translation = (0.0, 0.0, 0.0) }",
    ],
)
def test_a_frame_that_is_nowhere_for_sure_takes_no_inertia(frames: str) -> None:
    assert [*offered(upper(TEN, frames))] == [TO_COM]


@pytest.mark.parametrize("frames", ["", FRAME.format(name="a", x="x")])
def test_an_inertia_in_a_frame_that_is_nowhere_stays(frames: str) -> None:
    assert offered(upper(f"{TEN} ref_frame = a", frames)) == {}


def test_an_inertia_about_the_com_stays_there() -> None:
    assert offered(upper(TEN.replace("0.25", "0.0"))) == {}


@pytest.mark.parametrize("taken", ["frame", "link", "joint"])
def test_the_new_frame_has_a_name_of_its_own(taken: str) -> None:
    text = upper(TEN)
    if taken == "frame":
        text = text.replace("tip {", "upper_com {")
    else:
        text = text.replace({"link": "lower", "joint": "elbow"}[taken], "upper_com")
    (title,) = offered(text)
    assert title.endswith("'upper_com_2'")
    (title,) = offered(text.replace("Arm", "Arm2").replace("base", "upper_com_2"))
    assert title.endswith("'upper_com_3'")


def test_elsewhere_in_the_link_nothing_is_offered() -> None:
    text = upper(TEN).replace("$0", "")
    for place in ("link upper", "id = 1", "children { lower", "frames {", "r_joint"):
        assert offered(text.replace(place, f"$0{place}")) == {}


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("Iyz=0.0 ref_frame = a }", "Iyz=0.0 }"),
        ("Iyz=0.0 \t ref_frame = a }", "Iyz=0.0 }"),
        ("Iyz=0.0\n        ref_frame = a\n    }", "Iyz=0.0\n    }"),
        ("Iyz=0.0\r\n        ref_frame = a\r\n    }", "Iyz=0.0\r\n    }"),
        ("Iyz=0.0\r        ref_frame = a\r    }", "Iyz=0.0\r    }"),
        ("Iyz=0.0\n\nref_frame = a\n    }", "Iyz=0.0\n\n    }"),
        ("Iyz=0.0 /* c */ ref_frame = a }", "Iyz=0.0 /* c */ }"),
    ],
)
def test_nothing_is_left_of_the_reference(before: str, after: str) -> None:
    frame = FRAME.format(name="a", x=0.0)
    text = upper(f"{TEN} ref_frame = a", frame).replace("Iyz=0.0 ref_frame = a }", before)
    assert offered(text)[LINK_FRAME] == text.replace("$0", "").replace(before, after)


@pytest.mark.parametrize(("mass", "size"), [(2.0, 0.1), (5000.0, 30.0)])
@pytest.mark.parametrize("axis", range(3))
def test_a_quarter_turn_leaves_no_dust_in_the_numbers(mass: float, size: float, axis: int) -> None:
    """Nor does a frame whose origin is the centre of mass: numbers cancel that were measured."""
    turn = ", ".join("PI/2.0" if axis == other else "0.0" for other in range(3))
    com = f"({size}, {2.0 * size}, {-size})"
    turned = f"a {{ translation = (0.0, 0.0, 0.0) rotation = ({turn}) }}"
    moved = f"b {{ translation = {com} rotation = ({turn}) }}"
    moment = 20.0 * mass * size * size
    inertia = (
        f"mass = {mass} CoM = {com} Ix={moment} Iy={moment} Iz={moment} Ixy=0.0 Ixz=0.0 Iyz=0.0"
    )
    text = upper(inertia, f"{turned} {moved}")
    assert len(offered(text)) >= 2
    for title, new in offered(text).items():
        inertia_section = analyse(new).model.body_named["upper"].inertia
        values = [*inertia_section.moments.values(), *inertia_section.com.components]
        assert all(len(value.text) < 18 for value in values), title
        if "in 'a'" not in title:
            assert [c.text for c in inertia_section.com.components] == ["0.0", "0.0", "0.0"]


@pytest.mark.parametrize(
    ("translation", "turn"),
    [("0.0, 40.0, 0.0", "PI/2.0, 0.0, 0.0"), ("0.0, 0.0, 40.0", "0.0, PI/2.0, 0.0"),
     ("40.0, 0.0, 0.0", "0.0, 0.0, PI/2.0")],
)  # fmt: skip
def test_nor_does_a_frame_that_is_far_from_a_small_body(translation: str, turn: str) -> None:
    inertia = "mass = 5000.0 CoM = (0.0, 0.0, 0.0) Ix=0.1 Iy=0.1 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0"
    text = upper(inertia, f"a {{ translation = ({translation}) rotation = ({turn}) }}")
    (new,) = offered(text).values()
    moments = analyse(new).model.body_named["upper"].inertia.moments
    assert [moments[name].text for name in ("Ixy", "Ixz", "Iyz")] == ["0.0", "0.0", "0.0"]


def test_an_inertia_without_its_brace_takes_no_frame() -> None:
    text = upper(TEN, FRAME.format(name="a", x=0.1))
    assert [*offered(text.replace("inertia_params {", "inertia_params"))] == []


def test_a_small_product_of_inertia_is_kept() -> None:
    """Dust is what is small beside the numbers that it was computed from."""
    text = upper(TEN.replace("Ixy=0.0", "Ixy=0.0000000001"), FRAME.format(name="a", x=0.5))
    new = offered(text)["Give the inertia of 'upper' in 'a'"]
    assert analyse(new).model.body_named["upper"].inertia.moments["Ixy"].value({}) == 1e-10


@pytest.mark.parametrize("order", [*permutations(("mass", "CoM", "Ix Iy"))][:4])
def test_the_order_of_the_numbers_does_not_matter(order: tuple[str, ...]) -> None:
    parts = {"mass": "mass = 2.0", "CoM": "CoM = (0.25, 0.1, 0.0)"}
    parts["Ix Iy"] = "Iyz=0.0 Ix=0.05 Iy=0.2 Ixy=0.05 Iz=0.2 Ixz=0.0"
    text = upper(" ".join(parts[name] for name in order))
    before = mechanics_by_name(analyse(text.replace("$0", "")), {"reach": 0.1})
    assert_same_mechanism(before, mechanics_by_name(analyse(offered(text)[TO_COM]), {"reach": 0.1}))


REFERRING = ARM.replace(
    "Iyz=0.0\n    }\n    children {}", "Iyz=0.0 ref_frame = mid\n    }\n    children {}"
)


def frames_offered(text: str) -> list[str]:
    analysis = analyse(text)
    return [
        action.title
        for finding in analysis.findings
        if finding.code == "KD107"
        for action in quick_fixes(analysis, finding.start, finding.start)
        if "Create frame" in action.title
    ]


@pytest.mark.parametrize(
    ("old", "new", "offered"),
    [
        ("mid", "mid", ["Create frame 'mid' in 'lower'"]),
        # Beside the name that is probably meant.
        ("mid", "tipp", ["Create frame 'tipp' in 'lower'"]),
        # The name is that of something else, which a frame cannot have.
        ("mid", "upper", []),
        ("mid", "Elbow", []),
        ("Ixz=0.0 Iyz=0.0\n", "Ixz=0.0 Iyz=0.0 ref_frame = new\n",
         [f"Create frame 'new' in '{link}'" for link in ("base", "upper")]
         + ["Create frame 'mid' in 'lower'"]),
    ],
)  # fmt: skip
def test_a_frame_is_offered_where_only_it_is_missing(
    old: str, new: str, offered: list[str]
) -> None:
    assert frames_offered(REFERRING.replace(old, new)) == offered


def test_a_frame_that_is_added_is_the_link_s_own() -> None:
    analysis = analyse(REFERRING)
    (finding,) = (f for f in analysis.findings if f.code == "KD107")
    (action,) = quick_fixes(analysis, finding.start, finding.start)
    (_, mid) = analysis.edited(action.edits).model.frames
    assert [c.text for c in mid.pose.translation.components] == ["0.0", "0.0", "0.0"]
    assert [c.text for c in mid.pose.rotation.components] == ["0.0", "0.0", "0.0"]


def test_a_link_without_its_brace_takes_no_frame() -> None:
    start = ARM.index("link upper")
    referring = ARM[start:].replace("Iyz=0.0\n    }\n", "Iyz=0.0 ref_frame = new\n    }\n", 1)
    assert frames_offered(ARM[:start] + referring) == ["Create frame 'new' in 'upper'"]
    assert frames_offered(ARM[:start] + referring.replace("upper {", "upper", 1)) == []


def test_a_link_whose_keyword_is_misspelt_takes_a_frame_too() -> None:
    """It stands in the piece of text that the block before it begins."""
    texts = (REFERRING, REFERRING.replace("link lower", "ink lower"))
    good, broken = (with_frame(text) for text in texts)
    assert "mid {" in good and broken == good.replace("link lower", "ink lower")


def with_frame(text: str) -> str:
    analysis = analyse(text)
    (finding,) = (f for f in analysis.findings if f.code == "KD107")
    (action,) = quick_fixes(analysis, finding.start, finding.start)
    return analysis.edited(action.edits).text


def test_the_inertia_of_a_link_without_a_name_stays() -> None:
    text = upper(TEN, FRAME.format(name="a", x=0.1))
    assert offered(text.replace("link upper {", "link {")) == {}


def test_links_without_inertia_do_not_matter() -> None:
    start, end = (
        ARM.index("    inertia_params {\n        mass = 2.0"),
        ARM.index("    children {\n        low"),
    )
    without = ARM[end:].replace("Iyz=0.0\n    }\n", "Iyz=0.0 ref_frame = new\n    }\n")
    assert frames_offered(ARM[:start] + without) == ["Create frame 'new' in 'lower'"]


def rounded_rod(generator: random.Random) -> str:
    """Return the numbers of a thin rod somewhere, rounded: mostly of no body by themselves."""
    mass, half = round(generator.uniform(0.5, 8.0), 2), generator.uniform(0.05, 0.25)
    x, y, z = (generator.uniform(-0.4, 0.4) for _ in range(3))
    across = mass * half * half / 3.0
    moments = (
        mass * (y * y + z * z),
        across + mass * (z * z + x * x),
        across + mass * (x * x + y * y),
    )
    products = mass * x * y, mass * x * z, mass * y * z
    count = generator.choice((2, 3, 4))
    names = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")
    pairs = zip(names, (*moments, *products), strict=True)
    written = " ".join(f"{name}={value:.{count}f}" for name, value in pairs)
    return f"mass = {mass} CoM = ({x:.{count}f}, {y:.{count}f}, {z:.{count}f}) {written}"


@pytest.mark.parametrize("part", range(4))
def test_an_inertia_that_its_digits_make_possible_stays_possible(part: int) -> None:
    generator = random.Random(part)
    frame = FRAME.format(name="a", x=0.1)
    n_offered, n_rods = 0, usually(10, thoroughly=250)
    for _ in range(n_rods):
        marked = upper(rounded_rod(generator), frame)
        before = analyse(marked.replace("$0", ""))
        n_offered += len(offered(marked))
        for new in offered(marked).values():
            after = analyse(new)
            assert errors(after) <= errors(before)
            assert any(m.literal for m in after.model.body_named["upper"].inertia.moments.values())
    assert n_offered > 1.5 * n_rods


def test_only_such_an_inertia_loses_digits() -> None:
    """About its CoM the rod has -0.0024 kg·m² beside a CoM that is known to 5 mm."""
    rod = "mass = 1.5 CoM = (-0.20, 0.0, -0.04) Ix={} Iy=0.08 Iz=0.07 Ixy=0.0 Ixz=0.01 Iyz=0.0"
    (poor,) = offered(upper(rod.format("0.00"))).values()
    assert "Ix=0.0 Iy=0.02 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0" in poor
    (good,) = offered(upper(rod.format("0.01"))).values()
    assert "Ix=0.0076 Iy=0.0176 Iz=0.01 Ixy=0.0 Ixz=-0.002 Iyz=0.0" in good
