"""The documents with both generators' verdicts that lie beside the project, or do not."""

import gzip
import json
from functools import cache
from pathlib import Path
from typing import Any

FILE = Path(__file__).parents[3] / "shared" / "differential" / "cases.jsonl.gz"


@cache
def shared_cases() -> tuple[dict[str, Any], ...]:
    """Return the cases, none where the file is absent."""
    if not FILE.is_file():
        return ()
    with gzip.open(FILE, "rt", encoding="utf-8") as file:
        return tuple(map(json.loads, file))
