"""What linting costs, as ratios of one run: against Python, rmt, textX, and small against large.

    python benchmarks/lint.py [--quick]

Whole processes are told by the least time of alternating rounds, so that both see the same machine.
The start is that of an environment in which only kindsl is installed, compiled: other packages slow
Python itself down. textX needs a minute for 1,000 links; `--quick` gives it 100. Exits with 1 when
a ratio is missed.
"""

import argparse
import gc
import os
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import time
import venv
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from benchmarks.parsing import edit_growth, faster_than_textx  # noqa: E402
from tests.support.models import Style, random_model  # noqa: E402

from kindsl.judgement.analysis.analysis import Analysis, analyse  # noqa: E402
from kindsl.language.syntax.document import parse  # noqa: E402

PLAIN = Style(has_comments=False, has_expressions=False)
QUADRUPED = ROOT / "examples" / "quadruped.kindsl"
# The goal is 4: 210 modules, 85 of whose classes are named tuples, take most of the time.
MOST = 9.0
ENVIRONMENT = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
LOAD = "import sys; from rmt.rmt import getmodels; getmodels(sys.argv[1])"


class Ratio(NamedTuple):
    """A measured ratio and its bound; a negative bound is a least one."""

    name: str
    value: float
    bound: float

    @property
    def is_met(self) -> bool:
        return self.value <= self.bound if self.bound > 0 else self.value >= -self.bound

    def __str__(self) -> str:
        verdict = "ok    " if self.is_met else "MISSED"
        limit = f"at most {self.bound:g}" if self.bound > 0 else f"at least {-self.bound:g}"
        return f"{verdict} {self.name}: {self.value:.2f} ({limit})"


def main() -> int:
    """Print the ratios; return 1 when one is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    ratios = []
    for ratio in measured(is_quick=options.quick):
        print(ratio, flush=True)
        ratios.append(ratio)
    return 0 if all(ratio.is_met for ratio in ratios) else 1


def measured(*, is_quick: bool) -> Iterator[Ratio]:
    """Yield all ratios."""
    yield from processes(rounds=10 if is_quick else 30)
    yield linting_against_parsing(1_000 if is_quick else 10_000)
    links = 100 if is_quick else 1_000
    _, faster, _ = faster_than_textx(links)
    bound = -1.0 if is_quick else -100.0
    yield Ratio(f"times faster to parse {links} links than textX", faster, bound)
    _, growth, _ = edit_growth()
    yield Ratio("a digit's edit in 10,000 links against one in 100", growth, 2.0)


def processes(rounds: int) -> Iterator[Ratio]:
    """Yield how long the whole process takes on 12 links, against Python and against rmt."""
    with tempfile.TemporaryDirectory() as folder:
        model = Path(folder) / "model.kindsl"
        model.write_text(random_model(12, 1, PLAIN))
        quadruped = shutil.copy(QUADRUPED, folder)
        python, lint = own_environment(Path(folder) / "own")
        for what, robot in (("12 links", model), ("the quadruped", quadruped)):
            empty, ours = least([(python, "-c", "pass"), (python, lint, robot)], rounds)
            print(f"process: python -c pass {empty * 1e3:.1f} ms, kdsl-lint {ours * 1e3:.1f} ms")
            yield Ratio(f"kdsl-lint on {what} against python -c pass", ours / empty, MOST)
        here = (sys.executable, lint, model)
        ours, theirs = least([here, (sys.executable, "-c", LOAD, model)], max(rounds // 3, 3))
    print(f"process: kdsl-lint {ours * 1e3:.1f} ms, rmt loading the same {theirs * 1e3:.1f} ms")
    yield Ratio("times faster than rmt loads 12 links", theirs / ours, -6.0)


def own_environment(folder: Path) -> tuple[Path, Path]:
    """Return the Python of a new environment with kindsl alone, and the linter's script."""
    venv.create(folder, symlinks=True)
    package = Path(sysconfig.get_path("purelib", vars={"base": str(folder)})) / "kindsl"
    shutil.copytree(ROOT / "server" / "kindsl", package)
    python, script = folder / "bin" / "python", folder / "bin" / "kdsl-lint"
    subprocess.run((python, "-m", "compileall", "-q", package), check=True)
    script.write_text("from kindsl.frontends.cli.lint import main\n\nmain()\n")
    return python, script


def least(commands: list[tuple[str | Path, ...]], rounds: int) -> list[float]:
    """Return the least wall time of each command, which must all succeed."""
    times: list[list[float]] = [[] for _ in commands]
    for _ in range(rounds):
        for command, found in zip(commands, times, strict=True):
            found.append(seconds(lambda command=command: run(command)))
    return [min(found) for found in times]


def run(command: tuple[str | Path, ...]) -> None:
    """Run a process that must succeed."""
    nowhere = subprocess.DEVNULL
    subprocess.run(command, stdout=nowhere, stderr=nowhere, env=ENVIRONMENT, check=True)


def linting_against_parsing(links: int) -> Ratio:
    """Return how much longer linting takes, parsing included, than parsing alone."""
    text = random_model(links, 1, PLAIN)
    assert analyse(random_model(3, 1, PLAIN)).findings == ()
    times = [
        (seconds(lambda: parse(text)), seconds(lambda: Analysis(parse(text)).findings))
        for _ in range(4)
    ]
    parsing, linting = (min(found) for found in zip(*times, strict=True))
    print(f"{links} links: parsed in {parsing * 1e3:.0f} ms, linted in {linting * 1e3:.0f} ms")
    return Ratio(f"linting {links} links against parsing them", linting / parsing, 3.0)


def seconds(work: Callable[[], object]) -> float:
    """Return the time of some work, the garbage of what was before left out."""
    gc.collect()
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


if __name__ == "__main__":
    sys.exit(main())
