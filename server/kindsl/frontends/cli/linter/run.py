"""A run of the linter: from paths to an outcome."""

import gc
import os
import sys
from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from kindsl.frontends.cli.documents.choices import Choices
from kindsl.frontends.cli.documents.sources import STDIN, UNNAMED
from kindsl.frontends.cli.documents.walking import documents
from kindsl.frontends.cli.linter.one_document import Checked, FixMode, Task, check
from kindsl.frontends.cli.outcome import Failure, LintedFile, RunOutcome, as_failures
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.file_names import TRANSFORMS_SUFFIX
from kindsl.judgement.config.robots import SUFFIX, TOOLS_FOLDERS
from kindsl.robots.interchange.syntaxes import JUDGED_SUFFIXES, XACRO_SUFFIX

if TYPE_CHECKING:
    from kindsl.judgement.config.configuration import Configuration

# How files end that are linted when a folder is named; robots in XML only if included.
_IN_XML = (*JUDGED_SUFFIXES, XACRO_SUFFIX)
_WALKED = (SUFFIX, TRANSFORMS_SUFFIX, *_IN_XML)
_FEW = 200
# The garbage of so many documents fits into memory.
_FEW_TO_COLLECT = 16
# Starting a process costs as much as linting some dozens of documents.
_FILES_PER_JOB = 48
_BATCH = 16


class LintPlan(NamedTuple):
    """The documents to lint, and the options.

    Attributes:
        paths: Documents, folders, `-`.
        choices: Decisions about the rules.
        stdin_name: Name of the document from stdin.
        fix_mode: How fixes are applied.
        with_unsafe: Whether unsafe fixes are wanted too.
        jobs: How many processes, 0 for as many as pay.
        is_quiet: Whether to show no progress.
        is_verbose: Whether the verdicts of the generators are asked for.
        excluded: Names of folders to leave out.
        baseline: Where what is found is written as known, which leaves out nothing as known.
    """

    paths: list[str]
    choices: Choices
    stdin_name: str = UNNAMED
    fix_mode: FixMode = FixMode.NONE
    with_unsafe: bool = False
    jobs: int = 0
    is_quiet: bool = False
    is_verbose: bool = False
    excluded: Collection[str] = TOOLS_FOLDERS
    baseline: str | None = None


def lint(plan: LintPlan) -> RunOutcome:
    """Lint all documents of a plan; a failure does not stop the others."""
    tasks, failures, configurations = _prepared(plan)
    if len(tasks) > _FEW_TO_COLLECT:
        gc.enable()
    files: list[LintedFile] = []
    for checked in _with_progress(check_all(tasks, plan.jobs), len(tasks), plan.is_quiet):
        files += [checked.file] if checked.file is not None else []
        files += checked.others
        failures += [checked.failure] if checked.failure is not None else []
    remarks: list[str] = []
    if plan.choices.decisions.bindings and not plan.is_quiet:
        from kindsl.frontends.cli.linter.unused_bindings import unused_on_command_line

        remarks += unused_on_command_line(files, plan.choices)
    if any(task.settings.known for task in tasks):
        from kindsl.frontends.cli.linter.known import stale_remarks

        remarks += stale_remarks(files, configurations)
    files += _unused(files, configurations, plan)
    outcome = RunOutcome(files, failures, remarks=remarks)
    if plan.baseline is None:
        return outcome
    from kindsl.frontends.cli.linter.known import with_baseline_written

    return with_baseline_written(outcome, plan.baseline)


def linted(plan: LintPlan) -> Iterator[str | Failure]:
    """Return the documents of a plan: in folders, robots in XML that a configuration includes."""

    def is_included(document: str) -> bool:
        if not document.lower().endswith(_IN_XML):
            return True
        try:
            configuration = plan.choices.configuration_for(document)
        except ConfigurationError:
            return True  # It is reported with the document.
        return configuration is not None and configuration.includes(document)

    return documents(plan.paths, plan.excluded, _WALKED, is_included)


def _prepared(plan: LintPlan) -> "tuple[list[Task], list[Failure], dict[str, Configuration]]":
    """Return tasks, failures of unreadable documents, and configurations by the path shown."""
    tasks: list[Task] = []
    failures: list[Failure] = []
    configurations: dict[str, Configuration] = {}
    for document in linted(plan):
        if isinstance(document, Failure):
            failures.append(document)
            continue
        shown = plan.stdin_name if document == STDIN else document
        try:
            configuration, settings = plan.choices.decided_for(shown)
            if plan.baseline is None and configuration is not None and configuration.baseline:
                from kindsl.judgement.config.baseline import known_findings

                settings = settings._replace(known=known_findings(configuration, shown))
        except ConfigurationError as error:
            failures += [found for found in as_failures(error) if found not in failures]
            continue
        if configuration is not None:
            configurations[shown] = configuration
        options = plan.fix_mode, plan.with_unsafe, plan.is_verbose
        tasks.append(Task(document, shown, settings, *options))
    return tasks, failures, configurations


def _unused(
    files: list[LintedFile], configurations: "dict[str, Configuration]", plan: LintPlan
) -> list[LintedFile]:
    named = any(found.has_bindings or found.twins for found in configurations.values())
    if STDIN in plan.paths or not named:
        return []
    from kindsl.frontends.cli.linter.unused_bindings import unused_bindings

    return unused_bindings(files, configurations, plan.choices, plan.excluded)


def _with_progress(found: Iterable[Checked], total: int, is_quiet: bool) -> Iterator[Checked]:
    if is_quiet or total < _FEW or not sys.stderr.isatty():
        yield from found
        return
    for number, checked in enumerate(found, 1):
        if number % (_FEW // 10) == 0:
            print(f"\rlinting {number} of {total}", end="", file=sys.stderr, flush=True)
        yield checked
    print("\r" + " " * os.get_terminal_size(sys.stderr.fileno()).columns + "\r", end="",
          file=sys.stderr, flush=True)  # fmt: skip


def check_all(tasks: Sequence[Task], jobs: int) -> Iterator[Checked]:
    """Yield the result of each task, in order.

    Args:
        jobs: How many processes to use, 0 for as many as pay.
    """
    has_affinity = hasattr(os, "sched_getaffinity")
    n_processors = len(os.sched_getaffinity(0)) if has_affinity else os.cpu_count() or 1
    jobs = min(jobs or min(n_processors, len(tasks) // _FILES_PER_JOB), len(tasks))
    if jobs < 2 or sys.platform == "emscripten":
        yield from map(check, tasks)
    else:
        yield from _in_processes(tasks, jobs)


def _in_processes(tasks: Sequence[Task], jobs: int) -> Iterator[Checked]:
    import multiprocessing
    import signal
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool

    method = "fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn"
    context = multiprocessing.get_context(method)
    done = 0
    # Ctrl-C ends the parent, which ends the others without a traceback of each.
    ignored = signal.SIGINT, signal.SIG_IGN
    with ProcessPoolExecutor(jobs, context, signal.signal, ignored) as pool:
        try:
            for checked in pool.map(check, tasks, chunksize=_BATCH):
                done += 1
                yield checked
        except BrokenProcessPool:
            for task in tasks[done:]:
                yield Checked(None, Failure(task.shown, "the process that linted it was killed"))
