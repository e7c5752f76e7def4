"""The parser's problems, as findings of the syntax rules, and the findings that they explain."""

from collections.abc import Iterator

from kindsl.judgement.rules.base import Finding, Rule, Severity, fix_of
from kindsl.judgement.rules.context import ROBCOGEN, ROBCOGEN2
from kindsl.judgement.rules.registry import all_rules
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.comment_problems import UNDECODABLE
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Island, Node, Problem, Token
from kindsl.language.text.facts import Fact, kept

_REPORT = "KD011"
_NAME_PLACE = 1
_PASTED = Fact[dict[int, Finding]]("findings of pasted passages")


def syntax_findings(model: Model, targets: frozenset[str]) -> Iterator[tuple[Rule, Finding]]:
    """Yield the problems of a document's islands and of the document as a whole.

    What robcogen2 reads all the same is no error, unless the document is for robcogen too.
    """
    problems = list(all_problems(model.document))
    if not problems:
        return
    rules = {rule.code: rule for rule in all_rules()}
    is_read = targets <= {ROBCOGEN2} and _is_read_by_robcogen2(model)
    # What else is wrong of a document of such numbers, a division by zero say, is no syntax.
    are_numbers = all(_is_foreign_number(*each) for each in problems)
    for island, problem in problems:
        finding = _pasted(model, island, problem) or _finding(island, problem)
        if (targets == {ROBCOGEN} and _is_foreign_comment(island, problem)) or (
            targets == {ROBCOGEN2}
            and (is_read or not are_numbers)
            and _is_foreign_number(island, problem)
        ):
            finding = finding._replace(severity=Severity.HINT)
        elif is_read:
            finding = finding._replace(severity=Severity.WARNING)
        yield rules[problem.code], finding


def _pasted(model: Model, island: Island, problem: Problem) -> Finding | None:
    """Return the finding of a passage of another format, None for other problems."""
    # Imported for broken documents only, since it delays the linter's start.
    from kindsl.language.syntax.passages import URDF_ELEMENTS

    at = Place(island, problem.start, problem.end)
    if problem.message == URDF_ELEMENTS:
        from kindsl.judgement.analysis.pasted_urdf import urdf_finding

        return urdf_finding(model, at)
    return _report(at) if problem.code == _REPORT else None


def _report(at: Place) -> Finding:
    """Return the finding of a report, which is read once."""
    from kindsl.judgement.rules.pasted_reports import report_finding

    known = at.island.facts.get(_PASTED) or at.island.facts.keep(_PASTED, {})
    if at.start not in known:
        known[at.start] = report_finding(at)
    return known[at.start]


def _is_read_by_robcogen2(model: Model) -> bool:
    # Imported for broken documents only, since it delays the linter's start.
    from kindsl.judgement.rules.robcogen2_loading import is_read_by_robcogen2

    return is_read_by_robcogen2(model)


def _is_foreign_comment(island: Island, problem: Problem) -> bool:
    """Return whether bytes of another encoding are in a comment, which RobCoGen ignores."""
    if not UNDECODABLE.fullmatch(island.text, problem.start, problem.end):
        return False
    return any(start <= problem.start < end for start, end in island.comments)


def _is_foreign_number(island: Island, problem: Problem) -> bool:
    """Return whether a value only has digits of another script, which robcogen2 reads as we do."""
    if problem.code != "KD004" or problem.repair is None:
        return False
    written = island.text[problem.start : problem.end]
    plain = "".join(str(int(c)) if c.isdecimal() else c for c in written)
    return "." in plain and plain == problem.repair.edits[0].text


def all_problems(document: SyntaxDocument) -> Iterator[tuple[Island, Problem]]:
    """Yield the problems with the islands that their offsets count from."""
    for island in document.islands:
        for problem in island.problems:
            yield island, problem
    for placed in document.problems:
        yield placed.island, placed.problem


def _finding(island: Island, problem: Problem) -> Finding:
    fix = fix_of(problem.repair, island) if problem.repair is not None else None
    choices = tuple(fix_of(repair, island) for repair in problem.choices)
    at = Place(island, problem.start, problem.end)
    return Finding(at, problem.message, fix=fix, choices=choices)


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
