"""The loading of a parsed document by robcogen2, step by step, up to the failing one.

The steps are those of robot-model-tools 0.3.0: references, connectivity, numbering, joint frames,
numbers. It names no place; the findings here do.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kindsl.judgement.rules.base import Finding
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Declarations, Joint, Link
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Name
from kindsl.language.syntax.document import Chunk, SyntaxDocument
from kindsl.language.syntax.parser import island_of_robcogen2
from kindsl.language.syntax.robcogen2_stop import stop_of_robcogen2
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.text.facts import Fact, kept
from kindsl.language.text.phrases import counted

_IS_SOUND = Fact[tuple[object, bool]]("whether robcogen2 reads the names")


class _Pair(NamedTuple):
    """A joint with the two links that it connects, by their names."""

    joint: Joint
    parent: str
    child: str


def is_read_by_robcogen2(model: Model) -> bool:
    """Return whether robcogen2 reads a document from its first character to its last number."""
    if stop_of_robcogen2(model.document) is not None:
        return False
    if model.broken_islands:
        island = island_of_robcogen2("".join(island.text for island in model.islands))
        model = Model(SyntaxDocument((Chunk((island,)),))) if island is not None else model
    return loading_defect(model) is None


def loading_defect(model: Model) -> Finding | None:
    """Return the defect that stops robcogen2 from loading a parsed document, None if none does."""
    if model.base is None:
        return next(_structural_defects(model), None)
    facts = model.edition.facts(Aspect.STRUCTURE | Aspect.SYMBOLS)
    is_sound = facts.made_of(_IS_SOUND, (), lambda: not any(_structural_defects(model)))
    steps = _numbers if is_sound else _structural_defects
    return next(steps(model), None)


def _structural_defects(model: Model) -> Iterator[Finding]:
    """Yield the defects that stop it before it converts a number."""
    for step in (_references, _numbering, _unused_joints):
        yield from step(model)


def _references(model: Model) -> Iterator[Finding]:
    links = Counter(str(link.name) for link in model.links)
    joints = Counter(str(joint.name) for joint in model.joints)
    frames = Counter(str(frame.name) for frame in model.frames)
    constants = Counter(str(c.name) for c in model.constants for _ in c.definitions)
    for body in model.bodies:
        if body.inertia is not None and body.inertia.frame is not None:
            yield from _resolved(body.inertia.frame, frames, "frame")
        for child in body.children:
            yield from _resolved(child.link, links, "link")
            yield from _resolved(child.joint, joints, "joint")
    for constant in model.constants:
        for use in constant.uses:
            if use.value is None:
                yield from _resolved(use.name, constants, "constant")


def _resolved(name: Name, known: Counter[str], what: str) -> Iterator[Finding]:
    if known[str(name)] != 1:
        number = known[str(name)]
        count = f"{counted(number, what)} have" if number else f"no {what} has"
        yield Finding(name, f"{count} the name '{name}'")


def _numbering(model: Model) -> Iterator[Finding]:
    pairs = _pairs(model)
    numbers = {str(body.name): body.id for body in model.bodies}
    connected = {name for pair in pairs for name in (pair.parent, pair.child)}
    base = model.bases[0].name
    names = {str(pair.joint.name) for pair in pairs}
    loose = next((body for body in model.bodies if str(body.name) not in connected), None)
    if loose is not None:
        yield Finding(loose.name, f"{_called(loose)} is not connected")
    elif len(numbers) != len(names) + 1:
        message = f"{counted(len(names), 'joint')} and {counted(len(numbers) - 1, 'link')}"
        yield Finding(base, f"{message} do not form a tree")
    else:
        yield from _unnumbered(model, pairs, numbers)


def _unnumbered(
    model: Model, pairs: Sequence[_Pair], numbers: dict[str, int | None]
) -> Iterator[Finding]:
    """Yield the first id that no link, and the first that no joint has.

    A joint has the greater id of its two links; the id of the link whose name it has, if any.
    """
    links = set(numbers.values())
    base = model.bases[0].name
    for number in range(len(numbers)):
        if number not in links:
            yield Finding(base, f"no link has the id {number}")
    taken: dict[int, Joint] = {}
    for pair in {(str(p.joint.name), p.joint.kind): p for p in pairs}.values():
        ends = [numbers[pair.parent] or 0, numbers[pair.child] or 0]
        own = numbers.get(str(pair.joint.name), max(ends)) or 0
        taken.setdefault(own, pair.joint)
    for number in range(1, len(numbers)):
        if number not in taken:
            yield _without_joint(model, number, pairs)


def _without_joint(model: Model, number: int, pairs: Sequence[_Pair]) -> Finding:
    clash = next((p.joint for p in pairs if str(p.joint.name) in model.body_named), None)
    if clash is not None:
        return Finding(clash.name, f"joint '{clash.name}' takes the id of the link of that name")
    link = next((link for link in model.links if link.id == number), model.bases[0])
    return Finding(link.name, f"no joint has {_called(link)} as the one with the greater id")


def _unused_joints(model: Model) -> Iterator[Finding]:
    used = {(str(pair.joint.name), pair.joint.kind) for pair in _pairs(model)}
    for joint in model.joints:
        if (str(joint.name), joint.kind) not in used:
            yield Finding(joint.name, f"joint '{joint.name}' is not used")


def _numbers(model: Model) -> Iterator[Finding]:
    """Yield the values that it cannot convert; those of a fixed base's inertia it does not try."""
    for chunk in model.document.chunks:
        yield from _unconverted_in(chunk)


