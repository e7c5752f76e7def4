"""Add the missing sections of a block, in the grammar's order."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kindsl.frontends.features.actions.action import REWRITE, CodeAction
from kindsl.frontends.features.completion import snippets
from kindsl.frontends.features.completion.item import without_placeholders
from kindsl.frontends.features.completion.names import next_id
from kindsl.frontends.features.tree_path import path_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.syntax.document import PlacedIsland
from kindsl.language.syntax.insertions import inserted_section
from kindsl.language.syntax.sections import ORDER
from kindsl.language.syntax.tables import KINDS
from kindsl.language.syntax.tree import Node
from kindsl.language.syntax.vocabulary import words_of
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.phrases import listed

_BLOCKS = ORDER.keys() - {"document"}
_TITLES = {"inertia": "Add an inertia section", "frames": "Add a frames section"}


class _AddedSection(NamedTuple):
    kind: str
    lines: tuple[str, ...]


def add_sections(analysis: Analysis, start: int, _end: int) -> Iterator[CodeAction]:
    """Offer the sections that the block at a range requires, at its head the optional ones too."""
    yield from add_missing(analysis, start)
    place = analysis.syntax.island_at(start)
    block = _innermost_block(place, start)
    if block is None or not block.start <= start - place.start <= block.children[1].end:
        return
    for section in _missing(analysis, block):
        if section.kind in _TITLES:
            yield from _action(_TITLES[section.kind], place, block, [section])


def add_missing(analysis: Analysis, start: int) -> Iterator[CodeAction]:
    """Offer the missing required sections of the innermost block at an offset."""
    place = analysis.syntax.island_at(start)
    block = _innermost_block(place, start)
    if block is None:
        return
    needed = [s for s in _missing(analysis, block) if ORDER[block.kind][s.kind].is_needed]
    if needed:
        words = listed(dict.fromkeys(f"'{s.lines[0].split(' ')[0]}'" for s in needed))
        yield from _action(f"Add the missing {words}", place, block, needed)


def _innermost_block(place: PlacedIsland, offset: int) -> Node | None:
    path = path_at(place.island, offset - place.start)
    return next((node for node in reversed(path) if node.kind in _BLOCKS), None)


def _missing(analysis: Analysis, block: Node) -> Iterator[_AddedSection]:
    there = {child.kind for child in block.children}
    for kind in ORDER[block.kind]:
        if KINDS[kind] == "moments":
            present = {next(node.tokens()).text for node in block.nodes(kind)}
            for name, default in snippets.MOMENT_DEFAULTS.items():
                if name not in present:
                    yield _AddedSection(kind, (f"{name} = {default}",))
        elif kind not in there:
            yield _AddedSection(kind, tuple(_text(analysis, kind).split("\n")))


def _text(analysis: Analysis, kind: str) -> str:
    what = KINDS[kind]
    if what == "whole":
        return f"{words_of(kind)[0]} = {next_id(analysis)}"
    if what == "list":
        return f"{words_of(kind)[0]} {{}}"
    return without_placeholders(snippets.section(kind))


def _action(
    title: str, place: PlacedIsland, block: Node, sections: Sequence[_AddedSection]
) -> Iterator[CodeAction]:
    """Yield the action that inserts sections; those for one place become one edit."""
    edits: dict[int, TextEdit] = {}
    for section in sections:
        behind = _section_before(block, section.kind)
        edit = inserted_section(place.island.text, block, behind, section.lines)
        if edit is None:
            return
        at = place.start + edit.start
        known = edits.get(at)
        new = edit.text if known is None else known.text.rstrip(" ") + edit.text
        edits[at] = TextEdit(at, at, new)
    yield CodeAction(title, REWRITE, tuple(edits.values()))


def _section_before(block: Node, kind: str) -> Node | None:
    order = ORDER[block.kind]
    rank = order[kind].rank
    for child in reversed(block.children):
        if isinstance(child, Node) and child.kind in order and order[child.kind].rank <= rank:
            return child
    return None
