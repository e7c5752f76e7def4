"""For pytest: notes which tests reach which changes, or runs the tests of a list in its order.

With `MUTATION_REACHED` a JSON file is written there: for each test the numbers that it reached, or
that were reached with a fixture which it shares, and its seconds; under no name the numbers that
importing the tests reached. Numbers are names of files in `MUTATION_NOTES`. A test that fails is
left out. With `MUTATION_TESTS` that file's tests are run, one a line, and no others. What drives a
browser is too slow for either.
"""

import json
import os
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

_found: dict[str, tuple[list[int], float]] = {}
# What tests reached that had a fixture first which others share, by the fixture.
_by_fixture: dict[tuple[str, object], set[int]] = {}
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
    own = set(_reached())
    reached = own.union(*(_by_fixture.setdefault(key, own) for key in _shared_fixtures(item)))
    _found[item.nodeid] = sorted(reached), time.perf_counter() - start
    return result


def _shared_fixtures(item: pytest.Item) -> Iterator[tuple[str, object]]:
    """Yield the fixtures of ours that are set up once for several tests, with their parameters."""
    known = getattr(item, "_fixtureinfo", None)
    for name, definitions in known.name2fixturedefs.items() if known else ():
        function = definitions[-1].func
        if definitions[-1].scope != "function" and function.__module__.startswith("tests."):
            place = getattr(item, "callspec", None)
            yield f"{function.__module__}.{name}", place.indices.get(name) if place else None


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
