"""What a release publishes, held against published schemas or by the tool that reads it."""

import datetime
import importlib.util
import json
import re
import shutil
import subprocess
import sys
import tomllib
from importlib.resources import files
from pathlib import Path
from types import ModuleType
from typing import Any

import jsonschema
import pytest
import yaml

ROOT = Path(__file__).parents[1]
PACKAGING = ROOT / "packaging"
ADDRESS = "https://forge.example/someone/kindsl"


def loaded(path: Path) -> Any:
    text = path.read_text(encoding="utf-8")
    return json.loads(text) if path.suffix == ".json" else yaml.safe_load(text)


def vendored(name: str) -> Any:
    folder = files("check_jsonschema") / "builtin_schemas" / "vendor"
    return json.loads((folder / f"{name}.json").read_text(encoding="utf-8"))


def of_assistants() -> Any:
    folder = files("skillsaw") / "schemas" / "mcp_registry" / "v2025_12_11"
    return json.loads((folder / "server.schema.json").read_text(encoding="utf-8"))


def of_workflows() -> list[Path]:
    return sorted((ROOT / ".github" / "workflows").glob("*.yml"))


@pytest.fixture(scope="module")
def release() -> ModuleType:
    spec = importlib.util.spec_from_file_location("release", PACKAGING / "release.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def copy(tmp_path: Path, release: ModuleType) -> Path:
    """The files that a release changes."""
    names = [*release.VERSIONS, "README.md", "CHANGELOG.md", "pyproject.toml"]
    for name in names:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    return tmp_path


def check(document: Any, schema: Any) -> None:
    jsonschema.validators.validator_for(schema)(schema).validate(document)


def test_the_citation_is_one() -> None:
    check(loaded(ROOT / "CITATION.cff"), vendored("citation-file-format"))


def test_the_entry_of_assistants_servers_is_one() -> None:
    check(loaded(PACKAGING / "server.json"), of_assistants())


@pytest.mark.parametrize("path", of_workflows(), ids=lambda path: path.name)
def test_workflows_are_read_by_the_forge(path: Path) -> None:
    # YAML 1.1 takes the key `on` for a truth.
    document = loaded(path)
    document["on"] = document.pop(True)
    check(document, vendored("github-workflows"))


def test_the_action_is_read_by_the_forge() -> None:
    check(loaded(ROOT / "action.yml"), vendored("github-actions"))


def test_the_linter_s_image_is_well_built() -> None:
    command = [Path(sys.executable).parent / "hadolint", ROOT / "Dockerfile"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "")


def test_the_image_gets_what_the_wheel_is_built_of() -> None:
    """Everything that the build reads is copied, and let through to the builder."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    wheel = project["tool"]["hatch"]["build"]["targets"]["wheel"]
    wanted = {*wheel["packages"], *wheel["force-include"], "README.md", "LICENSE", "pyproject.toml"}
    sources = re.findall(r"(?m)^COPY (.+) \S+$", (ROOT / "Dockerfile").read_text())
    copied = {name for source in sources for name in source.split()}
    ignore = (ROOT / ".dockerignore").read_text().splitlines()
    kept = {line[1:] for line in ignore if line.startswith("!")}
    for name in wanted:
        parents = {name, *map(str, Path(name).parents)}
        assert parents & copied, name
        assert parents & kept, name


def test_one_version_everywhere(release: ModuleType) -> None:
    import kindsl

    for name, found in release.versions(ROOT).items():
        assert found == [kindsl.__version__] * release.VERSIONS[name][1], name


def test_a_new_version_is_written_everywhere(release: ModuleType, copy: Path) -> None:
    log = copy / "CHANGELOG.md"
    log.write_text(log.read_text().replace("## 0.1.0 (", "## 7.77.777 ("))
    before = {name: (copy / name).read_text() for name in release.VERSIONS}
    release.set_version(copy, "7.77.777", datetime.date(2027, 1, 2))
    assert set().union(*release.versions(copy).values()) == {"7.77.777"}
    assert "## 7.77.777 (2027-01-02)" in log.read_text()
    for name, text in before.items():
        changed = (copy / name).read_text()
        assert changed.count("7.77.777") == release.VERSIONS[name][1], name
        assert changed.replace("7.77.777", "0.1.0") == text, name


@pytest.mark.parametrize("version", ["1.2", "v1.2.3", "0.9.0"])
def test_what_is_no_release_changes_nothing(release: ModuleType, copy: Path, version: str) -> None:
    before = {path: path.read_bytes() for path in copy.rglob("*") if path.is_file()}
    with pytest.raises(SystemExit, match=re.escape(version)):
        release.set_version(copy, version, datetime.date(2027, 1, 2))
    assert {path: path.read_bytes() for path in before} == before


def test_the_address_of_a_fork_is_its_own(release: ModuleType, copy: Path) -> None:
    release.set_address(copy, ADDRESS + "/")
    server = loaded(copy / "packaging" / "server.json")
    check(server, of_assistants())
    assert server["name"] == "io.github.someone/kindsl"
    assert f"mcp-name: {server['name']}" in (copy / "README.md").read_text()
    citation = loaded(copy / "CITATION.cff")
    check(citation, vendored("citation-file-format"))
    assert citation["repository-code"] == ADDRESS
    project = tomllib.loads((copy / "pyproject.toml").read_text())["project"]
    assert project["urls"] == {"Repository": ADDRESS}
    assert set(project["scripts"]) == set(recipe()["build"]["python"]["entry_points_named"])
    assert loaded(copy / "packaging/mason/package.yaml")["homepage"] == ADDRESS
    manifest = loaded(copy / "vscode-extension" / "package.json")
    assert manifest["repository"]["url"] == f"{ADDRESS}.git"
    for path in (copy / "packaging").rglob("*"):
        assert not (path.is_file() and re.search("ADDRESS|OWNER", path.read_text())), path


def recipe() -> Any:
    found = loaded(PACKAGING / "conda" / "recipe.yaml")
    points = found["build"]["python"]["entry_points"]
    found["build"]["python"]["entry_points_named"] = dict(p.split(" = ") for p in points)
    return found


def test_the_recipe_says_what_the_package_does() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    found = recipe()
    assert found["build"]["python"]["entry_points_named"] == project["scripts"]
    run = {line.replace(" ", "") for line in found["requirements"]["run"]}
    assert run == {f"python{project['requires-python']}", *project["dependencies"]}
    assert found["about"]["license"] == project["license"]
    assert {"schema_version", "context", "package", "source", "build", "tests"} <= set(found)


def test_the_entry_of_mason_names_the_package_s_commands() -> None:
    """Its format, from the registry's own guide: name, source by purl, bin by manager."""
    found = loaded(PACKAGING / "mason" / "package.yaml")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert found["bin"] == {name: f"pypi:{name}" for name in project["scripts"]}
    purl = re.fullmatch(r"pkg:pypi/([\w-]+)@[\d.]+\?extra=(\w+)", found["source"]["id"])
    assert purl is not None
    assert purl[1] == project["name"]
    assert purl[2] in project["optional-dependencies"]
    assert set(found["categories"]) <= {"LSP", "Linter", "Formatter", "DAP", "Runtime", "Compiler"}
