"""For pytest: notes which tests reach which changes, or runs the tests of a list in its order.

With `MUTATION_REACHED` a JSON file is written there: for each test the numbers it reached, which
are names of files in `MUTATION_NOTES`, and its seconds; under no name the numbers that importing
the tests reached. A test that fails is left out. With `MUTATION_TESTS` that file's tests are run,
one a line, and no others. What drives a browser is too slow for either.
"""

import json
import os
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

_found: dict[str, tuple[list[int], float]] = {}
_failed: set[str] = set()


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    if report.failed:
        _failed.add(report.nodeid)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    if "MUTATION_REACHED" not in os.environ:
        return (yield)
    start = time.perf_counter()
    result = yield
    _found[item.nodeid] = _reached(), time.perf_counter() - start
    return result


def pytest_collection_finish() -> None:
    if "MUTATION_REACHED" in os.environ:
        _found[""] = _reached(), 0.0


def pytest_sessionfinish() -> None:
    if "MUTATION_REACHED" in os.environ:
        passed = {name: found for name, found in _found.items() if name not in _failed}
        Path(os.environ["MUTATION_REACHED"]).write_text(json.dumps(passed), encoding="utf-8")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    if "MUTATION_TESTS" in os.environ:
        wanted = Path(os.environ["MUTATION_TESTS"]).read_text(encoding="utf-8").splitlines()
        by_name = {item.nodeid: item for item in items}
        items[:] = [by_name[name] for name in wanted if name in by_name]
    items[:] = [item for item in items if "browser" not in getattr(item, "fixturenames", ())]


def _reached() -> list[int]:
    """Return the numbers that have been noted since, and forget them."""
    notes = sorted(Path(os.environ["MUTATION_NOTES"]).iterdir())
    for note in notes:
        note.unlink()
    return [int(note.name) for note in notes]
