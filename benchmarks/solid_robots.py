"""How many honest robots are convicted: `python benchmarks/solid_robots.py`.

The robots are `tests/support/solid_robots.py`; each is judged as a URDF and as a document. It ends
with 1 where more than one in a hundred has an error or a warning. `--write FOLDER` writes the URDFs
there, for slips to be planted in them: `python benchmarks/planted_bodies.py FOLDER`.
"""

import argparse
import sys
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.support.solid_robots import solid_robots

from kindsl.judgement.analysis.analysis import analyse
from kindsl.robots.interchange.kindsl_writing import written_kindsl
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf

MOST = 0.01


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--number", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--write", type=Path)
    given = parser.parse_args()
    convicted: Counter[str] = Counter()
    for name, text in solid_robots(given.number, given.seed):
        if given.write is not None:
            given.write.mkdir(parents=True, exist_ok=True)
            (given.write / f"{name}.urdf").write_text(text)
        convicted["URDF"] += is_convicted(name, text)
    for name, text in solid_robots(given.number, given.seed, are_exact=True):
        convicted["document"] += is_convicted(name, written_kindsl(robot_of_urdf(text, name)).text)
    print(f"{given.number} robots, convicted: {dict(convicted)}")
    return int(max(convicted.values()) > MOST * given.number)


def is_convicted(name: str, text: str) -> bool:
    severe = [f for f in analyse(text).findings if f.severity in ("error", "warning")]
    for found in severe:
        print(f"{name}: {found.code} {found.message}")
    return bool(severe)


if __name__ == "__main__":
    raise SystemExit(main())
