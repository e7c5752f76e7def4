"""Small documents with the verdicts of both generators, see the README beside them."""

import csv
from functools import cache
from pathlib import Path
from typing import NamedTuple

FOLDER = Path(__file__).parents[1] / "fixtures" / "conformance"


class Case(NamedTuple):
    """A document and who accepts it.

    Attributes:
        name: The file's stem.
        path: The file.
        text: What it holds; bytes that are not UTF-8 as lone surrogates.
        accepted_by: `robcogen`, `robcogen2`, both or none.
    """

    name: str
    path: Path
    text: str
    accepted_by: frozenset[str]


@cache
def cases() -> tuple[Case, ...]:
    """Return all cases in the order of the table."""
    with (FOLDER / "verdicts.tsv").open(newline="", encoding="utf-8") as file:
        return tuple(_case(row) for row in csv.DictReader(file, delimiter="\t"))


def accepted_cases() -> tuple[Case, ...]:
    """Return the cases that one of the generators accepts."""
    return tuple(case for case in cases() if case.accepted_by)


def _case(row: dict[str, str]) -> Case:
    path = FOLDER / "cases" / f"{row['name']}.kindsl"
    columns = (("A", "robcogen"), ("B", "robcogen2"))
    accepted_by = frozenset(target for column, target in columns if row[column] == "accept")
    return Case(
        row["name"], path, path.read_bytes().decode("utf-8", "surrogateescape"), accepted_by
    )
