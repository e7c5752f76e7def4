"""Highlighting of documents that a generator accepts: nothing in them may look wrong."""

import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest
from tests.support.conformance import accepted_cases
from tests.support.published import published_models
from tests.vscode.code_server import EXTENSION, ROOT


def test_nothing_is_marked_as_wrong_in_our_examples(vsix: Path) -> None:
    assert invalid(sorted((ROOT / "examples").glob("*.kindsl"))) == []


@pytest.mark.parametrize("path", published_models())
def test_nothing_is_marked_as_wrong_in_published_models(vsix: Path, path: Path) -> None:
    assert invalid([path]) == []


def test_nothing_is_marked_as_wrong_that_a_generator_accepts(vsix: Path) -> None:
    cases = accepted_cases()
    assert len(cases) > 50
    assert invalid([case.path for case in cases]) == []


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
