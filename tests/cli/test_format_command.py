"""`kindsl format`."""

from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.cli.samples import GOOD, INTEGER


def test_formats_in_place_once(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD)
    assert kindsl("format", "a.kindsl", "--check").status == 1
    assert (folder / "a.kindsl").read_text() == GOOD
    told = kindsl("format", "a.kindsl")
    assert (told.status, told.out) == (0, "")
    assert "a.kindsl: formatted" in told.err
    assert (folder / "a.kindsl").read_text() != GOOD
    assert kindsl("format", "a.kindsl", "--check").status == 0
    assert kindsl("format").err == "0 documents formatted, 1 as it should be\n"


def test_folders_of_tools_are_formatted_when_asked_for(kindsl: Runner, folder: Path) -> None:
    (folder / "build").mkdir()
    (folder / "build" / "a.kindsl").write_text(GOOD.replace(" {", "{"))
    assert kindsl("format", "--check").status == 0
    assert kindsl("format", "--check", "--no-default-exclude").status == 1
    assert kindsl("format", "--check", "build").status == 1


def test_diff_writes_nothing(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD)
    told = kindsl("format", "--diff")
    assert told.status == 1
    assert told.out.startswith("--- a.kindsl\n+++ a.kindsl\n")
    assert (folder / "a.kindsl").read_text() == GOOD


def test_refuses_what_does_not_parse(kindsl: Runner, folder: Path) -> None:
    (folder / "a.kindsl").write_text(INTEGER)
    (folder / "b.kindsl").write_text(GOOD)
    told = kindsl("format")
    assert told.status == 2
    assert told.err.startswith("a.kindsl:21:32: error: not formatted: ")
    assert (folder / "a.kindsl").read_text() == INTEGER
    assert (folder / "b.kindsl").read_text() != GOOD


def test_stdin_to_stdout(kindsl: Runner, monkeypatch: pytest.MonkeyPatch, folder: Path) -> None:
    from io import BytesIO, TextIOWrapper

    (folder / "a.kindsl").write_text(GOOD)
    kindsl("format", "a.kindsl")
    monkeypatch.setattr("sys.stdin", TextIOWrapper(BytesIO(GOOD.encode())))
    assert kindsl("format", "-").out == (folder / "a.kindsl").read_text()


def test_strange_bytes_are_left_alone(kindsl: Runner, folder: Path) -> None:
    content = GOOD.replace("Robot arm {", "Robot arm { // é").encode("latin-1")
    (folder / "a.kindsl").write_bytes(content)
    told = kindsl("format")
    assert told.status == 2
    assert (folder / "a.kindsl").read_bytes() == content


def test_only_what_was_written_is_called_formatted(
    kindsl: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from kindsl.language.text import writing

    def full_for_b(target: str, *rest: object) -> str:
        if target.endswith("b.kindsl"):
            raise OSError(28, "No space left on device")
        return neighbour(target, *rest)  # type: ignore[arg-type]

    neighbour = writing._neighbour
    monkeypatch.setattr(writing, "_neighbour", full_for_b)
    for name in ("a.kindsl", "b.kindsl"):
        (folder / name).write_text(f"  {GOOD}")
    told = kindsl("format", "a.kindsl", "b.kindsl")
    assert told.status == 2
    assert told.err == (
        "b.kindsl: error: cannot be written: No space left on device\n"
        "a.kindsl: formatted\n1 document formatted, 0 as it should be\n"
    )
    assert (folder / "a.kindsl").read_text().startswith("Robot")
    assert (folder / "b.kindsl").read_text() == f"  {GOOD}"
