"""Comments that silence findings: `// kindsl: ignore[KD301]`, `// kindsl: ignore-file[KD7]`.

The first silences its line, or the next line when it stands alone, or a whole block when the line
it silences begins one, or, in XML, the element that ends right before it. The second silences the
document. Errors of syntax cannot be silenced. Between the brackets stand codes or their beginnings,
with commas. What no rule has silences nothing.
"""

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kindsl.judgement.rules.registry import all_codes
from kindsl.language.semantics.lowering import OtherIsland
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.tree import Island, Node
from kindsl.language.syntax.vocabulary import of_kind
from kindsl.language.text.lines import line_start

_COMMENT = re.compile(r"kindsl:\s*(?:(ignore(?:-file)?)(?![\w-])\s*(?:\[([^\]\r\n]*)\])?)?")
_CODE = re.compile(r"[^,\s](?:[^,]*[^,\s])?")
_LINE_END = re.compile(r"\r\n|\n|\r|\Z")
_BLOCKS = of_kind("block", "pose", "list", "groups")


class Suppression(NamedTuple):
    """One code in one such comment.

    Attributes:
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


class Directive(NamedTuple):
    """A comment that speaks to us.

    Attributes:
        at: From `kindsl:` to the end of what is understood.
        word: `ignore`, `ignore-file`, or empty for what is neither.
        codes: Texts between the brackets, with places; None without brackets.
    """

    comment: Place
    at: Place
    word: str
    codes: tuple[tuple[str, Place], ...] | None


def suppressions(
    islands: Sequence[Island], starts: Sequence[int], length: int
) -> list[Suppression]:
    """Return what the comments of a document silence."""
    found: list[Suppression] = []
    for directive in (directive for island in islands for directive in directives(island)):
        known = [code for code in directive.codes or () if is_known(code[0])]
        covered = covered_by(islands, starts, length, directive) if known else (0, 0)
        found += [Suppression(code, at, directive.comment, *covered) for code, at in known]
    return found


def is_known(code: str) -> bool:
    """Return whether some rule has a code, or codes that begin so."""
    return code[:2].upper() == "KD" and any(c.startswith(code.upper()) for c in all_codes())


def directives(island: Island) -> Iterator[Directive]:
    """Yield the comments of an island that begin with `kindsl:`."""
    if "kindsl:" not in island.text:
        return
    for start, end in island.comments:
        match = _COMMENT.search(island.text, start, end)
        if match is not None and (match[2] is not None or _opens(island.text, start, match)):
            codes = None
            if match[2] is not None:
                inside = _CODE.finditer(island.text, *match.span(2))
                codes = tuple((c[0], Place(island, c.start(), c.end())) for c in inside)
            at = Place(island, match.start(), match.end())
            yield Directive(Place(island, start, end), at, match[1] or "", codes)


def _opens(text: str, start: int, match: re.Match[str]) -> bool:
    """Return whether a comment begins with a match; behind other words it may be prose."""
    return not text[start : match.start()].strip("/*<!- \t")


def covered_by(
    islands: Sequence[Island], starts: Sequence[int], length: int, directive: Directive
) -> tuple[int, int]:
    """Return the absolute range that a comment speaks of, in a document of some length."""
    if directive.word == "ignore-file":
        return 0, length + 1
    comment = directive.comment
    number = next(n for n, island in enumerate(islands) if island is comment.island)
    island = islands[number]
    line = line_start(island.text, comment.start)
    if island.text[line : comment.start].strip():
        end = len(island.text[: comment.start].rstrip())
        ended = next((node for node in _blocks(island) if node.end == end), None)
        if isinstance(island, OtherIsland) and ended is not None and ended.start < line:
            return starts[number] + ended.start, starts[number] + end
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
    row: Sequence[Node] = island.nodes
    while row:
        yield from (node for node in row if node.kind in _BLOCKS)
        row = [part for node in row for part in node.parts]


def _line_end(text: str, offset: int) -> int:
    return next(_LINE_END.finditer(text, offset)).end()
