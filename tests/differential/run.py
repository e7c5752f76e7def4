"""Holds the verdict for robcogen2 against robot-model-tools on random documents.

PYTHONPATH=. python -m tests.differential.run --documents 5000 --seed 1
"""

import argparse
import sys
import tempfile
from collections import Counter
from itertools import islice
from pathlib import Path

from tests.differential.documents import documents
from tests.differential.references import robot_model_tools
from tests.differential.verdicts import is_read


def main() -> int:
    """Print each document on which the verdicts differ, and the counts; 1 if there is one."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--documents", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    counts: Counter[tuple[bool, bool]] = Counter()
    with tempfile.TemporaryDirectory() as folder:
        for document in islice(documents(options.seed), options.documents):
            answer = robot_model_tools(document.text, Path(folder))
            ours = is_read(document.text, "robcogen2")
            counts[answer.reads, ours] += 1
            if ours != answer.reads:
                told = answer.says or "reads it"
                print(f"--- {document.kind}: robot-model-tools: {told}\n{document.text}")
    false = f"accepted falsely {counts[False, True]}, refused falsely {counts[True, False]}"
    print(f"{options.documents} documents, {counts[True, True]} read by both; {false}")
    return int(bool(counts[False, True] or counts[True, False]))


if __name__ == "__main__":
    sys.exit(main())
