"""`--watch`: lints again whenever a document or a configuration changes."""

import gc
import os
import sys
import time
from collections.abc import Callable

from kindsl.frontends.cli.linter.run import LintPlan, lint, linted
from kindsl.frontends.cli.outcome import Failure, RunOutcome
from kindsl.judgement.analysis.twins import watched_files
from kindsl.judgement.config.baseline import baseline_path
from kindsl.judgement.config.configuration_reading import read_configuration
from kindsl.judgement.config.discovery import nearest_configuration
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.language.text.saves import Stamp, stamp

_PAUSE = 0.3
_CLEAR = "\x1b[2J\x1b[3J\x1b[H"


def watch(plan: LintPlan, report: Callable[[RunOutcome], int]) -> int:
    """Lint and report until interrupted; return the last report's status."""
    gc.enable()
    status = 0
    seen: dict[str, Stamp | None] = {}
    is_first = True
    try:
        while True:
            now = stamps(plan)
            if is_first or now != seen:
                is_first = False
                if sys.stdout.isatty():
                    print(_CLEAR, end="", flush=True)
                outcome = lint(plan._replace(choices=plan.choices.afresh()))
                status = report(outcome)
                print("watching for changes, Ctrl-C to stop", file=sys.stderr, flush=True)
                # As before the run: what was saved during it may not have been read.
                fixed = {file.path for file in outcome.files if file.n_fixed}
                seen = now | {path: stamp(path) for path in now.keys() & fixed}
            time.sleep(_PAUSE)
    except KeyboardInterrupt:
        return status


def stamps(plan: LintPlan) -> dict[str, Stamp | None]:
    """Return a fingerprint of each file that the outcome depends on."""
    found: dict[str, Stamp | None] = {}
    configurations: set[str] = set()
    for document in linted(plan):
        path = document.path if isinstance(document, Failure) else document
        found[path] = stamp(path)
        if plan.choices.configurations is not None:
            folder = os.path.dirname(os.path.abspath(path))
            configuration = plan.choices.configurations.fixed or nearest_configuration(folder)
            configurations |= {configuration} if configuration is not None else set()
    deciding = (file for path in configurations for file in (path, *_named_by(path)))
    return found | {file: stamp(file) for file in deciding}


def _named_by(path: str) -> list[str]:
    try:
        configuration = read_configuration(path)
        return [baseline_path(configuration), *watched_files(configuration.twin_files)]
    except ConfigurationError:
        return []
