"""ARCHITECTURE.md is true to the files."""

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
PLACES = (
    ROOT,
    ROOT / "server" / "kindsl",
    ROOT / "server" / "kindsl" / "frontends" / "lsp" / "text",
)


def named_paths():
    """Yield what stands in backticks and looks like a path."""
    for quoted in re.findall(r"`([^`\n]+)`", PAGE):
        if re.fullmatch(r"[\w.-]+(/[\w.-]*)+|\w+\.py", quoted):
            yield quoted


def is_there(name):
    whole = any((place / name).exists() for place in PLACES)
    return whole or any(path.match(name) for path in (ROOT / "server").rglob(Path(name).name))


def test_every_path_exists():
    found = list(named_paths())
    assert len(found) > 40
    assert [name for name in found if not is_there(name)] == []


def test_the_layers_are_those_that_are_checked():
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = settings["tool"]["importlinter"]["contracts"]
    layers = {c["containers"][0]: c["layers"] for c in contracts if c["type"] == "layers"}
    rows = re.findall(r"^(\w+) +(.+)$", PAGE.split("```")[-2], re.MULTILINE)
    assert [name for name, _ in rows] == layers["kindsl"]
    for name, row in rows:
        if f"kindsl.{name}" in layers:
            assert row == " > ".join(layers[f"kindsl.{name}"])
