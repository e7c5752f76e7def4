"""Messages of a lump of up to four tokens lost, doubled or swapped, or one that became a bracket.

`python benchmarks/lost_tokens.py [--count N] [--seed S] [PATH ...]`: a table of how many messages
(errors and warnings beyond those of the untouched document) one such mistake gives, and the worst
cases. It ends with 1 where more than 0.5 % give more than two, or one gives more than three.
"""

import argparse
import random
import sys
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.support.models import LAYOUTS, Style, random_model
from tests.support.mutants import Mutant, lumps

from kindsl.judgement.analysis.analysis import analyse

ROOT = Path(__file__).resolve().parents[1]
MOST_SHOWN = 10


def told(text: str) -> Counter[tuple[str, str]]:
    found = analyse(text).findings
    return Counter((f.code, f.message) for f in found if f.severity in ("error", "warning"))


def show(mutant: Mutant, new: Counter[tuple[str, str]]) -> None:
    print(f"\n{mutant.kind}: {mutant.text[mutant.offset - 50 : mutant.offset + 50]!r}")
    for code, message in new.elements():
        print(f"  {code} {message}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", default="1")
    parser.add_argument("paths", nargs="*", type=Path)
    options = parser.parse_args()
    paths = options.paths or sorted((ROOT / "examples").glob("[!b]*.kindsl"))
    texts = [path.read_text(encoding="utf-8") for path in paths]
    texts += [random_model(6, 3, Style(layout=layout, has_expressions=False)) for layout in LAYOUTS]
    generator = random.Random(options.seed)
    sources = [lumps(text, generator) for text in texts]
    usual = [told(text) for text in texts]
    counts: Counter[int] = Counter()
    for _ in range(options.count):
        number = generator.randrange(len(texts))
        mutant = next(sources[number])
        new = told(mutant.text) - usual[number]
        counts[new.total()] += 1
        if new.total() > 2 and sum(counts[n] for n in counts if n > 2) <= MOST_SHOWN:
            show(mutant, new)
    many = sum(counts[n] for n in counts if n > 2)
    print(f"\n{options.count} mutants, messages: {dict(sorted(counts.items()))}")
    print(f"more than two: {many} ({many / options.count:.2%})")
    return int(many > 0.005 * options.count or max(counts) > 3)


if __name__ == "__main__":
    sys.exit(main())
