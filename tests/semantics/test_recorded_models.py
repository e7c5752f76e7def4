"""What documents and values mean, in full: also broken ones, and values of every form.

The answers are in `recorded/`; how they get there: `tests/support/recorded.py`.
"""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.features.samples import BROKEN, PARAMETRIC, TANGLED
from tests.support.recorded import Teller, assert_as_recorded
from tests.support.robots import STUB

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.language.semantics.declarations import Inertia, Joint, Link, Pose, Vector
from kindsl.language.semantics.expressions import Expression, symbols
from kindsl.language.semantics.numbers import mass_distribution, written_pose
from kindsl.language.semantics.parameters import values_of
from kindsl.language.semantics.places import Located
from kindsl.language.semantics.ranges import bounds_of, degrees_of
from kindsl.language.semantics.transforms import (
    frame_names,
    other_robot,
    repetitions,
    undeclared_frames,
    unknown_frames,
    unknown_listed_frames,
)
from kindsl.language.syntax.document import parse
from kindsl.language.syntax.transforms_text import read_transforms

FOLDER = Path(__file__).parent / "recorded"
VALUES = (
    "1.5", "-1.5", "+1.5", "- 1.5", "2", "1e-3", "0x10", ".5", "120.0", "PI", "-PI", "pi", "2.0PI",
    "2.0*PI", "PI/2.0", "-PI/4.0", "x", "-x", "+x", "^x", "x[0.25]", "z[0.25]", "-z[0.25]", "x[PI]",
    "2.0 x", "2.0 z", "2.0x", "2.0*x", "x*2.0", "x/4.0", "4.0/x", "x/0.0", "x/(1.0-1.0)", "x*y",
    "x*x", "x/y", "y/x", "x+y", "x-y", "(x)", "-(x+y)", "(x+1.0)*(y-2.0)", "x*y/3.0", "1.25*0.5",
    "0.500/3.0", "0.0*x", "<c>", "-<c>", "<c>/2.0", "<d>", "<e=0.75>", "-<e=0.75>/2.0", "z",
    "2.0*z", "x*", "/x", "", "x y", "1.0 2.0", "x[", "<c", "1e999", "-1e999/1e999", "1.0/1e-300",
)  # fmt: skip
BOUND = {"x": 0.5, "y": -2.0, "<c>": 0.125}
RANGES = {"x": (0.25, 0.75), "y": (-3.0, 1.0), "<c>": (0.125, 0.125)}


class Describing:
    """Says what an analysis takes a document to mean."""

    def __init__(self, analysis: Analysis) -> None:
        self.model, self.resolver = analysis.model, analysis.resolver
        self.teller = Teller(analysis.text)
        self.values = values_of(self.model.parameters, self.model.constants, {})

    def place(self, at: Located | None) -> str:
        return "nowhere" if at is None else self.teller.span(*self.resolver.span(at))

    def lines(self) -> Iterator[str]:
        model = self.model
        yield f"robot {model.name!r}{' floating' * model.floating}, base {model.base}"
        for body in model.bodies:
            yield from self.body(body)
        for joint in model.joints:
            yield from self.joint(joint)
        yield f"frames {[(str(f.name), str(f.link)) for f in model.frames]}"
        yield from self.tree()
        yield from self.names()

    def body(self, body: Link) -> Iterator[str]:
        kind = "floating base" if body.is_floating else "base" if body.is_base else "link"
        yield f"{kind} {body.id} at {self.place(body.id_place)}, {self.place(body.name)}"
        yield f"    {self.place(body)}"
        if body.inertia is not None:
            yield from self.inertia(body.inertia)
        for child in body.children:
            yield f"    {child.link!r} via {child.joint!r} {self.place(child)}"
        for frame in body.frames:
            yield f"    frame {frame.name!r} {self.place(frame)} {self.pose(frame.pose)}"

    def inertia(self, inertia: Inertia) -> Iterator[str]:
        yield f"    inertia {self.place(inertia)} in {inertia.frame!r}"
        moments = {name: value.text for name, value in inertia.moments.items()}
        mass = inertia.mass.text if inertia.mass is not None else None
        yield f"        {mass} {self.vector(inertia.com)} {moments}"
        yield f"        {mass_distribution(inertia, self.values)}"

    def joint(self, joint: Joint) -> Iterator[str]:
        yield f"{joint} {joint.id} at {self.place(joint.id_place)}, {self.place(joint.name)}"
        yield f"    {self.place(joint)} {self.pose(joint.pose)}"

    def pose(self, pose: Pose) -> str:
        written = written_pose(pose, self.values)
        where = None if written is None else [round(x, 12) for x in written.translation]
        return f"{self.vector(pose.translation)} {self.vector(pose.rotation)} {where}"

    def vector(self, vector: Vector | None) -> list[str] | None:
        return None if vector is None else [component.text for component in vector.components]

    def tree(self) -> Iterator[str]:
        tree = self.model.tree
        for edge in tree.edges:
            yield f"{edge.predecessor} carries {edge.link} via {edge.joint}"
        for body in self.model.bodies:
            above, below = tree.above.get(body, []), tree.successor_edges(body)
            first = tree.supporting_edge(body)
            order = tree.in_topological_order(body)
            by = first.predecessor if first is not None else None
            yield f"{body}: {len(above)} above, {len(below)} below, by {by}, then {order}"
        for joint in self.model.joints:
            yield f"{joint}: {len(tree.joint_uses.get(joint, []))} uses"
        yield f"reachable {sorted(str(body.name) for body in tree.reachable)}"
        for loop in tree.loops:
            yield f"loop {[str(edge.child.link) for edge in loop]}"

    def names(self) -> Iterator[str]:
        for parameter in self.model.parameters:
            yield f"{parameter.kind} parameter {self.place(parameter.name)} {parameter.value}"
            for use in parameter.uses:
                default = use.default.text if use.default is not None else None
                yield f"    {use.kind} {self.place(use.name)} {default}"
        for constant in self.model.constants:
            count = len(constant.definitions), len(constant.uses)
            yield f"constant {self.place(constant.name)} defined and used {count}"
        yield f"values {self.values}"


