"""What the extension is made of: grammar, unit tests, metadata, and the package itself."""

import json
import re
import subprocess
import zipfile
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path
from typing import Any

import pytest
from tests.vscode.code_server import EXTENSION, ROOT

import kindsl

GRAMMAR = ROOT / "grammar"
MAXIMAL_BYTES = 25 * 1024 * 1024
# A source that is younger than the build is not expected in it.
BUILD_SECONDS = 60
KEYWORD_SCOPES = ("storage.", "constant.language")


def test_textmate_fixtures(vsix: Path) -> None:
    run_script("test:grammar")


def test_unit_tests_of_the_extension(vsix: Path) -> None:
    run_script("test:unit")


def test_python_in_the_editor_reaches_nothing_but_what_is_open(vsix: Path) -> None:
    run_script("test:host")


def test_the_editor_knows_the_keywords_of_the_language() -> None:
    assert textmate_keywords() == lark_keywords()


def test_each_textmate_include_leads_somewhere() -> None:
    grammar = json.loads((GRAMMAR / "kindsl.tmLanguage.json").read_text())
    wanted = {rule["include"] for rule in rules(grammar) if "include" in rule}
    assert wanted == {f"#{name}" for name in grammar["repository"]}


def test_patterns_of_the_language_configuration_compile() -> None:
    configuration = json.loads((GRAMMAR / "language-configuration.json").read_text())
    patterns = [
        *configuration["indentationRules"].values(),
        *configuration["folding"]["markers"].values(),
    ]
    for rule in configuration["onEnterRules"]:
        patterns += [rule[key] for key in ("beforeText", "previousLineText") if key in rule]
    word = configuration["wordPattern"]["pattern"].replace(r"\p{L}", "a-z").replace(r"\p{N}", "0-9")
    for pattern in (*patterns, word):
        re.compile(pattern)


def test_one_version() -> None:
    assert manifest()["version"] == kindsl.__version__ == metadata.version("kindsl")


def test_each_command_is_documented_or_contextual() -> None:
    source = "".join(path.read_text() for path in (EXTENSION / "src").glob("*.ts"))
    for command in manifest()["contributes"]["commands"]:
        assert f'"{command["command"]}"' in source, command


def test_settings_that_name_programs_are_restricted_in_untrusted_workspaces() -> None:
    restricted = manifest()["capabilities"]["untrustedWorkspaces"]["restrictedConfigurations"]
    properties = manifest()["contributes"]["configuration"]["properties"]
    programs = {
        name for name, one in properties.items() if one.get("scope") == "machine-overridable"
    }
    assert set(restricted) == programs


def test_the_package_is_small(vsix: Path) -> None:
    assert vsix.stat().st_size < MAXIMAL_BYTES


def test_the_package_has_everything_inside(vsix: Path) -> None:
    names = set(zipfile.ZipFile(vsix).namelist())
    libraries = ("kindsl", "pygls", "lsprotocol", "attrs", "cattrs", "pathspec", "tomlkit")
    wanted = {f"bundled/libs/{library}/__init__.py" for library in libraries} | {
        "bundled/libs/kindsl/grammar/kindsl.lark",
        "bundled/libs/kindsl/grammar/dtdsl.lark",
        "bundled/libs/lark/lark.py",
        "bundled/libs/kindsl/docs/rules/kd301.md",
        "bundled/libs/typing_extensions.py",
        "out/browser.js",
        "out/extension.js",
        "out/preview.html",
        "server/host.js",
        "server/image.json",
        "server/pyodide.asm.wasm",
        "server/server.snap.gz",
        "server/site.zip",
        "server/worker.js",
        "python/launch.py",
        "python/probe.py",
        "syntaxes/dtdsl.tmLanguage.json",
        "syntaxes/kindsl.tmLanguage.json",
        "syntaxes/language-configuration.json",
        *(manifest()[key] for key in ("icon",)),
    }
    assert {f"extension/{name}" for name in wanted} <= names


def test_the_package_carries_all_of_the_server(vsix: Path) -> None:
    packed = set(zipfile.ZipFile(vsix).namelist())
    for path in sorted((ROOT / "server" / "kindsl").rglob("*")):
        is_source = path.is_file() and not re.search(r"__pycache__|\.d\.ts$", str(path))
        if is_source and path.stat().st_mtime < vsix.stat().st_mtime - BUILD_SECONDS:
            name = path.relative_to(ROOT / "server").as_posix()
            assert f"extension/bundled/libs/{name}" in packed


@pytest.mark.parametrize(
    "unwanted", [r"\.pyc$", r"__pycache__", r"\.so$", r"\.ts$", r"node_modules", r"/numpy/"]
)
def test_the_package_has_nothing_else_inside(vsix: Path, unwanted: str) -> None:
    assert [name for name in zipfile.ZipFile(vsix).namelist() if re.search(unwanted, name)] == []


def run_script(name: str) -> None:
    result = subprocess.run(
        ["npm", "run", "--silent", name], cwd=EXTENSION, capture_output=True, text=True
    )
    assert result.returncode == 0, result.stdout + result.stderr


def manifest() -> dict[str, Any]:
    content: dict[str, Any] = json.loads((EXTENSION / "package.json").read_text())
    return content


def lark_keywords() -> set[str]:
    """The words that the grammar quotes, comments aside."""
    lines = (GRAMMAR / "kindsl.lark").read_text().splitlines()
    return {
        word
        for line in lines
        if not line.lstrip().startswith("//")
        for word in re.findall(r'"([A-Za-z_]+)"', line.partition("//:")[0])
    }


def textmate_keywords() -> set[str]:
    """The words of all patterns whose scope is a keyword's."""
    grammar = json.loads((GRAMMAR / "kindsl.tmLanguage.json").read_text())
    return {word for rule in rules(grammar) for word in words(rule)}


def words(rule: dict[str, Any]) -> Iterator[str]:
    """Yield the words that one rule marks as keywords."""
    if rule.get("name", "").startswith(KEYWORD_SCOPES):
        alternatives = re.sub(r"\(\?[=!].*", "", rule["match"])
        yield from re.findall(r"[A-Za-z_]{2,}", re.sub(r"\\.", " ", alternatives))
    groups = re.findall(r"(?<!\\)\((?!\?)([^()]*)\)", rule.get("match", ""))
    for number, capture in rule.get("captures", {}).items():
        if capture["name"].startswith(KEYWORD_SCOPES):
            yield from groups[int(number) - 1].split("|")


def rules(node: Any) -> Iterator[dict[str, Any]]:
    """Yield each rule of a TextMate grammar."""
    if isinstance(node, dict):
        if {"match", "begin", "include"} & node.keys():
            yield node
        for child in node.values():
            yield from rules(child)
    elif isinstance(node, list):
        for child in node:
            yield from rules(child)