@kept
def _unconverted_in(chunk: Chunk) -> list[Finding]:
    return [found for island in chunk.islands for found in _unconverted(island)]


def _tried(declared: Declarations) -> Iterator[Expression]:
    for joint in declared.joints:
        yield from joint.values()
    for body in declared.bodies():
        for frame in body.frames:
            yield from frame.values()
        if body.inertia is not None and (body.is_floating or not body.is_base):
            yield from body.inertia.values()


@kept
def _unconverted(island: Island) -> list[Finding]:
    found = []
    for value in _tried(declarations(island)):
        if value.literal is None or value.node.children[0].kind == "INT":
            try:
                _converted(value.node)
            except (TypeError, ZeroDivisionError, OverflowError) as error:
                found.append(Finding(value, f"value '{value.text}' has no number: {error}"))
    return found


def _converted(node: Node) -> float | int | None:
    """Return the number of an expression as Python computes it, None where a symbol is in it.

    Raises:
        TypeError: What is scaled is a whole number.
        ZeroDivisionError: It is divided by zero.
        OverflowError: A factor is too large.
    """
    parts = node.parts
    if node.kind not in ("divide", "multiply", "negate"):
        return _scaled(node)
    if node.kind == "negate":
        number = _converted(parts[0])
        return None if number is None else -number
    left, right = (_factor(part) for part in parts)
    if node.kind == "divide":
        number = _converted(parts[0])
        return None if number is None or right is None else number / right
    number = _converted(parts[1])
    return None if number is None or left is None else left * number


def _scaled(node: Node) -> float | int | None:
    number = _factor(node)
    if isinstance(number, int):
        raise TypeError("it is a whole number")
    return number


def _factor(node: Node) -> float | int | None:
    token = node.children[0]
    if node.kind != "number" or not isinstance(token, Token):
        return None
    return int(token.text) if token.kind == "INT" else float(token.text)


def _pairs(model: Model) -> list[_Pair]:
    """Return the pairs of a model whose references are sound."""
    return [
        _Pair(model.joint_named[str(child.joint)], str(body.name), str(child.link))
        for body in model.bodies
        for child in body.children
    ]


def _called(body: Link) -> str:
    return f"{'base' if body.is_base else 'link'} '{body.name}'"
