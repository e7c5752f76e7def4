"""A short stretch of the long session of `benchmarks/soak.py`."""

import pytest
from benchmarks.soak import soak
from tests.support.amount import usually


@pytest.mark.parametrize("seed", usually([7], thoroughly=[7, 11]))
def test_a_random_session_leaves_nothing_behind(seed: int) -> None:
    assert soak(edits=usually(80, thoroughly=250), documents=4, seed=seed, checks=2) == []
