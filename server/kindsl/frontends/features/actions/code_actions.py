"""Actions at a selection: fixes, fixes of all like it, suppressions, refactorings."""

from collections.abc import Callable, Iterator
from difflib import SequenceMatcher
from typing import TypeAlias

from kindsl.frontends.features.actions.action import CodeAction
from kindsl.frontends.features.actions.add_sections import add_missing, add_sections
from kindsl.frontends.features.actions.create_missing import create_missing
from kindsl.frontends.features.actions.move_inertia import move_inertia
from kindsl.frontends.features.actions.named_numbers import extract_parameter, inline_parameter
from kindsl.frontends.features.actions.sort_links import renumber_links, sort_links
from kindsl.frontends.features.actions.write_into_twin import write_into_twin
from kindsl.frontends.features.symbol_at import parameter_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.fix_trials import offered
from kindsl.judgement.analysis.fixing import fixed, is_safe, made
from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.language.semantics.declarations import ValueKind
from kindsl.language.syntax.indentation import indentation
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.facts import kept
from kindsl.language.text.lines import line_start, newline_of

FIX_ALL = "source.fixAll.kindsl"
QUICK_FIX = "quickfix"
# No kind of fix, so that no editor shows a bulb for a finding that can only be ignored.
IGNORE = "refactor.rewrite.suppress"
_Mending: TypeAlias = tuple[int, tuple[TextEdit, ...]]

_REFACTORINGS: tuple[Callable[[Analysis, int, int], Iterator[CodeAction]], ...] = (
    extract_parameter,
    inline_parameter,
    move_inertia,
    add_sections,
    renumber_links,
    sort_links,
)
_UNBOUND = "KD401"
_OMITTED = "KD008"


def code_actions(analysis: Analysis, start: int, end: int) -> tuple[CodeAction, ...]:
    """Return what can be done about a range: fixes first, to silence a finding last."""
    fixes = quick_fixes(analysis, start, end)
    known = {fix.edits for fix in fixes}
    return (
        *fixes,
        *bind_parameter(analysis, start, end),
        *write_into_twin(analysis, start, end),
        *(r for r in refactorings(analysis, start, end) if r.edits not in known),
        *suppressions(analysis, start, end),
    )


def quick_fixes(analysis: Analysis, start: int, end: int) -> tuple[CodeAction, ...]:
    """Return the fixes of the findings that touch a range, or whose fixes write there."""
    touched = offered(analysis, _mended(analysis, start, end))
    fixes = [_fix(finding, fix) for finding in touched for fix in _fixes_of(finding)]
    omitted = [d for d in touched if d.code == _OMITTED and d.fix is None]
    additions = [
        action._replace(kind=QUICK_FIX, diagnostics=(finding,))
        for finding in omitted
        for action in add_missing(analysis, finding.start)
    ]
    created = [action for finding in touched for action in create_missing(analysis, finding)]
    return (*fixes, *additions, *created, *_fixes_of_rules(analysis, touched))


def xml_actions(analysis: Analysis, start: int, end: int) -> tuple[CodeAction, ...]:
    """Return what can be done about a range of a robot in XML."""
    touched = offered(analysis, _mended(analysis, start, end))
    fixes = (_fix(finding, fix) for finding in touched for fix in _fixes_of(finding))
    return (*fixes, *suppressions(analysis, start, end))


@kept
def fix_all_action(analysis: Analysis) -> CodeAction | None:
    """Return the action that applies every safe fix, or None if there is nothing to fix."""
    edits = fix_all(analysis)
    return CodeAction("Apply all safe fixes", FIX_ALL, edits) if edits else None


def _fixes_of(finding: Diagnostic) -> tuple[TextFix, ...]:
    return finding.choices if finding.fix is None else (finding.fix,)


def _fix(finding: Diagnostic, fix: TextFix) -> CodeAction:
    return CodeAction(fix.title, QUICK_FIX, fix.edits, (finding,), is_preferred=fix.is_safe)


def _fixes_of_rules(analysis: Analysis, touched: list[Diagnostic]) -> Iterator[CodeAction]:
    for code in dict.fromkeys(finding.code for finding in touched if finding.fix is not None):
        found = offered(analysis, (d for d in analysis.findings if d.code == code))
        alike = tuple(d for d in found if d.fix is not None)
        n_mended, edits = _mending(analysis, code, alike) if len(alike) > 1 else (0, ())
        if n_mended > 1:
            title = f"Fix all {n_mended} findings of {code}"
            yield CodeAction(title, QUICK_FIX, edits, alike)


@kept
def _mendings(_: Analysis) -> dict[str, _Mending]:
    return {}


