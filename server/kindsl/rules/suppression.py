"""Comments that silence findings: `// kindsl: ignore[KD301]`, `// kindsl: ignore-file[KD7]`.

The first silences its line, or the next line when it stands alone, or a whole block when the line
it silences begins one. The second silences the document. Errors of syntax cannot be silenced.
"""

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kindsl.semantics.places import Place
from kindsl.syntax.tree import Island, Node

_COMMENT = re.compile(r"kindsl:\s*(ignore(?:-file)?)\s*\[([^\]]*)\]")
_CODE = re.compile(r"[A-Za-z]+\d*")
_LINE_END = re.compile(r"\r\n|\n|\r|\Z")
_BLOCKS = frozenset(
    ("base", "link", "joint", "inertia", "children", "frames", "frame", "joint_frame")
)


class Suppression(NamedTuple):
    """One code in one such comment.

    Attributes:
        code: A code or a prefix of codes.
        at: Where the code stands.
        comment: The whole comment.
        start: Absolute start of what it silences.
        end: Absolute end of what it silences.
    """

    code: str
    at: Place
    comment: Place
    start: int
    end: int

    def covers(self, code: str, start: int) -> bool:
        """Return whether it silences a finding of a code that starts at an absolute offset."""
        return (
            self.start <= start < max(self.end, self.start + 1)
            and code.startswith(self.code.upper())
            and not code.startswith("KD0")
        )


def suppressions(
    islands: Sequence[Island], starts: Sequence[int], length: int
) -> list[Suppression]:
    """Return what the comments of a document silence."""
    found: list[Suppression] = []
    for number, island in enumerate(islands):
        for comment, is_file, codes in _comments(island):
            if is_file:
                covered = 0, length + 1
            else:
                covered = _covered(islands, starts, number, comment)
            found += [Suppression(code, at, comment, *covered) for code, at in codes]
    return found


def _comments(island: Island) -> Iterator[tuple[Place, bool, list[tuple[str, Place]]]]:
    if "kindsl:" not in island.text:
        return
    for start, end in island.comments:
        match = _COMMENT.search(island.text, start, end)
        if match:
            codes = [
                (code[0], Place(island, code.start(), code.end()))
                for code in _CODE.finditer(island.text, *match.span(2))
            ]
            yield Place(island, start, end), match[1] == "ignore-file", codes


def _covered(
    islands: Sequence[Island], starts: Sequence[int], number: int, comment: Place
) -> tuple[int, int]:
    """Return the absolute range that a comment in island `number` silences."""
    island = islands[number]
    line = max(island.text.rfind("\n", 0, comment.start), island.text.rfind("\r", 0, comment.start))
    line += 1
    if island.text[line : comment.start].strip():
        return _line_or_block(island, starts[number], line)
    after = _line_end(island.text, comment.end)
    if after < len(island.text) or number + 1 == len(islands):
        return _line_or_block(island, starts[number], after)
    return _line_or_block(islands[number + 1], starts[number + 1], 0)


def _line_or_block(island: Island, origin: int, line: int) -> tuple[int, int]:
    end = _line_end(island.text, line)
    block = next((n for n in _blocks(island) if line <= n.start < end), None)
    return origin + line, origin + (block.end if block is not None else end)


def _blocks(island: Island) -> Iterator[Node]:
    """Yield nested blocks, outer ones first."""
    row = [node for node in island.nodes if node.kind != "head"]
    while row:
        yield from (node for node in row if node.kind in _BLOCKS)
        row = [child for node in row for child in node.children if isinstance(child, Node)]


def _line_end(text: str, offset: int) -> int:
    match = _LINE_END.search(text, offset)
    return match.end() if match else len(text)
