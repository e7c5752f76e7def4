"""Reading documents, as ratios of one run: against textX, and large against small.

    python benchmarks/parsing.py [--quick]

textX is the parser of robot-model-tools, which needs a minute for 1,000 links; `--quick` takes 100.
Exits with 1 when a ratio is missed.
"""

import argparse
import gc
import os
import random
import re
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.support.models import Style, random_model  # noqa: E402

from kindsl.language.syntax.document import SyntaxDocument, parse  # noqa: E402
from kindsl.language.text.edits import TextEdit  # noqa: E402

LEAST_FASTER = 100.0
MOST_EDIT_GROWTH = 2.0
MOST_START = 3.0
MOST_SLIPS = 25.0
PLAIN = Style(has_comments=False)


def main() -> int:
    """Print the ratios; return 1 when one is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true")
    links = 100 if parser.parse_args().quick else 1000
    checks = [faster_than_textx(links), edit_growth(), start(), slips(100)]
    for name, ratio, is_met in checks:
        print(f"{'ok    ' if is_met else 'MISSED'} {name}: {ratio:.2f}")
    return 0 if all(is_met for _, _, is_met in checks) else 1


def faster_than_textx(links: int) -> tuple[str, float, bool]:
    """Return how many times faster a document is read than by textX."""
    import robmodel.convert.kindsl.imp as rmt
    import textx

    language = textx.metamodel_from_file(Path(rmt.__file__).with_name("kindsl.tx"))
    text = random_model(links, 1, PLAIN)
    ours = seconds(lambda: parse(text), 5)
    theirs = seconds(lambda: language.model_from_str(text), 1)
    print(f"{links} links: kindsl {ours * 1e3:.0f} ms, textX {theirs * 1e3:.0f} ms")
    name = f"times faster than textX at {links} links (at least {LEAST_FASTER:.0f})"
    return name, theirs / ours, links < 1000 or theirs / ours >= LEAST_FASTER


def edit_growth() -> tuple[str, float, bool]:
    """Return how much longer an edit takes in 10,000 links than in 100."""
    small, large = digit_edit(100), digit_edit(10_000)
    print(f"digit edit: 100 links {small * 1e6:.0f} us, 10,000 links {large * 1e6:.0f} us")
    name = f"an edit's growth from 100 to 10,000 links (at most {MOST_EDIT_GROWTH:.0f})"
    return name, large / small, large / small <= MOST_EDIT_GROWTH


def digit_edit(links: int) -> float:
    """Return the median time of changing a digit, problems of the document included."""
    document = parse(random_model(links, 1))
    places = [match.start(1) for match in re.finditer(r"mass = (\d)", document.text)]
    gc.collect()
    gc.freeze()
    times = []
    for count in range(300):
        place = places[count * 7919 % len(places)]
        start_time = time.perf_counter()
        document = typed(document, place, str(count % 9 + 1))
        times.append(time.perf_counter() - start_time)
    return statistics.median(times)


def typed(document: SyntaxDocument, place: int, digit: str) -> SyntaxDocument:
    """Return the document with one digit replaced, its problems known."""
    document = document.edited([TextEdit(place, place + 1, digit)])
    assert document.problems == ()
    return document


def start() -> tuple[str, float, bool]:
    """Return how much longer a process takes that parses a model of 12 links than an empty one."""
    command = (
        "import sys; from kindsl.language.syntax.document import parse; parse(sys.stdin.read())"
    )
    ours, plain = process(command), process("pass")
    print(f"process: empty {plain * 1e3:.1f} ms, with a parsed model {ours * 1e3:.1f} ms")
    ratio = ours / plain
    return f"start against an empty process (at most {MOST_START:.0f})", ratio, ratio <= MOST_START


def slips(count: int) -> tuple[str, float, bool]:
    """Return how much longer a robot takes when tokens are lost, doubled and replaced in it."""
    generator = random.Random(1)
    text = right = (ROOT / "examples/quadruped.kindsl").read_text(encoding="utf-8")
    for _ in range(count):
        tokens = [match.span() for match in re.finditer(r"[\w.]+|\S", text)]
        (start, end), (other, other_end) = generator.sample(tokens, 2)
        new = ("", text[start:end] * 2, text[other:other_end])[generator.randrange(3)]
        text = text[:start] + new + text[end:]
    whole, spoilt = (seconds(lambda each=each: parse(each), 9) for each in (right, text))
    print(f"quadruped: {whole * 1e3:.1f} ms, with {count} slips {spoilt * 1e3:.0f} ms")
    name = f"a robot with {count} slips against one without (at most {MOST_SLIPS:.0f})"
    return name, spoilt / whole, spoilt / whole <= MOST_SLIPS


def process(command: str) -> float:
    """Return the least time of some processes that are given a model."""
    run, model = [sys.executable, "-c", command], random_model(12).encode()
    compiled = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}

    def once() -> object:
        return subprocess.run(run, input=model, check=True, env=compiled)

    return seconds(once, 15)


def seconds(work: Callable[[], object], times: int) -> float:
    """Return the least time of some runs."""
    found = []
    for _ in range(times):
        start_time = time.perf_counter()
        work()
        found.append(time.perf_counter() - start_time)
    return min(found)


if __name__ == "__main__":
    sys.exit(main())
