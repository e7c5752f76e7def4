"""How much of a change of the code the tests notice: the score of sampled mutants.

    python benchmarks/mutation.py [FOLDER ...] [--count N] [--seed N] [--processes N] [--patience S]
                                  [--tests PATH ...]

A folder is one of the server's, such as `rules` or `lsp/session`. Works on copies, two at a time.
The tests run once to find which of them come past which change, in this process or in one that
they start; those that drive a browser are left out. Then each change is made and these tests are
run, those of its own package first and the quickest of them first, until one fails. Prints what
lives on, what makes its tests end too late, which counts as noticed, and a table. Exits with 1
when a score is below 95 %.
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
from collections.abc import Iterator, Sequence
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
_FIRST = 3.0  # seconds of tests
# What is tried if nothing is named, with the folders or files of its tests, its own first. Any
# other folder has the tests of the innermost folder around it that is named here, else those of
# its package.
TESTS = {
    "rules": ("rules", "analysis", "config", "features"),
    "semantics": ("semantics", "rules", "mechanism", "analysis", "features"),
    "features": ("features",),
    "formatting": ("formatting",),
    "rigid": ("rigid", "rules", "mechanism"),
    "dynamics": ("dynamics", "mechanism", "spatial"),
    "reports": ("reports", "cli"),
    "interchange": ("interchange", "comparison", "cli", "analysis/test_pasted_urdf.py"),
    "lsp/session": ("lsp",),
    "config": ("config", "cli"),
    # Without those that compile for minutes: a changed text is noticed where texts are recorded.
    "codegen": (
        "codegen/test_recorded_files.py", "codegen/test_reference.py", "codegen/test_refusals.py",
        "codegen/test_choice_of_lanes.py", "codegen/test_what_is_told.py", "codegen/test_names.py",
        "codegen/test_checking.py", "cli/test_generate.py", "cli/test_robcogen.py",
        "cli/test_transforms.py",
    ),
    "scene": ("scene", "preview"),
}  # fmt: skip
OPTIONS = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist"]
OPTIONS += ["-p", "benchmarks.mutating.plugin", "-W", "ignore::pytest.PytestAssertRewriteWarning"]
# A file for each number, since the tests may come past it in a process that they start.
REACHED = """
import contextlib, os

def note(numbers):
    if "MUTATION_NOTES" in os.environ:
        for number in numbers:
            path = os.path.join(os.environ["MUTATION_NOTES"], str(number))
            # A test may give up its rights.
            if not os.path.exists(path):
                with contextlib.suppress(OSError):
                    open(path, "w").close()
"""

Seconds = dict[str, float]


class Copy:
    """A copy of the package in which one module at a time is another."""

    def __init__(self, folder: Path) -> None:
        self.kindsl = folder / "server" / "kindsl"
        shutil.copytree(ROOT / "server" / "kindsl", self.kindsl)
        for beside in ("docs", "grammar", "pyproject.toml"):
            (folder / beside).symlink_to(ROOT / beside)
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

    def status(self, tests: Sequence[str], timeout: float, **variables: str) -> int | None:
        """Return pytest's status, in a process that has all but kindsl loaded; None if too late."""
        process = os.fork()
        if process == 0:
            try:
                self._become(variables)
                status = pytest.main([*OPTIONS, *tests])
                sys.stdout.flush()
                os._exit(status)
            finally:
                os._exit(1)
        return _exit_status(process, timeout)

    def _become(self, variables: dict[str, str]) -> None:
        """Make this process one that imports the copy and is quiet."""
        os.setpgrp()
        folder = str(self.kindsl.parent)
        os.environ.update(variables, PYTHONPATH=folder, PYTHONDONTWRITEBYTECODE="1")
        sys.path.insert(0, folder)
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
    patience: float

    @classmethod
    def begin(cls, folder: Path, patience: float) -> None:
        """Make the copy."""
        cls.copy = Copy(folder / str(os.getpid()))
        cls.patience = patience

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
        notes = cls.copy.kindsl.parent / "notes"
        shutil.rmtree(notes, ignore_errors=True)
        notes.mkdir()
        variables = {"MUTATION_REACHED": str(report), "MUTATION_NOTES": str(notes)}
        if cls.copy.status([f"tests/{folder}"], 3600.0, **variables) != 0:
            output = (notes.parent / "output.txt").read_text(encoding="utf-8")
            print(f"left out, since they fail without a change:\n{output[-1000:]}")
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
    def fate(cls, change: tuple[Site, Seconds]) -> str:
        """Return `lives` if all tests that come past a change pass, else `killed` or `late`."""
        site, tests = change
        near = f"tests/{site.path.parts[0]}/"
        own = {name: seconds for name, seconds in tests.items() if name.startswith(near)}
        others = {name: seconds for name, seconds in tests.items() if name not in own}
        cls.copy.write(site.path, mutated(original(site.path), site))
        batches = (batch for some in (own, others) for batch in cls._batches(some))
        fates = (cls._fate(batch) for batch in batches)
        fate = next((fate for fate in fates if fate != "lives"), "lives")
        cls.copy.restore(site.path)
        return fate

    @classmethod
    def _fate(cls, tests: Seconds) -> str:
        listed = cls.copy.kindsl.parent / "tests.txt"
        listed.write_text("\n".join(tests), encoding="utf-8")
        files = sorted({name.partition("::")[0] for name in tests})
        timeout = 120.0 + 5.0 * sum(tests.values())
        told = cls.copy.status(files, timeout, MUTATION_TESTS=str(listed), PYTEST_ADDOPTS="-x")
        return {0: "lives", None: "late"}.get(told, "killed")

    @classmethod
    def _batches(cls, tests: Seconds) -> Iterator[Seconds]:
        """Yield tests in the order of their seconds, as far as patience goes.

        First only a few, so that what hangs is not waited for as long as for all.
        """
        left = sorted(tests, key=lambda name: tests[name], reverse=True)
        for patience in (min(_FIRST, cls.patience), cls.patience):
            batch: Seconds = {}
            while left and sum(batch.values()) <= patience:
                name = left.pop()
                batch[name] = tests[name]
            if batch:
                yield batch


