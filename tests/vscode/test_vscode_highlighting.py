"""Colours: nothing accepted looks wrong, and all stay as they are when the server comes."""

import json
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import pytest
from tests.support.conformance import accepted_cases
from tests.support.published import CORPUS, published_models
from tests.vscode.code_server import EXTENSION, ROOT

import kindsl
from kindsl.frontends.features.semantic_tokens import semantic_tokens
from kindsl.language.text.lines import LineIndex

EXAMPLES = sorted((ROOT / "examples").glob("*.kindsl"))
# The scopes whose colours VS Code gives to the server's tokens where a theme names none; those of
# keywords and PI are in our package.json.
SCOPES = {
    "comment": "comment",
    "keyword": "storage.type",
    "number": "constant.numeric",
    "number.readonly": "constant.language.pi",
    "operator": "keyword.operator",
    "namespace": "entity.name.namespace",
    "class": "entity.name.type.class",
    "method": "entity.name.function.member",
    "property": "variable.other.property",
    "parameter": "variable.parameter",
    "variable.readonly": "variable.other.constant",
}


class Painted(NamedTuple):
    """A stretch of a line in one colour: line from 1, column from 0, innermost scope."""

    file: str
    line: int
    column: int
    text: str
    scope: str


def test_nothing_is_marked_as_wrong_in_our_examples(vsix: Path) -> None:
    assert invalid(EXAMPLES) == []


@pytest.fixture(scope="module")
def wrong_in_published(vsix: Path) -> list[str]:
    return invalid(sorted(CORPUS.glob("*.kindsl")))


@pytest.mark.parametrize("path", published_models())
def test_nothing_is_marked_as_wrong_in_published_models(
    wrong_in_published: list[str], path: Path
) -> None:
    assert [place for place in wrong_in_published if place.startswith(f"{path}:")] == []


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


def test_colours_stay_when_the_server_comes(vsix: Path, tmp_path: Path) -> None:
    """Each character has the scope that its semantic token is coloured by."""
    suppressing = tmp_path / "suppressing.kindsl"
    suppressing.write_text("Robot a { // kindsl: ignore[KD301, KD302] measured\n}\n")
    accepted = [case.path for case in accepted_cases() if "glued" not in case.path.stem]
    files = [*EXAMPLES, *accepted, suppressing]
    told = {(str(path), *place): scope for path in files for place, scope in meant(path).items()}
    assert len(told) > 20_000
    changed = {
        f"{each.file}:{each.line}: {each.text}: {each.scope} becomes {scope}"
        for each in painted(files)
        for column in range(each.column, each.column + len(each.text))
        if (scope := told.get((each.file, each.line, column))) and not is_under(each.scope, scope)
    }
    assert sorted(changed) == []


def is_under(scope: str, selector: str) -> bool:
    """Return whether a theme's colour for a selector holds for a scope."""
    return scope.removeprefix("punctuation.definition.").startswith(selector)


def meant(path: Path) -> dict[tuple[int, int], str]:
    """Return the scope whose colour each character has by its semantic token."""
    analysis = kindsl.load(path)
    lines = LineIndex(analysis.text)
    found = {}
    for token in semantic_tokens(analysis):
        line, column = lines.position(token.start)
        scope = SCOPES[".".join([token.type, *(m for m in token.modifiers if m == "readonly")])]
        for offset in range(token.end - token.start):
            found[line + 1, column + offset] = scope
    return found


def invalid(files: Sequence[Path]) -> list[str]:
    """Return the places that the TextMate grammar marks as invalid."""
    return [
        f"{each.file}:{each.line}:{each.column + 1}: {each.text}"
        for each in painted(files)
        if each.scope.startswith("invalid.")
    ]


def painted(files: Sequence[Path]) -> list[Painted]:
    """Return what the TextMate grammar colours."""
    result = subprocess.run(
        ["node", EXTENSION / "scripts" / "scopes.mjs"],
        input="\n".join(map(str, files)),
        capture_output=True,
        text=True,
        check=True,
    )
    return [Painted(*json.loads(line)) for line in result.stdout.splitlines()]
