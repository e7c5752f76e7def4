"""What is offered to change in documents of all layouts, and what gestures and drags write.

The answers are in `recorded/`; how they get there: `tests/support/recorded.py`.
"""

from collections.abc import Callable, Iterator
from math import pi
from pathlib import Path

import pytest
from tests.features.samples import ARM, PARAMETRIC, TANGLED
from tests.support.recorded import Teller, assert_as_recorded
from tests.support.robots import LIFT

from kindsl.frontends.features.actions.code_actions import refactorings
from kindsl.frontends.features.completion.completion import completions, suggestions
from kindsl.frontends.features.manipulation.additions import add_child, add_frame
from kindsl.frontends.features.manipulation.handles import handles
from kindsl.frontends.features.manipulation.mirror_leg import mirror_leg
from kindsl.frontends.features.manipulation.pose_as_zero import pose_as_zero
from kindsl.frontends.features.manipulation.set_component import ComponentChange, set_component
from kindsl.frontends.features.manipulation.things import Thing, carrying_frame
from kindsl.frontends.features.transforms import (
    renamed_transforms,
    transforms_actions,
    transforms_completions,
)
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding

FOLDER = Path(__file__).parent / "recorded"
INERTIA = "Ix=0.2 Iy=0.3 Iz=0.4 Ixy=0.01 Ixz=-0.02 Iyz=0.03"
ZERO = "translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0)"
# The child stands first, comments go along; two frames share a name.
UNSORTED = f"""\
Robot Biped {{
// the trunk
RobotBase trunk {{ children {{ left_thigh via left_hip }} }}  // fixed
// a shin
link left_shin {{ id = 1 children {{}} frames {{ left_foot {{ {ZERO} }} left_foot {{ {ZERO} }} }} }}
/* a thigh */ link left_thigh {{
    id = 2
    inertia_params {{
        mass = 2.0
        CoM = (0.1, 0.2, 0.3)
        {INERTIA}
        ref_frame = left_mid
    }}
    children {{
        left_shin via left_knee
    }}
    frames {{
        left_mid {{
            translation = (0.0, 0.1, -0.2)
            rotation = (PI/2.0, -0.1, + 0.3)
        }}
    }}
}} // knees follow
r_joint left_hip {{ ref_frame {{ translation = (0.0, 0.1, 0.2) rotation = (PI, 0.0, -0.5) }} }}
p_joint left_knee {{ ref_frame {{ translation = (0.0, - 0.1, 0.0) rotation = (0.1, 0.2, 0.3) }} }}
}}
"""
# A joint stands between the links, the document ends with a link.
SCATTERED = f"""\
Robot S {{
RobotBase b {{ children {{ p via j q via k }} }}
link p {{ id = 2 inertia_params {{ mass = 1.0 CoM = (0.1, 0.0, 0.0) {INERTIA} }} children {{}} }}
r_joint j {{ ref_frame {{ {ZERO} }} }}
r_joint k {{ ref_frame {{ {ZERO} }} }}
link q {{ id = 1 children {{}} frames {{}} }}"""
FRAGMENT = f"""\
link b {{ id = 2 children {{}} }}
link a {{ id = 1 children {{ b via j }} frames {{ c {{ {ZERO} }} }} }}
"""
DOCUMENTS = {
    "lift": LIFT,
    "arm": ARM,
    "gripper": PARAMETRIC,
    "tangled": TANGLED,
    "unsorted": UNSORTED,
    "unsorted, far out": UNSORTED.replace("0.2, 0.3)", "20.2, 0.3)"),
    "unsorted, carriage returns": UNSORTED.replace("\n", "\r\n"),
    "scattered": SCATTERED,
    "fragment": FRAGMENT,
    "nothing": "",
}
POINT = (0.1, -0.25, 0.0)


def told_edits(found: object, teller: Teller) -> Iterator[str]:
    yield from (f"    {line}" for line in teller.told(found))


def of_layouts() -> Iterator[str]:
    """Yield the refactorings at the start of each word of the less usual documents."""
    for name, text in DOCUMENTS.items():
        analysis = analyse(text)
        if name not in ("arm", "gripper", "tangled"):
            yield f"## {name}"
            teller = Teller(text)
            starts = [k for k in range(len(text) + 1) if not text[k - 1 : k].strip()]
            ends = [k for k in range(len(text)) if not text[k : k + 1].strip()]
            ask = _unless_extracting(analysis)
            yield from teller.grouped(ask, sorted({*starts, *ends}))


def _unless_extracting(analysis: Analysis) -> Callable[[int], object]:
    return lambda offset: [
        action
        for action in refactorings(analysis, offset, offset)
        if action.kind != "refactor.extract"
    ]


def of_gestures() -> Iterator[str]:
    for name, text in DOCUMENTS.items():
        analysis, teller = analyse(text), Teller(text)
        for body in dict.fromkeys([*map(str, (b.name for b in analysis.model.bodies)), "nobody"]):
            yield f"## {name}: {body}"
            yield from told_edits(add_child(analysis, body, POINT, "revolute"), teller)
            yield from told_edits(add_child(analysis, body, POINT, "prismatic"), teller)
            yield from told_edits(add_child(analysis, body, POINT, "spherical"), teller)
            yield from told_edits(add_frame(analysis, body, POINT), teller)
            yield from told_edits(mirror_leg(analysis, body), teller)
        for joint in dict.fromkeys([*map(str, (j.name for j in analysis.model.joints)), "nothing"]):
            yield f"## {name}: {joint}"
            for position in (0.0, 0.25, -pi / 2.0):
                yield from told_edits(pose_as_zero(analysis, {joint: position}), teller)


