"""What kindsl finds in published models: `python benchmarks/published_models.py FOLDER [--write]`.

The folder holds `.kindsl` files, and perhaps a `SOURCES.tsv` with the columns `file`, `origin` and
`path`. `--write` puts the table into the docs.
"""

import csv
import sys
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

from kindsl.rules.analysis import analyse
from kindsl.rules.registry import rule_named

PAGE = Path(__file__).parents[1] / "docs" / "published_models.md"


def table(folder: Path) -> str:
    lines = [
        "# What kindsl finds in published models",
        "",
        "Errors and warnings of `kindsl lint` without any configuration, in models that were made",
        "for the generators and that at least one of them accepts. Made by `python",
        "benchmarks/published_models.py FOLDER --write`.",
        "",
        "| model | from | errors | warnings |",
        "|---|---|---|---|",
    ]
    origins = _origins(folder)
    for path in sorted(folder.glob("*.kindsl")):
        found = analyse(path.read_text(encoding="utf-8")).findings
        cells = [_counted(f.code for f in found if f.severity == s) for s in ("error", "warning")]
        lines.append(f"| {path.stem} | {origins.get(path.name, '')} | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def _counted(codes: Iterable[str]) -> str:
    counts = sorted(Counter(codes).items())
    return ", ".join(f"{n} x [{c}](rules/{c.lower()}.md) {_name(c)}" for c, n in counts) or "none"


def _name(code: str) -> str:
    rule = rule_named(code)
    return rule.name if rule is not None else ""


def _origins(folder: Path) -> dict[str, str]:
    sources = folder / "SOURCES.tsv"
    if not sources.is_file():
        return {}
    with sources.open(encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file, delimiter="\t")
        return {row["file"]: f"{row['origin']}, {Path(row['path']).name}" for row in rows}


if __name__ == "__main__":
    text = table(Path(sys.argv[1]))
    print(text)
    if "--write" in sys.argv:
        PAGE.write_text(text, encoding="utf-8")
