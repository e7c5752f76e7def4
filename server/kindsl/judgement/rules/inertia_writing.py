"""Changes that give a body the mass properties that a pasted passage has."""

from kindsl.judgement.rules.base import Replacement
from kindsl.language.semantics.declarations import Inertia, Link
from kindsl.language.semantics.places import Place, with_lines
from kindsl.language.semantics.unknown import inertia_expressions
from kindsl.language.syntax.insertions import section_indent
from kindsl.language.syntax.vocabulary import words_of
from kindsl.language.text.lines import line_start, newline_of
from kindsl.mechanics.rigid.body import NO_BODY
from kindsl.robots.cad.properties import MassProperties


def body_around(bodies: tuple[Link, ...], at: Place) -> Link | None:
    """Return the body in whose braces a passage stands."""
    return next((body for body in bodies if body.start < at.start and at.end <= body.end), None)


def inertia_changes(body: Link, found: MassProperties, at: Place) -> tuple[Replacement, ...]:
    """Return the changes that replace a passage, or the old inertia, with mass properties.

    An inertia that is whole keeps its layout and its comments.
    """
    inertia, sections = body.inertia, body.node.parts
    ids = [section for section in sections if section.kind == "id"]
    if inertia is None and all(
        section.end <= at.start if section in ids else at.end <= section.start
        for section in sections
    ):
        start = line_start(at.island.text, at.start)
        block = _block(body, found)
        if at.island.text[start : at.start].strip():
            start, block = at.start, block.lstrip()
        return (Replacement(Place(body.island, start, at.end), block),)
    changes = new_inertia(body, found)
    if inertia is not None and len(changes) == 1 and inertia.start <= at.start <= inertia.end:
        return changes
    return (Replacement(with_lines(at), ""), *changes)


def new_inertia(body: Link, found: MassProperties) -> tuple[Replacement, ...]:
    """Return the changes that give a body other mass properties, wherever they come from."""
    inertia = body.inertia
    if inertia is None:
        ids = list(body.node.nodes("id"))
        behind = ids[0] if ids else next(c for c in body.node.children if c.kind == "{")
        new = f"{newline_of(body.island.text)}{_block(body, found)}"
        return (Replacement(Place(body.island, behind.end, behind.end), new),)
    if _is_whole(inertia) and _frame(body, found) == (inertia.frame or ""):
        texts = (found.mass, *found.com, *found.moments)
        return tuple(map(Replacement, inertia_expressions(inertia), texts))
    block = _block(body, found).lstrip()
    return (Replacement(Place(body.island, inertia.start, inertia.end), block),)


def _block(body: Link, found: MassProperties) -> str:
    text, inertia = body.island.text, body.inertia
    indent = section_indent(text, body.node)
    keyword = next(inertia.node.tokens()).text if inertia is not None else words_of("inertia")[0]
    block = found.block(keyword, indent, _frame(body, found))
    return indent + block.replace("\n", newline_of(text))


def _frame(body: Link, found: MassProperties) -> str:
    """Return the frame of the numbers: the one named in the passage, else the previous one."""
    if found.system in {str(frame.name) for frame in body.frames}:
        return found.system
    return str(body.inertia.frame or "") if body.inertia is not None else ""


def _is_whole(inertia: Inertia) -> bool:
    values = inertia_expressions(inertia)
    return len(values) == len(NO_BODY.numbers) and all(v.start < v.end for v in values)
