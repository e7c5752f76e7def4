"""How much of a change of the code the tests notice: the score of sampled mutants.

    python benchmarks/mutation.py [--package NAME ...] [--count N] [--seed N]

Works on copies, two at a time. The tests run once to find which of them come past which change.
Then each change is made and these tests are run, those of its own package first and the quickest
of them first, until one fails. Prints what lives on. Exits with 1 when a score is below 95 %.
"""

import argparse
import compileall
import json
import os
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Sequence
from multiprocessing import get_context
from multiprocessing.pool import Pool
from pathlib import Path

# Loaded once for all runs, which are forks.
import hypothesis  # noqa: F401
import numpy  # noqa: F401
import pytest
import pytest_asyncio  # noqa: F401
import pytest_lsp  # noqa: F401

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from benchmarks.mutating.sites import Site, instrumented, mutated, sample  # noqa: E402

GOAL = 0.95
# The folders of tests for each package, its own first.
TESTS = {
    "rules": ("rules", "analysis", "config", "features"),
    "semantics": ("semantics", "rules", "mechanism", "analysis", "features"),
    "features": ("features",),
    "formatting": ("formatting",),
    "rigid": ("rigid", "rules", "mechanism"),
    "dynamics": ("dynamics", "mechanism", "spatial"),
}
# A mutant that outlives so many seconds of tests is said to live.
PATIENCE = 120.0
OPTIONS = ["-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist"]
OPTIONS += ["-p", "benchmarks.mutating.plugin", "-W", "ignore::pytest.PytestAssertRewriteWarning"]
REACHED = "numbers: set[int] = set()\n"

Seconds = dict[str, float]


class Copy:
    """A copy of the package in which one module at a time is another."""

    def __init__(self, folder: Path) -> None:
        self.kindsl = folder / "kindsl"
        shutil.copytree(ROOT / "server" / "kindsl", self.kindsl)
        (self.kindsl / "_reached.py").write_text(REACHED, encoding="utf-8")
        compileall.compile_dir(self.kindsl, quiet=2)

    def write(self, path: Path, source: str) -> None:
        """Write a module, and drop what was compiled of it."""
        file = self.kindsl / path
        file.write_text(source, encoding="utf-8")
        for compiled in (file.parent / "__pycache__").glob(f"{file.stem}.*.pyc"):
            compiled.unlink()

    def restore(self, path: Path) -> None:
        """Write a module as it is in the project."""
        self.write(path, original(path))

    def passes(self, tests: Sequence[str], timeout: float, **variables: str) -> bool:
        """Return whether tests pass, in a process that has all but kindsl loaded already."""
        process = os.fork()
        if process == 0:
            try:
                self._become(variables)
                status = pytest.main([*OPTIONS, *tests])
                sys.stdout.flush()
                os._exit(status)
            finally:
                os._exit(1)
        return _exit_status(process, timeout) == 0

    def _become(self, variables: dict[str, str]) -> None:
        """Make this process one that imports the copy and is quiet."""
        os.setpgrp()
        os.environ.update(variables, PYTHONPATH=str(self.kindsl.parent))
        sys.path.insert(0, str(self.kindsl.parent))
        sys.dont_write_bytecode = True
        _write_output_to(self.kindsl.parent / "output.txt")


def original(path: Path) -> str:
    """Return a module of the project."""
    return (ROOT / "server" / "kindsl" / path).read_text(encoding="utf-8")


def _write_output_to(path: Path) -> None:
    with path.open("w", encoding="utf-8") as file:
        os.dup2(file.fileno(), 1)
        os.dup2(file.fileno(), 2)


def _exit_status(process: int, timeout: float) -> int | None:
    """Wait for a process and what it started; return None if it takes too long."""
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        done, status = os.waitpid(process, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.02)
    os.killpg(process, signal.SIGKILL)
    os.waitpid(process, 0)
    return None


