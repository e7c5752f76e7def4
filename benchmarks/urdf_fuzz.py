"""Mutated URDFs are read or refused, never slowly: `python benchmarks/urdf_fuzz.py [--minutes N]`.

The robots of the round-trip tests are written as URDF, and whole files of a folder where one is
named. Attributes are swapped, lost, doubled, cut and made no numbers. It ends with 1 where anything
but `FormatError` comes out, a result has a number that is none, or a mutant takes ten times as long
as the file that it was made of.
"""

import argparse
import random
import re
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.interchange.random_robots import random_robot
from tests.support.urdf_mutants import mutant

import kindsl
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.kindsl_writing import kindsl_text
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf
from kindsl.robots.interchange.urdf.writing import written_urdf

NO_NUMBER = re.compile(r"[=(,] *-?(nan|inf)\b")
SLOW, NOTICEABLE = 10.0, 0.05


def texts(folder: Path | None) -> list[str]:
    if folder is not None:
        return [path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*.urdf"))]
    robots = (kindsl.parse(kindsl_text(random_robot(seed))).skeleton() for seed in range(20))
    return [written_urdf("robot", robot).text for robot in robots]


def seconds_and_outcome(text: str, path: Path) -> tuple[float, str]:
    path.write_text(text, encoding="utf-8")
    start = time.process_time()
    try:
        document = kindsl_text(robot_of_urdf(path.read_bytes(), "robot").robot)
        outcome = "no number" if NO_NUMBER.search(document) else "read"
    except FormatError as error:
        outcome = "refused" if "\n" not in str(error) else "many lines"
    except Exception as error:
        outcome = f"{type(error).__name__}: {error}"
    return time.process_time() - start, outcome


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--folder", type=Path)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    generator = random.Random(options.seed)
    outcomes: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "robot.urdf")
        originals = texts(options.folder)
        usual = [min(seconds_and_outcome(t, path)[0] for _ in range(3)) for t in originals]
        end = time.monotonic() + 60.0 * options.minutes
        while time.monotonic() < end:
            index = generator.randrange(len(originals))
            text = mutant(originals[index], generator)
            seconds, outcome = seconds_and_outcome(text, path)
            if seconds > max(SLOW * usual[index], NOTICEABLE):
                outcome = "slow"
            outcomes[outcome] += 1
            if outcome not in ("read", "refused") and outcomes[outcome] == 1:
                Path(f"mutant_{len(outcomes)}.urdf").write_text(text, encoding="utf-8")
    for outcome, count in outcomes.most_common():
        print(f"{count:8} {outcome}")
    return int(bool(set(outcomes) - {"read", "refused"}))


if __name__ == "__main__":
    sys.exit(main())
