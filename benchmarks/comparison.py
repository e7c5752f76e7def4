"""How right comparisons of robots are, and how long they take: `python benchmarks/comparison.py`.

Each random robot is compared with a URDF of it whose link frames, names, order, signs and fixed
links are others; then one number of either is off by 1 %. `--number N` tries so many. The time is
that of a twin of 12 links, beside that of all other rules.
"""

import argparse
import statistics
import sys
import time
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.comparison.trials import (
    Trial,
    described_text,
    described_urdf,
    equal_trial,
    off_trial,
    random_document,
)
from tests.comparison.variants import links_of, urdf_of, variant

from kindsl.judgement.analysis.analysis import analyse
from kindsl.robots.comparison.mechanical import compared_mechanics
from kindsl.robots.comparison.quantities import INERTIA, POSE

QUADRUPED = Path(__file__).resolve().parents[1] / "examples" / "quadruped.kindsl"
_ROUNDS = 15


def main() -> None:
    """Print the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--number", type=int, default=500)
    number = parser.parse_args().number
    equal = Counter(equal_trial(random_document(s), s).is_equal for s in range(number))
    print(f"conventions only: equal in {equal[True]} of {number}")
    trials = [off_trial(random_document(s), s) for s in range(number)]
    print(f"one number off by 1 %: {_told(trials)}, of {number}")
    for quantity in (*INERTIA, *POSE):
        print(f"  {quantity:5}  {_told([t for t in trials if t.expected[1] == quantity])}")
    print_times()


def _told(trials: Sequence[Trial]) -> str:
    counts = Counter(trial.result for trial in trials)
    return ", ".join(f"{result} {count}" for result, count in counts.most_common())


def print_times() -> None:
    """Print what a comparison of the quadruped takes, beside all rules."""
    text = QUADRUPED.read_text("utf-8")
    ours, _ = described_text(text)
    floating = ours.skeleton.is_floating
    same = described_urdf(urdf_of(links_of(ours.skeleton)), floating)
    other = described_urdf(urdf_of(variant(ours.skeleton, 7)), floating)
    print(f"{ours.skeleton.n_links} links, ms of processor time, median of {_ROUNDS}")
    print(f"  all rules               {_milliseconds(lambda: analyse(text).findings):6.1f}")
    print(f"  the same conventions    {_milliseconds(lambda: compared_mechanics(ours, same)):6.1f}")
    print(
        f"  other conventions       {_milliseconds(lambda: compared_mechanics(ours, other)):6.1f}"
    )


def _milliseconds(work: Callable[[], object]) -> float:
    work()
    times = []
    for _ in range(_ROUNDS):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return 1e3 * statistics.median(times)


if __name__ == "__main__":
    main()