WRITTEN = (
    "0.5", "0.50", "-0.5", "+0.5", "2", "1e-3", "0.0", "PI", "-PI/2.0", "2.0PI", "2.0*PI", "x",
    "-x", "+x", "x[0.25]", "-x[0.25]", "z[0.25]", "2.0 x", "2.0*x", "x*2.0", "x/4.0", "-x/4.0",
    "4.0/x", "x/0.0", "x*y", "x+y", "(x)", "(2.0)*x", "x/(-2.0)", "-PI*x", "x*-PI", "<c>", "-<c>",
    "<c>/2.0", "<d>", "<e=0.75>", "2.0*<e=0.75>", "m", "0.0*x", "", "1.0 2.0", "x/- 2.0", "- 2.0*x",
)  # fmt: skip
BOUND = Settings(bindings={"x": Binding(0.5, 0.1, 2.0), "m": Binding(1.0)})
JOINT = """Robot R {{ RobotBase base {{ children {{ a via j }} frames {{ f {{
    translation = (x, <c=0.125>, <c>) rotation = (y[1.0], 0.0, y[2.0]) }} }} }}
link a {{ id = 1 children {{}} }}
r_joint j {{ ref_frame {{ translation = ({0}, 0.0, 0.0) rotation = ({0}, 0.0, 0.0) }} }} }}"""


def of_drags() -> Iterator[str]:
    joint = Thing("joint", "j")
    for written in WRITTEN:
        text = JOINT.format(written)
        analysis, teller = analyse(text, BOUND), Teller(text)
        for typed in ({}, {"x": 0.25, "y": 4.0}):
            yield f"## {written} {typed or ''}".rstrip()
            for handle in list(handles(analysis, joint, typed))[::3]:
                yield from told_edits(handle, teller)
            for component in ("x", "rx"):
                for value, step in ((0.4, None), (pi / 4.0, None), (-1.23, 0.5), (-20.0, None)):
                    found = set_component(analysis, joint, component, value, step, typed)
                    yield f"  {component} {value:.4g} {step}"
                    yield from told_edits(_rounded(found), teller)


def _rounded(found: object) -> object:
    return (
        found._replace(value=round(found.value, 9)) if isinstance(found, ComponentChange) else found
    )


def of_things() -> Iterator[str]:
    """Yield what cannot be moved, and why."""
    for name, text in DOCUMENTS.items():
        analysis, teller = analyse(text), Teller(text)
        model = analysis.model
        names = [str(thing.name) for thing in (*model.bodies, *model.joints, *model.frames)]
        for kind in ("joint", "frame", "com", "link"):
            for own in dict.fromkeys([*names, "nobody", "b.tip", "a.tip"]):
                thing = Thing(kind, own)
                rows = [*handles(analysis, thing)]
                if not all(row.locked.startswith("there is no") for row in rows):
                    yield f"## {name}: {kind} {own} {carrying_frame(model, thing)}".rstrip()
                    for row in rows:
                        yield from told_edits(row, teller)
    found = set_component(analyse(LIFT), Thing("joint", "lift"), "rq", 0.0)
    yield from told_edits(found, Teller(LIFT))
    for value, step in ((float("nan"), None), (1.0, 0.0), (1.0, -1.0), (1.0, float("inf"))):
        found = set_component(analyse(LIFT), Thing("joint", "lift"), "x", value, step)
        yield from told_edits(found, Teller(LIFT))


TRANSFORMS = """\
Robot Arm
Frames { fr_base, fr_upper, uper, tol }
Transforms {
    base=fr_base, target=tool
    base=fr_slider, target=tool
}
Jacobians { base=fr_base, target=fr_slider }
"""


def of_transforms() -> Iterator[str]:
    model = analyse(LIFT).model
    for text in (TRANSFORMS, TRANSFORMS[:30], "Robot", " \n", "Robot Arm ; Frames {"):
        teller = Teller(text)
        yield f"## {text!r}"
        offsets = [*range(len(text) + 1)]
        yield from teller.grouped(lambda k, t=text: transforms_completions(t, k, model), offsets)
        yield from teller.grouped(lambda k, t=text: transforms_completions(t, k, None), offsets)
        yield from teller.grouped(lambda k, t=text: transforms_actions(t, model, k, k), offsets)
        yield from teller.grouped(lambda k, t=text: transforms_actions(t, None, k, k), offsets)
    yield "## other names"
    analysis = analyse(LIFT)
    teller = Teller(LIFT)
    edits = teller.grouped(
        lambda k: renamed_transforms(analysis, k, "^new", TRANSFORMS), range(len(LIFT))
    )
    yield from edits


def of_typing() -> Iterator[str]:
    """Yield what is offered while a document is typed, its rest still missing."""
    for text in (PARAMETRIC, UNSORTED):
        offsets = [k for k in range(len(text) + 1) if not text[k - 1 : k].isalnum()]
        yield from Teller(text).grouped(lambda k, t=text: _offered(t[:k]), offsets)


def _offered(text: str) -> list[str]:
    """Return the labels offered at the end of a text, then those offered unasked."""
    analysis = analyse(text)
    lists = completions(analysis, len(text)), suggestions(analysis, len(text))
    rows = (", ".join(item.label for item in found.items) for found in lists)
    return [row for row in rows if row]


ALL = [of_layouts, of_gestures, of_drags, of_things, of_transforms, of_typing]


@pytest.mark.parametrize("of", ALL)
def test_changes_are_as_recorded(of: Callable[[], Iterator[str]]) -> None:
    assert_as_recorded(FOLDER / f"{of.__name__}.txt", of())
