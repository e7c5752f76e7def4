"""Writes docs/published-models.md: what kindsl finds in models that others have published.

Usage: python docs/pictures/published_models.py [--check] [FOLDER]

The folder, ../shared/corpus beside the project if none is named, holds the models and SOURCES.tsv,
which tells of each its origin, licence and what the two generators say to it. With --check nothing
is written; the exit status is 1 if the page is not as it would be.
"""

import csv
import sys
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.registry import rule_named

ROOT = Path(__file__).parents[2]
CORPUS = ROOT / ".." / "shared" / "corpus"
PAGE = ROOT / "docs" / "published-models.md"
SOURCES = "SOURCES.tsv"
# Of each generator: its column in SOURCES.tsv, its target, the rule that tells what it refuses.
GENERATORS = (("A", "robcogen", "KD601"), ("B", "robcogen2", "KD602"))
SEVERITIES = ("error", "warning", "info", "hint")
NOTHING_SET = Settings()
CAUSES = ("KD306", "KD307", "KD308", "KD314")
HEAD = """\
# What kindsl finds in published models

Models that their authors published and use, checked without any configuration, so that what either
generator reads is welcome. Made by `python docs/pictures/published_models.py`; the models belong to
others and are not part of this project. What the generators say to them was measured with the
generators themselves; where one refuses, the rule and the number of places are what kindsl says
with that `--target`.

"""


def main(arguments: Sequence[str]) -> int:
    """Write the page, or check it; return the exit status."""
    folders = [argument for argument in arguments if argument != "--check"]
    folder = Path(folders[0]) if folders else CORPUS
    if not (folder / SOURCES).is_file():
        print(
            f"{folder}: no {SOURCES} there; name a folder with it and the models", file=sys.stderr
        )
        return 2
    text = page(folder)
    if "--check" in arguments:
        return int(not PAGE.is_file() or PAGE.read_text(encoding="utf-8") != text)
    PAGE.write_text(text, encoding="utf-8")
    print(f"{PAGE.name}: {len(models(folder))} models")
    return 0


def models(folder: Path) -> list[Mapping[str, str]]:
    """Return the rows of SOURCES.tsv whose model is in the folder."""
    with (folder / SOURCES).open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file, delimiter="\t"))
    return [row for row in rows if (folder / row["file"]).is_file()]


def page(folder: Path) -> str:
    """Return the page: a table of models, and one of the errors with their words."""
    rows = models(folder)
    return HEAD + "\n".join((*_table(folder, rows), "", *_errors(folder, rows))) + "\n"


def _table(folder: Path, rows: Iterable[Mapping[str, str]]) -> Iterable[str]:
    yield "| model | of | RobCoGen | RobCoGen2 | errors | warnings | infos | hints |"
    yield "|---|---|---|---|---|---|---|---|"
    for row in rows:
        cells = [_name(row), _origin(row)]
        cells += [_verdict(folder, row, *generator) for generator in GENERATORS]
        cells += [_counted(folder, row, severity) for severity in SEVERITIES]
        yield f"| {' | '.join(cells)} |"


def _errors(folder: Path, rows: Iterable[Mapping[str, str]]) -> Iterable[str]:
    """Yield every error with its message, and what is supposed of its cause."""
    yield "## The errors"
    for row in rows:
        found = _findings(folder, row)
        if any(severity == "error" for severity, _, _ in found):
            yield f"\n**{_name(row)}** of {_origin(row)}:\n"
            shown = (each for each in found if each[0] == "error" or each[1] in CAUSES)
            yield from (f"- {_link(code)} {message}" for _, code, message in shown)


def _findings(
    folder: Path, row: Mapping[str, str], settings: Settings = NOTHING_SET
) -> list[tuple[str, str, str]]:
    """Return severity, code and message of the findings in a model, in the order of the text."""
    text = (folder / row["file"]).read_text(encoding="utf-8")
    return [(str(f.severity), f.code, f.message) for f in analyse(text, settings).findings]


def _counted(folder: Path, row: Mapping[str, str], severity: str) -> str:
    codes = Counter(code for found, code, _ in _findings(folder, row) if found == severity)
    if not codes:
        return "none"
    return ", ".join(f"{n} {_link(code)} {_title(code)}" for code, n in sorted(codes.items()))


def _name(row: Mapping[str, str]) -> str:
    return Path(row["path"]).stem


def _origin(row: Mapping[str, str]) -> str:
    year = f", {row['date'][:4]}" if row["date"] else ""
    return f"{row['origin']}{year}"


def _verdict(folder: Path, row: Mapping[str, str], column: str, target: str, code: str) -> str:
    if row[column].startswith("accept"):
        return "accepts"
    found = _findings(folder, row, Settings(targets=frozenset({target})))
    count = sum(other == code for _, other, _ in found)
    return f"refuses: {count} {_link(code)}" if count else "refuses"


def _link(code: str) -> str:
    return f"[{code}](rules/{code.lower()}.md)"


def _title(code: str) -> str:
    rule = rule_named(code)
    return rule.name if rule is not None else ""


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
