"""Constructs that only one of the two generators takes, island by island.

Nothing here is an error of the language; it is reported to a project that names its target.
"""

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kindsl.language.syntax.comment_problems import is_open
from kindsl.language.syntax.insertions import removed
from kindsl.language.syntax.sections import title
from kindsl.language.syntax.tables import HOLDS, ONLY
from kindsl.language.syntax.token_names import shown
from kindsl.language.syntax.tree import Edit, Island, Node, Repair, Token
from kindsl.language.syntax.value_forms import (
    TARGETS_OF_ALL,
    accepted_by,
    form_kind,
    formed_values,
    targets_of,
)
from kindsl.language.syntax.values import LARGEST_ID, size_of
from kindsl.language.syntax.vocabulary import BLOCKS, SECTIONS, VALUE_TERMINALS
from kindsl.language.text.facts import kept

ROBCOGEN, ROBCOGEN2 = "robcogen", "robcogen2"

_PLAIN_ID = re.compile(r"[1-9][0-9]*")
_BLOCKS = frozenset({"head", *BLOCKS})
_SECTIONS_OF_ONE = SECTIONS.keys() & ONLY.keys()
# Numbers are reported with their value.
_REFUSED = ONLY.keys() - VALUE_TERMINALS
_PERHAPS_REFUSED = _REFUSED | {"NAME"}
_CALLED = {
    "ESCAPED_NAME": ("escaped-name", "the escaped name '{}'"),
    "KEYWORD_NAME": ("keyword-as-name", "the keyword '{}' as a name"),
    "UNICODE_NAME": ("non-ascii-name", "the letters of the name '{}'"),
}


class PortabilityNote(NamedTuple):
    """A construct that one target refuses.

    Attributes:
        kind: Its kind, in kebab case; `missing-inertia` is also a rule of its own.
        repair: A rewrite that both targets take, where there is one.
    """

    target: str
    kind: str
    message: str
    start: int
    end: int
    repair: Repair | None = None


@kept
def portability(island: Island) -> tuple[PortabilityNote, ...]:
    """Return what one of the targets refuses in an island, in order; kept with the island."""
    return tuple(sorted(_notes(island), key=lambda note: (note.start, note.end, note.target)))


def _notes(island: Island) -> Iterator[PortabilityNote]:
    yield from _comment_notes(island)
    blocks = [block for block in island.nodes if block.kind in _BLOCKS]
    refused: list[PortabilityNote] = []
    for block in blocks if _SECTIONS_OF_ONE else ():
        refused += _section_notes(island.text, block)
    yield from refused
    for note in _notes_within(island, blocks):
        if not any(_is_within(note, section) for section in refused):
            yield note


def _notes_within(island: Island, blocks: Sequence[Node]) -> Iterator[PortabilityNote]:
    in_blocks = [token for block in blocks for token in block.tokens()] if island.skipped else ()
    yield from _token_notes(in_blocks if island.skipped else island.tokens)
    yield from _value_notes(island)
    for block in blocks:
        yield from _id_notes(block)
        yield from _inertia_notes(block)


def _section_notes(text: str, block: Node) -> Iterator[PortabilityNote]:
    for node in block.parts:
        if node.kind in _SECTIONS_OF_ONE:
            word = next(node.tokens())
            for target in TARGETS_OF_ALL - targets_of(node.kind):
                edit = removed(text, word, node.end)
                repair = Repair(f"Remove '{word.text}'", (edit,), False)
                message = f"{target} does not take '{word.text}'"
                yield PortabilityNote(target, "section", message, node.start, node.end, repair)
        elif node.kind in HOLDS:
            yield from _section_notes(text, node)


def _is_within(note: PortabilityNote, section: PortabilityNote) -> bool:
    is_inside = section.start <= note.start and note.end <= section.end
    return is_inside and note.target == section.target


def _comment_notes(island: Island) -> Iterator[PortabilityNote]:
    text = island.text
    for start, end in island.comments:
        if text.startswith("/*", start):
            if is_open(text, start, end):
                continue
            repair = _line_comments(text, start, end)
            for target in TARGETS_OF_ALL - targets_of("BLOCK_COMMENT"):
                message = f"{target} does not take the comment '/* */'"
                yield PortabilityNote(target, "block-comment", message, start, end, repair)
        elif text[end : end + 1] == "\r" and text[end + 1 : end + 2] != "\n":
            message = "robcogen does not end a comment at a lone carriage return"
            repair = Repair("Write a line feed", (Edit(end, end + 1, "\n"),), True)
            yield PortabilityNote(ROBCOGEN, "comment-end", message, start, end, repair)


