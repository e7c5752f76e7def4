"""Writes the rules' pages into `docs/rules`.

`python -m generating.rule_pages [--check] [FOLDER]`
"""

import sys
from pathlib import Path

from kindsl.judgement.rules.base import Rule
from kindsl.judgement.rules.registry import all_rules, page_of

_FOLDER = Path(__file__).parents[1] / "docs" / "rules"
_FAMILIES = {
    "KD0": "Syntax",
    "KD1": "Names, numbers, references",
    "KD2": "The kinematic tree",
    "KD3": "Inertia",
    "KD4": "Parameters and constants",
    "KD5": "Geometry",
    "KD6": "Portability",
    "KD7": "Style",
    "KD8": "Transforms documents",
    "KD9": "Other files of the same robot",
}


def pages() -> dict[str, str]:
    """Return the text of each page by its file's name, the list of all rules included."""
    found = {f"{rule.code.lower()}.md": _page(rule) for rule in all_rules()}
    return {**found, "README.md": _index()}


def main(arguments: list[str]) -> int:
    """Write the pages, or say which are not as the rules want them; return the exit status."""
    folders = [Path(argument) for argument in arguments if not argument.startswith("-")]
    folder = folders[0] if folders else _FOLDER
    wanted = pages()
    if "--check" in arguments:
        stale = _stale(folder, wanted)
        for name in stale:
            print(f"{folder / name} is stale; run python -m generating.rule_pages")
        return 1 if stale else 0
    folder.mkdir(parents=True, exist_ok=True)
    for name in _stale(folder, wanted):
        if name in wanted:
            (folder / name).write_text(wanted[name], encoding="utf-8", newline="\n")
        else:
            (folder / name).unlink()
    return 0


def _stale(folder: Path, wanted: dict[str, str]) -> list[str]:
    """Return the names of the files that differ, are missing, or belong to no rule."""
    there = {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.md")}
    return sorted(n for n in there.keys() | wanted.keys() if there.get(n) != wanted.get(n))


def _page(rule: Rule) -> str:
    default = "" if rule.is_default else ", off unless selected or needed by a target"
    severity = f"Severity: {rule.severity}{default}"
    return f"# {rule.code} {rule.name}\n\n{severity}\n\n{page_of(rule)}\n"


def _index() -> str:
    lines = ["# Rules", "", "`kindsl lint --explain KD301` shows a page on the terminal."]
    family = ""
    for rule in all_rules():
        if rule.code[:3] != family:
            family = rule.code[:3]
            lines += [
                "",
                f"## {family} {_FAMILIES[family]}",
                "",
                "| code | name | severity | what |",
            ]
            lines += ["|---|---|---|---|"]
        first = page_of(rule).partition("\n")[0].removesuffix(".")
        code = f"[{rule.code}]({rule.code.lower()}.md)"
        lines.append(f"| {code} | {rule.name} | {rule.severity} | {first} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