class Worker:
    """What one of the processes that share the work does, in a copy of its own."""

    copy: Copy

    @classmethod
    def begin(cls, folder: Path) -> None:
        """Make the copy."""
        cls.copy = Copy(folder / str(os.getpid()))

    @classmethod
    def reached(cls, asked: tuple[Sequence[Site], str]) -> list[Seconds]:
        """Return the tests in a folder that come past each site, with their seconds."""
        sites, folder = asked
        numbers: dict[Path, dict[int, list[int]]] = {}
        for number, site in enumerate(sites):
            numbers.setdefault(site.path, {}).setdefault(site.index, []).append(number)
        anywhere: set[int] = set()
        for path, by_index in numbers.items():
            source, at_import = instrumented(original(path), by_index)
            cls.copy.write(path, source)
            anywhere.update(at_import)
        report = cls.copy.kindsl.parent / "reached.json"
        if not cls.copy.passes([f"tests/{folder}"], 3600.0, MUTATION_REACHED=str(report)):
            output = (report.parent / "output.txt").read_text(encoding="utf-8")
            raise RuntimeError(f"the tests fail without a change:\n{output[-3000:]}")
        for path in numbers:
            cls.copy.restore(path)
        found: list[Seconds] = [{} for _ in sites]
        by_test = json.loads(report.read_text(encoding="utf-8"))
        anywhere.update(by_test.pop("")[0])
        for name, (passed, seconds) in by_test.items():
            for number in anywhere.union(passed):
                found[number][name] = seconds
        return found

    @classmethod
    def lives(cls, change: tuple[Site, Seconds]) -> bool:
        """Return whether all tests that come past a change pass with it."""
        site, tests = change
        near = f"tests/{site.path.parts[0]}/"
        own = {name: seconds for name, seconds in tests.items() if name.startswith(near)}
        others = {name: seconds for name, seconds in tests.items() if name not in own}
        cls.copy.write(site.path, mutated(original(site.path), site))
        lives = cls._passes(_quickest(own)) and cls._passes(_quickest(others))
        cls.copy.restore(site.path)
        return lives

    @classmethod
    def _passes(cls, tests: Seconds) -> bool:
        if not tests:
            return True
        listed = cls.copy.kindsl.parent / "tests.txt"
        listed.write_text("\n".join(tests), encoding="utf-8")
        files = sorted({name.partition("::")[0] for name in tests})
        timeout = 60.0 + 5.0 * sum(tests.values())
        return cls.copy.passes(files, timeout, MUTATION_TESTS=str(listed))


def _quickest(tests: Seconds) -> Seconds:
    """Return the tests in the order of their seconds, as far as patience goes."""
    chosen: Seconds = {}
    for name in sorted(tests, key=lambda name: tests[name]):
        chosen[name] = tests[name]
        if sum(chosen.values()) > PATIENCE:
            break
    return chosen


def scores(packages: Sequence[str], count: int, seed: int) -> list[float]:
    """Print what lives of samples of packages' mutants; return the parts that do not."""
    server = ROOT / "server" / "kindsl"
    with tempfile.TemporaryDirectory() as folder:
        begin = {"initializer": Worker.begin, "initargs": (Path(folder),)}
        with get_context("fork").Pool(2, **begin) as pool:
            return [
                score(pool, package, sample(server, package, count, seed)) for package in packages
            ]


def score(pool: Pool, package: str, sites: Sequence[Site]) -> float:
    """Print what lives of a package's mutants; return the part that does not."""
    start = time.monotonic()
    found = pool.map(Worker.reached, [(sites, folder) for folder in TESTS[package]], chunksize=1)
    changes = [
        (site, {name: seconds for tests in found for name, seconds in tests[number].items()})
        for number, site in enumerate(sites)
    ]
    print(f"{package}: {_minutes(start)} to find the tests", flush=True)
    alive: list[Site] = []
    for (site, tests), lives in zip(changes, pool.imap(Worker.lives, changes), strict=True):
        if lives:
            alive.append(site)
            where = f"{site.path}:{site.line}"
            print(f"  lives: {where}: {site.change} ({len(tests)} tests)", flush=True)
    killed = 1.0 - len(alive) / len(sites)
    for kind in sorted({site.kind for site in sites}):
        print(f"  {kind}s: {_noticed(sites, alive, kind)}")
    print(
        f"{package}: {_noticed(sites, alive)} noticed, {killed:.0%}, {_minutes(start)}", flush=True
    )
    return killed


def _noticed(sites: Sequence[Site], alive: Sequence[Site], kind: str = "") -> str:
    tried, left = ([s for s in some if kind in ("", s.kind)] for some in (sites, alive))
    return f"{len(tried) - len(left)} of {len(tried)}"


def _minutes(start: float) -> str:
    return f"{(time.monotonic() - start) / 60.0:.1f} min"


def main() -> int:
    """Return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--package", action="append", choices=TESTS)
    parser.add_argument("--count", type=int, default=25)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    return (
        0 if min(scores(options.package or list(TESTS), options.count, options.seed)) >= GOAL else 1
    )


if __name__ == "__main__":
    raise SystemExit(main())
