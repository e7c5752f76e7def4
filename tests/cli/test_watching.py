"""`--watch`."""

from pathlib import Path

import pytest
from tests.cli.samples import GOOD, INTEGER, UNBOUND

from kindsl.frontends.cli.documents.choices import Choices
from kindsl.frontends.cli.linter import watching
from kindsl.frontends.cli.linter.one_document import FixMode
from kindsl.frontends.cli.linter.run import LintPlan
from kindsl.frontends.cli.outcome import RunOutcome
from kindsl.judgement.config.discovery import Configurations


def test_lints_again_when_something_changes(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Each pause changes a file; the last one is interrupted."""
    document, configuration = folder / "a.kindsl", folder / "kindsl.toml"
    document.write_text(GOOD)
    steps = [
        lambda: document.write_text(INTEGER),
        lambda: None,
        lambda: (folder / "b.kindsl").write_text(UNBOUND),
        lambda: configuration.write_text("[parameters]\nlength = 1.0\n"),
        document.unlink,
    ]

    def pause(_: float) -> None:
        if not steps:
            raise KeyboardInterrupt
        steps.pop(0)()

    found: list[list[str]] = []

    def report(outcome: RunOutcome) -> int:
        found.append([finding.code for file in outcome.files for finding in file.findings])
        return len(found)

    monkeypatch.setattr(watching.time, "sleep", pause)
    plan = LintPlan(["."], Choices(configurations=Configurations()), is_quiet=True)
    assert watching.watch(plan, report) == 5
    assert found == [[], ["KD005"], ["KD005", "KD401"], ["KD005"], []]
    assert capsys.readouterr().err.count("watching") == 5


def look_three_times(monkeypatch: pytest.MonkeyPatch) -> None:
    """Stop when it has looked for changes three times."""
    looks = iter(range(2))

    def pause(_: float) -> None:
        if next(looks, None) is None:
            raise KeyboardInterrupt

    monkeypatch.setattr(watching.time, "sleep", pause)


def test_what_is_saved_during_a_run_is_linted_next(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    document = folder / "a.kindsl"
    document.write_text(GOOD)
    found: list[list[str]] = []

    def report(outcome: RunOutcome) -> int:
        if not found:
            document.write_text(INTEGER)
        found.append([finding.code for file in outcome.files for finding in file.findings])
        return len(found)

    look_three_times(monkeypatch)
    plan = LintPlan(["."], Choices(configurations=Configurations()), is_quiet=True)
    assert watching.watch(plan, report) == 2
    assert found == [[], ["KD005"]]


def test_a_file_that_the_run_itself_mends_is_linted_once(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    document = folder / "a.kindsl"
    document.write_text(INTEGER)
    fixed: list[int] = []

    def report(outcome: RunOutcome) -> int:
        fixed.append(sum(file.n_fixed for file in outcome.files))
        return len(fixed)

    look_three_times(monkeypatch)
    choices = Choices(configurations=Configurations())
    plan = LintPlan(["."], choices, is_quiet=True, fix_mode=FixMode.WRITTEN)
    assert watching.watch(plan, report) == 1
    assert fixed == [1]
    assert document.read_text() != INTEGER
