"""Findings that a baseline knows: silent until the block that they are in changes.

What identifies a finding is its rule, the words of its block and its place among them. Lines,
blanks, comments and other blocks do not matter.
"""

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import accumulate
from typing import NamedTuple

from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings, is_enabled
from kindsl.judgement.rules.registry import rule_named
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.scanner import scan


class Apart(NamedTuple):
    """The findings of a document.

    Attributes:
        stale: Findings of the baseline, of rules that ran, that are no longer there.
    """

    reported: Sequence[Diagnostic] = ()
    known: Sequence[Diagnostic] = ()
    stale: Sequence[str] = ()


def blocks_of(syntax: SyntaxDocument) -> list[str]:
    """Return the texts of a robot's blocks, which together are its text."""
    return [island.text for island in syntax.islands]


def lines_of(text: str) -> list[str]:
    """Return the lines of a text that has no blocks."""
    return text.splitlines(keepends=True)


def set_apart(findings: Sequence[Diagnostic], blocks: Sequence[str], settings: Settings) -> Apart:
    """Return which findings are reported, and which are known."""
    left = Counter(settings.known)
    reported: list[Diagnostic] = []
    known: list[Diagnostic] = []
    for finding, identity in zip(findings, identities(findings, blocks), strict=True):
        is_known = left[identity] > 0
        left[identity] -= is_known
        (known if is_known else reported).append(finding)
    return Apart(reported, known, [one for one in left.elements() if _has_run(one, settings)])


def identities(findings: Iterable[Diagnostic], blocks: Sequence[str]) -> Iterator[str]:
    """Yield what identifies each finding: its code, its block's title and words, its place."""
    starts = [0, *accumulate(map(len, blocks))]
    seen: dict[int, tuple[str, list[int]]] = {}
    for finding in findings:
        number = min(bisect_right(starts, finding.start), max(len(blocks), 1)) - 1
        if number not in seen:
            seen[number] = _words(blocks[number] if blocks else "")
        block, places = seen[number]
        yield f"{finding.code} {block}:{bisect_right(places, finding.start - starts[number])}"


def _has_run(identity: str, settings: Settings) -> bool:
    rule = rule_named(identity.partition(" ")[0])
    return rule is None or is_enabled(rule, settings)


def _words(block: str) -> tuple[str, list[int]]:
    """Return a block's title with a digest of its words, and where these begin."""
    from hashlib import sha256

    tokens = scan(block)
    digest = sha256("\0".join(token.text for token in tokens).encode("utf-8", "surrogatepass"))
    title = " ".join(token.text for token in tokens[:2])[:40]
    return f"{title} {digest.hexdigest()[:16]}", [token.start for token in tokens]
