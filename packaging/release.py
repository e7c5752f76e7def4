"""Prepare a release: the version in every file that names it, or the address of its repository.

`python packaging/release.py version 0.2.0` writes the version and dates the change log.
`python packaging/release.py address ADDRESS` writes the repository's address into what goes out.
The release workflow does the second, so that no checkout names an address that may not exist.
"""

import datetime
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
# The text before a version, and how often it stands in a file; later ones are of dependencies.
VERSIONS = {
    "server/kindsl/__init__.py": ('__version__ = "', 1),
    "vscode-extension/package.json": ('"version": "', 1),
    "vscode-extension/package-lock.json": ('"version": "', 2),
    "web/package.json": ('"version": "', 1),
    "web/package-lock.json": ('"version": "', 2),
    "CITATION.cff": ("\nversion: ", 1),
    "Dockerfile": ("kindsl==", 1),
    "packaging/server.json": ('"version": "|kindsl\\[mcp\\]==', 3),
    "packaging/mason/package.yaml": ("kindsl@", 1),
    "packaging/conda/recipe.yaml": ("\n  version: ", 1),
}
_NUMBER = r"(\d+\.\d+\.\d+)"


def versions(root: Path) -> dict[str, list[str]]:
    """Return the versions that each file names, as often as they stand there."""
    return {
        name: re.findall(f"(?:{before}){_NUMBER}", (root / name).read_text("utf-8"))[:count]
        for name, (before, count) in VERSIONS.items()
    }


def set_version(root: Path, version: str, day: datetime.date) -> None:
    """Write a version into all files, and its date into the change log.

    Raises:
        SystemExit: It is no version, or the change log has no section for it.
    """
    if not re.fullmatch(r"\d+\.\d+\.\d+", version):
        raise SystemExit(f"'{version}' is not a version: three numbers with points between them")
    log = root / "CHANGELOG.md"
    text, count = re.subn(
        rf"(?m)^## {re.escape(version)} \(unreleased\)$",
        f"## {version} ({day})",
        log.read_text("utf-8"),
    )
    if not count:
        raise SystemExit(f"CHANGELOG.md has no section '## {version} (unreleased)'")
    log.write_text(text, "utf-8")
    for name, (before, count) in VERSIONS.items():
        file = root / name
        known = file.read_text("utf-8")
        file.write_text(
            re.sub(f"({before}){_NUMBER}", rf"\g<1>{version}", known, count=count), "utf-8"
        )


def set_address(root: Path, address: str) -> None:
    """Write the repository's address and its owner into everything that is published."""
    address = address.rstrip("/")
    owner = address.rsplit("/", 2)[-2]
    for name in (
        "packaging/mason/package.yaml",
        "packaging/conda/recipe.yaml",
        "packaging/server.json",
    ):
        file = root / name
        text = file.read_text("utf-8").replace("ADDRESS", address).replace("OWNER", owner)
        file.write_text(text, "utf-8")
    _append(root / "CITATION.cff", f"repository-code: {address}\n")
    _append(root / "README.md", f"\n<!-- mcp-name: io.github.{owner}/kindsl -->\n")
    project = root / "pyproject.toml"
    urls = f'[project.urls]\nRepository = "{address}"\n\n[project.scripts]'
    project.write_text(project.read_text("utf-8").replace("[project.scripts]", urls), "utf-8")
    manifest = root / "vscode-extension" / "package.json"
    known = json.loads(manifest.read_text("utf-8"))
    known["repository"] = {"type": "git", "url": f"{address}.git"}
    manifest.write_text(json.dumps(known, indent=2, ensure_ascii=False) + "\n", "utf-8")


def _append(file: Path, text: str) -> None:
    file.write_text(file.read_text("utf-8") + text, "utf-8")


def main(arguments: list[str]) -> None:
    """Do what the arguments name."""
    if len(arguments) != 2 or arguments[0] not in ("version", "address"):
        raise SystemExit(__doc__)
    if arguments[0] == "version":
        set_version(ROOT, arguments[1], datetime.datetime.now(datetime.UTC).date())
    else:
        set_address(ROOT, arguments[1])


if __name__ == "__main__":
    main(sys.argv[1:])
