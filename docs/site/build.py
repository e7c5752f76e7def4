"""Puts the site's pages together and builds it: `python docs/site/build.py`, or `make site`.

Every page is a Markdown file of the repository at its own path, so links between them hold; what
they link to besides (documents, pictures) is copied beside them, and links to folders lead to their
README. The command line and the Python interface are written out of the code. Nothing needs a
network.
"""

import argparse
import inspect
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SETTINGS = Path(__file__).with_name("mkdocs.yml")
BUILD = ROOT / "build" / "site"
PLAYGROUND = ROOT / "dist" / "playground"
SITE = ROOT / "dist" / "site"
PAGES = (
    *("README.md", "CHANGELOG.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "grammar/README.md"),
    "vscode-extension/README.md",
    *("docs/*.md", "docs/guide/*.md", "docs/rules/*.md", "docs/decisions/*.md"),
)
HOME = "README.md"
# The factor on a page's score in the search, by the beginning of its place; 1 for the others.
BOOSTS = {
    "docs/guide/": 5.0,
    **dict.fromkeys(("docs/ci", "docs/configuration", "docs/editors", "docs/playground"), 4.0),
    "docs/rules/": 0.3,
    "docs/decisions/": 0.1,
    "CHANGELOG": 0.1,
}
_LINK = re.compile(r"(\]\()([^)\s]+)(\))")
_FENCE = re.compile(r"^(```.*?^```$)", re.MULTILINE | re.DOTALL)


def main() -> int:
    """Build the site; return the exit status of mkdocs."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.parse_args()
    shutil.rmtree(BUILD, ignore_errors=True)
    assemble(BUILD)
    status = render(BUILD, SITE)
    if status == 0 and PLAYGROUND.is_dir():
        shutil.copytree(PLAYGROUND, SITE / "playground", dirs_exist_ok=True)
    return status


def render(folder: Path, site: Path) -> int:
    """Make a site of a folder's settings and pages; return the exit status of mkdocs."""
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet"]
    options = ["--config-file", str(folder / "mkdocs.yml"), "--site-dir", str(site)]
    return subprocess.run([*command, *options]).returncode


def assemble(folder: Path) -> None:
    """Write the settings and all pages into a folder."""
    pages = folder / "pages"
    for source in sources():
        place = site_path(source)
        text = source.read_text(encoding="utf-8")
        _write(pages / place, boosted(place, relinked(text, source, pages)))
    for name, text in (
        ("reference/cli.md", command_line_page()),
        ("reference/python.md", python_page()),
        ("docs/decisions/README.md", decisions_page()),
    ):
        _write(pages / name, boosted(name, text))
    shutil.copy(SETTINGS, folder / "mkdocs.yml")


def sources() -> list[Path]:
    """Return the pages that are files of the repository."""
    return sorted({path for pattern in PAGES for path in ROOT.glob(pattern)})


def site_path(source: Path) -> str:
    """Return where a file of the repository is in the site."""
    name = source.relative_to(ROOT).as_posix()
    return "index.md" if name == HOME else name


def relinked(text: str, source: Path, pages: Path) -> str:
    """Return a page with its links to other files leading there, which are copied if need be."""
    parts = _FENCE.split(text)
    return "".join(
        part if part.startswith("```") else _LINK.sub(lambda m: _link(m, source, pages), part)
        for part in parts
    )


def _link(found: re.Match[str], source: Path, pages: Path) -> str:
    address, _, anchor = found[2].partition("#")
    if not address or ":" in address:
        return found[0]
    target = (source.parent / address).resolve()
    if not target.exists():
        target = ROOT / "docs" / address  # the extension's pictures are copied from there
    if target.is_dir():
        target = _page_of_folder(target)
    is_generated = target == ROOT / "docs" / "decisions" / "README.md"
    if not target.is_file() and not is_generated:
        return found[0]
    if target not in sources() and not is_generated:
        copy = pages / target.relative_to(ROOT)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(target, copy)
    steps = Path(site_path(source)).parent.parts
    up = "../" * len(steps)
    return f"{found[1]}{up}{site_path(target)}{'#' + anchor if anchor else ''}{found[3]}"


def _page_of_folder(folder: Path) -> Path:
    """Return the page that tells what is in a folder: its README, or that of a folder above."""
    is_told = (folder / "README.md").is_file() or folder == ROOT / "docs" / "decisions"
    return folder / "README.md" if is_told else _page_of_folder(folder.parent)


def command_line_page() -> str:
    """Return the help of every command."""
    from kindsl.frontends.cli.commands import command_module, command_summaries

    parts = ["# Command line\n", "`kindsl COMMAND ...`; `kdsl-lint` is `kindsl lint`.\n"]
    for name, what in command_summaries().items():
        module = command_module(name)
        assert module is not None
        parser = argparse.ArgumentParser(prog=f"kindsl {name}", description=module.__doc__)
        module.add_arguments(parser)
        parts.append(f"## kindsl {name}\n\n{what[:1].upper()}{what[1:]}.\n")
        parts.append(f"```text\n{parser.format_help()}```\n")
        status = _returns(module.run)
        if status:
            parts.append(f"Exit status: {status}\n")
    return "\n".join(parts)


def _returns(function: object) -> str:
    """Return what a docstring says of the value."""
    _, _, rest = (inspect.getdoc(function) or "").partition("Returns:\n")
    return " ".join(rest.split())


def python_page() -> str:
    """Return the Python interface, from signatures and docstrings."""
    import kindsl

    parts = [f"# Python\n\n{_told(kindsl)}\n"]
    parts += [_function(f"kindsl.{name}", getattr(kindsl, name)) for name in ("load", "parse")]
    for name in ("Document", "Mechanism"):
        thing = getattr(kindsl, name)
        parts.append(f"## kindsl.{name}\n\n{_told(thing)}\n")
        parts += [_function(f"{name}.{member}", value) for member, value in _members(thing)]
    return "\n".join(parts)


def _members(thing: type) -> Iterator[tuple[str, object]]:
    for name, value in inspect.getmembers(thing):
        if not name.startswith("_") and (callable(value) or isinstance(value, property)):
            yield name, value


def _function(name: str, thing: object) -> str:
    is_property = isinstance(thing, property)
    signature = "" if is_property else str(inspect.signature(thing))  # type: ignore[arg-type]
    signature = re.sub(
        r"'|kindsl\.[\w.]*\.", "", signature.replace("(self, ", "(").replace("(self)", "()")
    )
    return f"### {name}\n\n```python\n{name}{signature}\n```\n\n```text\n{_told(thing)}\n```\n"


def _told(thing: object) -> str:
    return inspect.getdoc(thing) or ""


def decisions_page() -> str:
    """Return the list of decisions."""
    found = sorted((ROOT / "docs" / "decisions").glob("0*.md"))
    titles = ((path.name, path.read_text(encoding="utf-8").splitlines()[0]) for path in found)
    rows = (f"- [{title.removeprefix('# ')}]({name})" for name, title in titles)
    return "# Decisions\n\nWhy things are as they are.\n\n" + "\n".join(rows) + "\n"


def boosted(place: str, text: str) -> str:
    """Return a page with its factor in the search, in Material's front matter."""
    boosts = (boost for start, boost in BOOSTS.items() if place.startswith(start))
    boost = next(boosts, None)
    return text if boost is None else f"---\nsearch:\n  boost: {boost}\n---\n{text}"


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
