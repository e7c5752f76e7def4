"""How often a hand stumbles that types robots into VS Code's editor core.

    python benchmarks/typist.py [FILE ...] [--delay 12] [--pause 250] [--closing never] [--hurry]
    python benchmarks/typist.py --squiggles [FILE ...]

Types every line of the documents (the examples and, where they are there, the published models
beside this project), 12 ms a key, waits a quarter of a second, presses Enter. A stumble is an Enter
that did something else than break the line. Ends with status 1 if there is one.

With `--squiggles` it counts, without a browser, the squiggles that come while a line is typed and
are gone when it is done, all versions being checked, and how many there were if all were told.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.typist.monaco import QUICK_FRAMES, editor
from tests.typist.squiggles import passing_squiggles
from tests.typist.typist import Hand, lines_to_type, type_document
from tests.vscode.browser import chromium

from kindsl.judgement.analysis.analysis import analyse

ROOT = Path(__file__).resolve().parents[1]
PUBLISHED = ROOT.parent / "shared" / "corpus"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("files", nargs="*", type=Path)
    parser.add_argument("--delay", type=float, default=12, help="milliseconds between two keys")
    parser.add_argument("--pause", type=float, default=250, help="milliseconds before Enter")
    parser.add_argument(
        "--closing", choices=["languageDefined", "never"], default="languageDefined"
    )
    parser.add_argument(
        "--hurry", action="store_true", help="type lines like one before too fast for any list"
    )
    parser.add_argument("--squiggles", action="store_true", help="count passing squiggles")
    options = parser.parse_args()
    files = options.files or [*sorted(ROOT.glob("examples/*.kindsl")), *published()]
    if options.squiggles:
        return int(sum(map(passing, files)) > 0)
    hand = Hand(options.delay, options.pause, options.hurry)
    count = sum(len(typed(file, hand, options.closing)) for file in files)
    print(f"{count} stumbles in {len(files)} documents")
    return int(count > 0)


def passing(file: Path) -> int:
    """Type a document and print how many squiggles pass; return it."""
    lines = lines_to_type(file.read_text())
    told, all_found = (len(passing_squiggles(lines, is_calm=is_calm)) for is_calm in (True, False))
    print(f"{file.name:50} {len(lines):5} lines, {told} squiggles pass, {all_found} if all told")
    return told


def published() -> list[Path]:
    """Return the published models that can be parsed."""
    files = sorted(PUBLISHED.glob("*.kindsl"))
    return [f for f in files if not analyse(f.read_text()).syntax.problems]


def typed(file: Path, hand: Hand, closing: str) -> list[object]:
    """Type a document; print and return the stumbles."""
    lines = lines_to_type(file.read_text())
    with chromium(*QUICK_FRAMES) as browser, editor(browser, autoClosingBrackets=closing) as page:
        stumbles = type_document(page, lines, hand)
    print(f"{file.name:50} {len(lines):5} lines, {len(stumbles)} stumbles", flush=True)
    for stumble in stumbles:
        print(f"    {stumble}")
    return list(stumbles)


if __name__ == "__main__":
    sys.exit(main())
