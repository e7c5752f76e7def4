"""One run of `kindsl lint`: options in, report and exit status out."""

import sys
from collections.abc import Sequence
from typing import Any

from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.documents.choices import choices_of
from kindsl.frontends.cli.documents.sources import STDIN, UNNAMED
from kindsl.frontends.cli.linter.one_document import FixMode
from kindsl.frontends.cli.linter.run import LintPlan, lint
from kindsl.frontends.cli.outcome import Failure, RunOutcome, UnknownRuleError, as_failures
from kindsl.frontends.cli.output import renderer
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.robots import TOOLS_FOLDERS
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.printable import printable

OK = 0
FINDINGS = 1
UNUSABLE = 2
INTERRUPTED = 130
_COUNTABLE = ("text", "json")


def run_lint(args: Any) -> int:
    """Lint, report.

    Returns:
        0 without errors (and at most as many warnings as allowed), 1 with findings, 2 for wrong
        usage, a document that cannot be read, or a defect of ours.
    """
    try:
        if not (args.list_rules or args.explain is not None):
            return _lint_and_report(args)
        from kindsl.frontends.cli.output.rule_pages import pages

        write(sys.stdout, pages(args.explain, args.output_format))
        return OK
    except ConfigurationError as error:
        _write_failures(as_failures(error))
        return UNUSABLE
    except UnknownRuleError as error:
        write(sys.stderr, f"kdsl-lint: error: {error}\n")
        return UNUSABLE
    except KeyboardInterrupt:
        return INTERRUPTED


def _wrong_usage(args: Any) -> str:
    if args.statistics and args.output_format not in _COUNTABLE:
        return f"--statistics is available as text or JSON only, not as {args.output_format}"
    if args.watch and STDIN in args.paths:
        return "--watch cannot watch stdin"
    if args.write_baseline is not None and (args.watch or args.diff):
        return f"--write-baseline cannot be used with {'--watch' if args.watch else '--diff'}"
    if args.unsafe_fixes and not (args.fix or args.diff):
        return "--unsafe-fixes needs --fix or --diff"
    return ""


def _plan(args: Any) -> LintPlan:
    fix_mode = FixMode.SHOWN if args.diff else FixMode.WRITTEN if args.fix else FixMode.NONE
    return LintPlan(
        args.paths or ["."],
        choices_of(args),
        args.stdin_filename or UNNAMED,
        fix_mode,
        args.unsafe_fixes,
        args.jobs,
        args.quiet,
        args.verbose,
        frozenset() if args.no_default_exclude else TOOLS_FOLDERS,
        baseline=args.write_baseline,
    )


def _lint_and_report(args: Any) -> int:
    wrong = _wrong_usage(args)
    if wrong:
        write(sys.stderr, f"kdsl-lint: error: {wrong}\n")
        return UNUSABLE
    plan = _plan(args)
    if args.watch:
        from kindsl.frontends.cli.linter.watching import watch

        return watch(plan, lambda outcome: _report(outcome, args))
    return _report(lint(plan), args)


def _report(outcome: RunOutcome, args: Any) -> int:
    _write_failures(outcome.failures)
    write(sys.stderr, "".join(f"{printable(remark)}\n" for remark in outcome.remarks))
    n_warnings, most = outcome.count(Severity.WARNING), args.max_warnings
    is_over = most is not None and n_warnings > most
    failing = frozenset((Severity.ERROR, Severity.WARNING) if is_over else (Severity.ERROR,))
    failing = frozenset() if args.exit_zero else failing
    outcome = outcome._replace(failing=failing, is_verbose=args.verbose)
    if args.diff:
        return _report_diff(outcome, args)
    is_mended_stdin = args.fix and STDIN in args.paths
    if is_mended_stdin:
        named = args.stdin_filename or UNNAMED
        write(sys.stdout, "".join(f.text for f in outcome.files if f.path == named))
    write(sys.stderr if is_mended_stdin else sys.stdout, _rendered(outcome, args))
    status = FINDINGS if any(map(outcome.count, failing)) else OK
    if args.output_format == "text" and not args.quiet:
        from kindsl.frontends.cli.linter.summary import summary

        write(sys.stderr, summary(outcome))
    if args.verbose:
        from kindsl.frontends.cli.linter.summary import verdict_lines

        write(sys.stderr, verdict_lines(outcome.files))
    return UNUSABLE if outcome.failures else status


def _rendered(outcome: RunOutcome, args: Any) -> str:
    if args.statistics:
        from kindsl.frontends.cli.linter.summary import statistics

        return statistics(outcome, is_json=args.output_format == "json")
    return renderer(args.output_format)(outcome)


def _report_diff(outcome: RunOutcome, args: Any) -> int:
    from kindsl.language.text.unified_diff import unified_diff

    diffs = [unified_diff(file.path, file.original, file.text) for file in outcome.files]
    write(sys.stdout, "".join(diffs))
    if outcome.failures:
        return UNUSABLE
    return FINDINGS if any(diffs) and not args.exit_zero else OK


def _write_failures(failures: Sequence[Failure]) -> None:
    write(sys.stderr, "".join(f"{printable(str(failure))}\n" for failure in failures))
