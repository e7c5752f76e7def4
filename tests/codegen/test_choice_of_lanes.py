"""Batches are computed in lanes where that saves time."""

import pytest
from tests.codegen.robots import bodies_of_seed, library

from kindsl.mechanics.dynamics.generation.function import Function, Result, argument
from kindsl.products.codegen.c_sources import _is_wide

MADE = library(bodies_of_seed(2), ("poses",))


def function(entries: int, name: str = "poses", takes: str = "q") -> Function:
    """Return a function of so many numbers."""
    results = (Result("x", (entries,), [0.0] * entries),)
    given = (argument(takes, MADE.inputs.q),)
    return Function(name, "numbers", given, results, loaded=results)


@pytest.mark.parametrize(
    ("operations", "entries", "is_wide"),
    [
        (99, 1, False), (100, 1, True),
        (149, 100, False), (150, 100, True), (150, 101, False),
        (10_000, 1, True), (10_001, 1, False),
        (9_999, 4096, True), (9_999, 4097, False),
    ],
)  # fmt: skip
def test_neither_little_nor_very_much_is_in_lanes(
    operations: int, entries: int, is_wide: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = "kindsl.mechanics.dynamics.generation.emitters.lanes.operations"
    monkeypatch.setattr(place, lambda *_: operations)
    assert _is_wide(MADE, function(entries)) is is_wide
    assert not _is_wide(MADE, function(entries, "jacobian_tip"))
    assert not _is_wide(MADE, function(entries, takes="qd"))
    assert not _is_wide(library(bodies_of_seed(2), ("poses",), real="float"), function(entries))
