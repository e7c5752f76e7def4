"""Highlighting of documents that a generator accepts: nothing in them may look wrong."""

import csv
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest
from tests.vscode.code_server import EXTENSION, ROOT

SHARED = ROOT / ".." / "shared"


def test_nothing_is_marked_as_wrong_in_our_examples(vsix: Path) -> None:
    assert invalid(sorted((ROOT / "examples").glob("*.kindsl"))) == []


def test_nothing_is_marked_as_wrong_in_published_models(vsix: Path) -> None:
    models = sorted((SHARED / "corpus").glob("*.kindsl"))
    if not models:
        pytest.skip("the published models are not beside the project")
    assert invalid(models) == []


def test_nothing_is_marked_as_wrong_that_a_generator_accepts(vsix: Path) -> None:
    verdicts = SHARED / "conformance" / "verdicts.tsv"
    if not verdicts.exists():
        pytest.skip("the measured verdicts are not beside the project")
    with verdicts.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file, delimiter="\t"))
    accepted = [row["name"] for row in rows if "accept" in (row["A"], row["B"])]
    assert len(accepted) > 50
    cases = [verdicts.parent / "cases" / f"{name}.kindsl" for name in accepted]
    assert invalid([case for case in cases if case.exists()]) == []


def test_what_no_generator_reads_is_marked(vsix: Path, tmp_path: Path) -> None:
    path = tmp_path / "wrong.kindsl"
    path.write_text("mass = 0x10\nid = 1;\n")
    assert [line.partition("wrong.kindsl:")[2] for line in invalid([path])] == [
        "1:8: 0x10",
        "2:7: ;",
    ]


def invalid(files: Sequence[Path]) -> list[str]:
    """Return the places that the TextMate grammar marks as invalid."""
    result = subprocess.run(
        ["node", EXTENSION / "scripts" / "invalid.mjs"],
        input="\n".join(map(str, files)),
        capture_output=True,
        text=True,
        check=True,
    )
    return result.stdout.splitlines()
