"""For pytest: notes which tests reach which changes, or runs the tests of a list in its order.

With `MUTATION_REACHED` a JSON file is written there: for each test the numbers it reached and its
seconds; under no name the numbers that importing the tests reached. With `MUTATION_TESTS` that
file's tests are run, one a line, and no others.
"""

import json
import os
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

_found: dict[str, tuple[list[int], float]] = {}


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    if "MUTATION_REACHED" not in os.environ:
        return (yield)
    from kindsl import _reached

    _reached.numbers.clear()
    start = time.perf_counter()
    result = yield
    _found[item.nodeid] = sorted(_reached.numbers), time.perf_counter() - start
    return result


def pytest_collection_finish() -> None:
    if "MUTATION_REACHED" in os.environ:
        from kindsl import _reached

        _found[""] = sorted(_reached.numbers), 0.0


def pytest_sessionfinish() -> None:
    if "MUTATION_REACHED" in os.environ:
        Path(os.environ["MUTATION_REACHED"]).write_text(json.dumps(_found), encoding="utf-8")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    if "MUTATION_TESTS" in os.environ:
        wanted = Path(os.environ["MUTATION_TESTS"]).read_text(encoding="utf-8").splitlines()
        by_name = {item.nodeid: item for item in items}
        items[:] = [by_name[name] for name in wanted if name in by_name]