def _line_comments(text: str, start: int, end: int) -> Repair | None:
    """Return the rewrite to `//`, None where code follows on the comment's last line."""
    if text[end : end + 200].split("\n")[0].strip():
        return None
    lines = text[start + 2 : end - 2].replace("\r\n", "\n").replace("\r", "\n").split("\n")
    indent = " " * (start - text.rfind("\n", 0, start) - 1)
    bodies = [re.sub(r"^\s*\*?\s?", "", line) if i else line for i, line in enumerate(lines)]
    kept = [body.rstrip() for body in bodies]
    if len(kept) > 1 and not kept[-1]:
        kept.pop()
    new = f"\n{indent}".join(f"// {body.strip()}".rstrip() for body in kept)
    return Repair("Write '//' comments", (Edit(start, end, new),), True)


def _token_notes(tokens: Sequence[Token]) -> Iterator[PortabilityNote]:
    previous: Token | None = None
    for token in tokens:
        if token.start == token.end:
            continue
        if token.kind in _PERHAPS_REFUSED:
            yield from _name_notes(token)
        if previous is not None and previous.end == token.start and token.text[:1].isidentifier():
            yield from _glue_notes(previous, token)
        previous = token


def _name_notes(token: Token) -> Iterator[PortabilityNote]:
    kind = form_kind(token)
    if kind not in _REFUSED:
        return
    name, what = _CALLED.get(kind, (kind.lower().replace("_", "-"), "'{}'"))
    for target in TARGETS_OF_ALL - targets_of(kind):
        message = f"{target} does not take {what.format(shown(token.text))}"
        yield PortabilityNote(target, name, message, token.start, token.end)


def _glue_notes(left: Token, right: Token) -> Iterator[PortabilityNote]:
    place = right.start
    repair = Repair("Insert a blank", (Edit(place, place, " "),), True)
    if left.text[:1].isidentifier():
        message = f"robcogen reads '{shown(left.text + right.text)}' as one name"
        yield PortabilityNote(ROBCOGEN, "glued-keyword", message, left.start, right.end, repair)
    elif left.kind == "FLOAT" and right.kind != "NAME" and not right.kind.endswith("PI"):
        message = f"robcogen2 does not take '{shown(right.text)}' right behind a number"
        yield PortabilityNote(ROBCOGEN2, "glued-number", message, left.start, right.end, repair)


def _value_notes(island: Island) -> Iterator[PortabilityNote]:
    text = island.text
    for node in formed_values(island):
        tokens = list(node.tokens())
        if any(token.is_missing for token in tokens):
            continue
        targets = accepted_by(tokens)
        if len(targets) != 1 or _is_reported(island, node):
            continue
        (target,) = TARGETS_OF_ALL - targets
        if any(note.target == target for token in tokens for note in _name_notes(token)):
            continue
        start, end = node.start, node.end
        message = f"{target} does not take the form of '{shown(text[start:end])}'"
        if node.kind == "parameter" and target == ROBCOGEN2:
            message = f"robcogen2 reads '{shown(text[start:end])}' as 'pi' and stops"
        # Decimals cost the linter's start, and most documents need none.
        from kindsl.language.syntax.rewriting import rewritten

        new = rewritten(node)
        repair = Repair(f"Write {new}", (Edit(start, end, new),), True) if new else None
        yield PortabilityNote(target, "value-form", message, start, end, repair)


def _is_reported(island: Island, node: Node) -> bool:
    return any(p.start < node.end and node.start < p.end for p in island.problems)


def _id_notes(block: Node) -> Iterator[PortabilityNote]:
    for node in block.nodes("id") if block.kind != "base" else ():
        token = node.children[-1]
        if not isinstance(token, Token) or token.is_missing or token.kind != "INT":
            continue
        size = size_of(token.text)
        if block.kind == "link" and not 0 < size <= LARGEST_ID:
            continue
        message = f"robcogen does not take the id '{shown(token.text)}'"
        repair = None
        if 0 < size <= LARGEST_ID:
            if _PLAIN_ID.fullmatch(token.text):
                continue
            new = str(size)
            repair = Repair(f"Write {new}", (Edit(token.start, token.end, new),), True)
        yield PortabilityNote(ROBCOGEN, "id-form", message, token.start, token.end, repair)


def _inertia_notes(block: Node) -> Iterator[PortabilityNote]:
    if block.kind not in ("base", "link") or any(block.nodes("inertia")):
        return
    keyword, name = block.children[:2]
    message = f"robcogen does not take {title(block)} without 'inertia_params'"
    yield PortabilityNote(ROBCOGEN, "missing-inertia", message, keyword.start, name.end)