def of_documents() -> Iterator[str]:
    for name, text in (("gripper", PARAMETRIC), ("half", BROKEN), ("tangled", TANGLED)):
        yield f"## {name}"
        yield from Describing(analyse(text)).lines()


def of_losses() -> Iterator[str]:
    """Yield what is said otherwise of a document that lacks one of its tokens."""
    whole = analyse(STUB)
    usual = set(Describing(whole).lines())
    for island, start in zip(whole.syntax.islands, whole.syntax.starts, strict=True):
        for token in island.tokens:
            first, last = start + token.start, start + token.end
            # As many blanks, so that the places stay.
            text = STUB[:first] + " " * (last - first) + STUB[last:]
            yield f"## {Teller(STUB).span(first, last)}"
            lines = list(Describing(analyse(text)).lines())
            yield from (line for line in lines if line not in usual)
            yield from (f"not {line}" for line in sorted(usual.difference(lines)))


def of_values() -> Iterator[str]:
    for text in VALUES:
        document = f"p_joint j {{ ref_frame {{ translation = ({text}, 7.0, 7.0) }} }}"
        (island,) = (i for i in parse(document).islands if "p_joint" in i.text)
        (pose,) = (j.pose for j in analyse(document).model.joints)
        components = pose.translation.components if pose.translation is not None else ()
        yield f"## {text}: {[component.text for component in components]}, {len(island.problems)}"
        if components:
            yield from of_value(components[0])


def of_value(value: Expression) -> Iterator[str]:
    yield f"    literal {value.literal}, {value.value({})}, bound {value.value(BOUND)}"
    yield f"    rounding {value.rounding({}):.6g}, bound {value.rounding(BOUND):.6g}"
    yield f"    bounds {bounds_of(value, {})}, bound {bounds_of(value, RANGES)}"
    yield f"    degrees {degrees_of(value, frozenset('xy'))}"
    for symbol in symbols(value):
        inner = next((part.text for part in symbol[1:] if part is not None), None)
        place = f"{symbol.name.start - value.start} to {symbol.name.end - value.start}"
        yield f"    {type(symbol).__name__} {symbol.name} at {place}: {inner}"


TRANSFORMS = (
    "Robot arm\nFrames { fr_base, fr_upper, tip, uper }\nTransforms {\n"
    "    base=fr_base, target=tip\n    base=tip, target=fr_base\n    base=fr_base, target=tip\n"
    "    base=fr_base, target=tool\n}\nJacobians { base=fr_base, target=tip\n"
    "    base=fr_base, target=tip base=uper, target=tool }",
    "Robot leg\nFrames { fr_base, fr_base }\nTransforms { }",
    "Robot",
    "",
)


CHECKS = (
    unknown_frames, unknown_listed_frames, undeclared_frames, repetitions, other_robot
)  # fmt: skip


def of_transforms() -> Iterator[str]:
    model = analyse(STUB).model
    yield f"{frame_names(model)}"
    for text in TRANSFORMS:
        document, teller = read_transforms(text), Teller(text)
        yield f"## {text!r}"
        checks = (
            unknown_frames,
            unknown_listed_frames,
            undeclared_frames,
            repetitions,
            other_robot,
        )
        for check in checks:
            for message, start, end in check(document, model):
                yield f"{teller.span(start, end)}: {message}"


@pytest.mark.parametrize("of", [of_documents, of_losses, of_values, of_transforms])
def test_meanings_are_as_recorded(of: Callable[[], Iterator[str]]) -> None:
    assert_as_recorded(FOLDER / f"{of.__name__}.txt", of())
