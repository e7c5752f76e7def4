"""Findings that a mistake of syntax explains: their section was repaired to be read."""

from kindsl.judgement.rules.base import Finding
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.text.facts import kept

_NAME_PLACE = 1


def is_explained(finding: Finding) -> bool:
    """Return whether a finding is where syntax was repaired, so that it may be about the repair."""
    island, at = finding.at.island, finding.at
    if not island.problems:
        return False
    return any(start <= at.start and at.end <= end for start, end in _repaired_spans(island))


@kept
def _repaired_spans(island: Island) -> list[tuple[int, int]]:
    return [span for node in island.nodes for span in _spans(island, node)]


def _spans(island: Island, block: Node) -> list[tuple[int, int]]:
    """Return the spans of a block's repaired head and sections; a nameless block whole."""
    # Imported for broken islands only, since it delays the linter's start.
    from kindsl.language.syntax.mending import is_repaired

    skipped = [token.start for token in island.skipped]
    head = [child for child in block.children[:4] if isinstance(child, Token)]
    if len(head) > _NAME_PLACE and head[_NAME_PLACE].is_missing:
        return [(block.start, block.end)]
    spans = []
    if any(map(is_repaired, head)):
        spans.append((head[0].start, head[-1].end))
    for section in block.children:
        if isinstance(section, Node):
            start, end = section.start, section.end
            is_cut = any(start <= place < end for place in skipped)
            if is_cut or any(map(is_repaired, section.tokens())):
                spans.append((start, end))
    return spans
