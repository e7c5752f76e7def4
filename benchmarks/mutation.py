"""How much of a change of the code the tests notice: the score of sampled mutants.

    python benchmarks/mutation.py [--package NAME ...] [--count N] [--seed N]

Works on a copy. The package's tests run once to find which of them reach which change, then each
change is made and these tests are run, the quickest first, until one fails. Prints what lives on.
Exits with 1 when a score is below 95 %.
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
TESTS = {
    "rules": [
        "tests/rules",
        "tests/analysis",
        "tests/config",
        "tests/features/test_quick_fixes.py",
    ],
    "semantics": ["tests/semantics", "tests/rules", "tests/mechanism"],
    "features": ["tests/features"],
    "formatting": ["tests/formatting"],
    "rigid": ["tests/rigid", "tests/rules", "tests/mechanism"],
    "dynamics": ["tests/dynamics", "tests/mechanism"],
}
OPTIONS = ["-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist"]
OPTIONS += ["-p", "benchmarks.mutating.plugin", "-W", "ignore::pytest.PytestAssertRewriteWarning"]
REACHED = "numbers: set[int] = set()\n"


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


def tests_of(copy: Copy, sites: Sequence[Site], tests: Sequence[str]) -> list[dict[str, float]]:
    """Return the tests that reach each site, with their seconds."""
    for path in {site.path for site in sites}:
        numbers: dict[int, list[int]] = {}
        for number, site in enumerate(sites):
            if site.path == path:
                numbers.setdefault(site.index, []).append(number)
        copy.write(path, instrumented(original(path), numbers))
    report = copy.kindsl.parent / "reached.json"
    if not copy.passes(tests, 3600.0, MUTATION_REACHED=str(report)):
        output = (report.parent / "output.txt").read_text(encoding="utf-8")
        raise SystemExit(f"the tests fail without a change:\n{output[-3000:]}")
    for path in {site.path for site in sites}:
        copy.restore(path)
    found: list[dict[str, float]] = [{} for _ in sites]
    for name, (numbers_reached, seconds) in json.loads(report.read_text(encoding="utf-8")).items():
        for number in numbers_reached:
            found[number][name] = seconds
    return found


def lives(copy: Copy, site: Site, tests: dict[str, float]) -> bool:
    """Return whether all tests that reach a change pass with it."""
    chosen = sorted(tests, key=lambda name: tests[name])
    listed = copy.kindsl.parent / "tests.txt"
    listed.write_text("\n".join(chosen), encoding="utf-8")
    files = sorted({name.partition("::")[0] for name in chosen})
    copy.write(site.path, mutated(original(site.path), site))
    timeout = 60.0 + 5.0 * sum(tests.values())
    passes = not chosen or copy.passes(files, timeout, MUTATION_TESTS=str(listed))
    copy.restore(site.path)
    return passes


def score(package: str, count: int, seed: int) -> float:
    """Print what lives of a sample of a package's mutants; return the part that does not."""
    sites = sample(ROOT / "server" / "kindsl", package, count, seed)
    start, n_alive = time.monotonic(), 0
    with tempfile.TemporaryDirectory() as folder:
        copy = Copy(Path(folder))
        for site, tests in zip(sites, tests_of(copy, sites, TESTS[package]), strict=True):
            if lives(copy, site, tests):
                n_alive += 1
                where = f"{site.path}:{site.line}"
                print(f"  lives: {where}: {site.change} ({len(tests)} tests)", flush=True)
    killed = 1.0 - n_alive / len(sites)
    minutes = (time.monotonic() - start) / 60.0
    n_killed = len(sites) - n_alive
    print(f"{package}: {n_killed} of {len(sites)} noticed, {killed:.0%}, {minutes:.1f} min")
    return killed


def main() -> int:
    """Return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--package", action="append", choices=TESTS)
    parser.add_argument("--count", type=int, default=25)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    packages = options.package or list(TESTS)
    scores = [score(package, options.count, options.seed) for package in packages]
    return 0 if min(scores) >= GOAL else 1


if __name__ == "__main__":
    raise SystemExit(main())