def _mending(analysis: Analysis, code: str, alike: tuple[Diagnostic, ...]) -> _Mending:
    """Return how many findings of a rule can be fixed together, and by what."""
    known = _mendings(analysis)
    if code not in known:
        done = made(analysis, alike)
        known[code] = (done.n_findings, done.rounds[0]) if done is not None else (0, ())
    return known[code]


def suppressions(analysis: Analysis, start: int, end: int) -> Iterator[CodeAction]:
    """Yield a comment for each finding at a range that a comment may silence."""
    touched = _touched(analysis, start, end)
    for code in dict.fromkeys(d.code for d in touched if not d.code.startswith("KD0")):
        finding = next(d for d in touched if d.code == code)
        is_xml = analysis.syntax.is_xml
        edit = _ignoring_xml(analysis, finding) if is_xml else _ignoring(analysis.text, finding)
        yield CodeAction(f"Ignore {code} here", IGNORE, (edit,), (finding,))


def _touched(analysis: Analysis, start: int, end: int) -> list[Diagnostic]:
    return [d for d in analysis.findings if d.start <= end and start <= d.end]


def _mended(analysis: Analysis, start: int, end: int) -> list[Diagnostic]:
    """Return the findings at a range, and behind them those whose fix writes words there anew."""

    def is_there(edit: TextEdit) -> bool:
        is_word = edit.start < edit.end and "\n" not in analysis.text[edit.start : edit.end]
        return is_word and edit.start <= end and start <= edit.end

    touched = _touched(analysis, start, end)
    others = (d for d in analysis.findings if d not in touched)
    return touched + [
        d for d in others if any(is_there(edit) for fix in _fixes_of(d) for edit in fix.edits)
    ]


def _ignoring(text: str, finding: Diagnostic) -> TextEdit:
    """Return the comment on a line of its own before the finding's, indented like it."""
    line = line_start(text, finding.start)
    comment = f"{indentation(text, finding.start)}// kindsl: ignore[{finding.code}]"
    return TextEdit(line, line, f"{comment}{newline_of(text)}")


def _ignoring_xml(analysis: Analysis, finding: Diagnostic) -> TextEdit:
    """Return the comment before the inertia, link or joint that a finding is in."""
    text, placed = analysis.text, analysis.syntax.island_at(finding.start)
    at = placed.start
    pending = list(placed.island.nodes)
    while pending:
        node = pending.pop()
        if node.start <= finding.start - placed.start < node.end:
            at = placed.start + node.start
            pending = list(node.nodes("inertia"))
    before = text[line_start(text, at) : at]
    behind = " " if before.strip() else f"{newline_of(text)}{before}"
    return TextEdit(at, at, f"<!-- kindsl: ignore[{finding.code}] -->{behind}")


def refactorings(analysis: Analysis, start: int, end: int) -> tuple[CodeAction, ...]:
    """Return the refactorings that make sense at a range."""
    return tuple(action for offer in _REFACTORINGS for action in offer(analysis, start, end))


def bind_parameter(analysis: Analysis, start: int, end: int) -> Iterator[CodeAction]:
    """Offer a binding for the parameter at a range, if it has no value.

    The value is a stand-in, 0.0 or for a dynamics parameter 1.0, to be replaced by the right one.
    """
    parameter = parameter_at(analysis, start, end)
    name = str(parameter.name) if parameter is not None else ""
    if parameter is None or name in analysis.context.values:
        return
    value = 1.0 if parameter.kind is ValueKind.DYNAMICS else 0.0
    first, _ = analysis.resolver.span(parameter.name)
    fixed = tuple(d for d in analysis.findings if d.code == _UNBOUND and d.start == first)
    title = f"Bind '{name}' in kindsl.toml"
    yield CodeAction(title, QUICK_FIX, (), fixed, bindings=((name, value),))


def fix_all(analysis: Analysis) -> tuple[TextEdit, ...]:
    """Return the edits that make every safe fix."""
    better, _, rounds = fixed(analysis, is_safe)
    return rounds[0] if len(rounds) == 1 else line_edits(analysis.text, better.text)


def line_edits(old: str, new: str) -> tuple[TextEdit, ...]:
    """Return the edits that turn one text into another, line by line."""
    before, after = old.splitlines(keepends=True), new.splitlines(keepends=True)
    starts = [0]
    for line in before:
        starts.append(starts[-1] + len(line))
    matcher = SequenceMatcher(None, before, after, autojunk=False)
    return tuple(
        TextEdit(starts[a], starts[b], "".join(after[c:d]))
        for tag, a, b, c, d in matcher.get_opcodes()
        if tag != "equal"
    )