def tests_of(folder: str) -> Sequence[str]:
    """Return the folders of tests that concern a folder of the server, its own first."""
    for around in (folder, *map(str, Path(folder).parents)):
        if around in TESTS:
            return TESTS[around]
    return (Path(folder).parts[0],)


def score(pool: Pool, folder: str, sites: Sequence[Site], tests: Sequence[str]) -> int:
    """Print what lives of a folder's mutants in some tests; return how many do not."""
    start = time.monotonic()
    found = pool.map(Worker.reached, [(sites, path) for path in tests], chunksize=1)
    changes = [
        (site, {name: seconds for tests in found for name, seconds in tests[number].items()})
        for number, site in enumerate(sites)
    ]
    print(f"{folder}: {_minutes(start)} to find the tests", flush=True)
    alive: list[Site] = []
    for (site, passed), fate in zip(changes, pool.imap(Worker.fate, changes), strict=True):
        if fate == "lives":
            alive.append(site)
        if fate != "killed":
            where = f"{site.path}:{site.line}"
            print(f"  {fate}: {where}: {site.change} ({len(passed)} tests)", flush=True)
    for kind in sorted({site.kind for site in sites}):
        print(f"  {kind}s: {_noticed(sites, alive, kind)}")
    print(f"{folder}: {_noticed(sites, alive)} noticed, {_minutes(start)}", flush=True)
    return len(sites) - len(alive)


def _noticed(sites: Sequence[Site], alive: Sequence[Site], kind: str = "") -> str:
    tried, left = ([s for s in some if kind in ("", s.kind)] for some in (sites, alive))
    return f"{len(tried) - len(left)} of {len(tried)}"


def _minutes(start: float) -> str:
    return f"{(time.monotonic() - start) / 60.0:.1f} min"


def main() -> int:
    """Return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folders", nargs="*", metavar="FOLDER", help=f"else {', '.join(TESTS)}")
    parser.add_argument("--count", type=int, default=25, help="of mutants in each folder")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument(
        "--patience", type=float, default=120.0, help="seconds of tests that a mutant outlives"
    )
    parser.add_argument("--tests", nargs="+", help="below tests, instead of those that concern it")
    options = parser.parse_args()
    server = ROOT / "server" / "kindsl"
    rows: list[tuple[str, int, int]] = []
    with tempfile.TemporaryDirectory() as work:
        begin = Path(work), options.patience
        with get_context("fork").Pool(options.processes, Worker.begin, begin) as pool:
            for folder in options.folders or TESTS:
                sites = sample(server, folder, options.count, options.seed)
                tests = options.tests or tests_of(folder)
                rows.append((folder, len(sites), score(pool, folder, sites, tests)))
    print(f"{'folder':16}{'mutants':>8}{'killed':>8}{'percent':>9}")
    for folder, count, killed in rows:
        print(f"{folder:16}{count:8}{killed:8}{killed / count:9.1%}")
    return 0 if all(killed >= GOAL * count for _, count, killed in rows) else 1


if __name__ == "__main__":
    raise SystemExit(main())
