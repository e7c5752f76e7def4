"""Large batches are done a part at a time, and the borders do not show."""

import numpy as np
import pytest
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.evaluation import book
from kindsl.mechanics.dynamics.evaluation.book import Request
from kindsl.mechanics.dynamics.generation.emitters.numpy_rows import BatchFunction, run_in_chunks
from kindsl.mechanics.dynamics.posture import Posture
from kindsl.mechanics.spatial.arrays import Array


@pytest.mark.parametrize("chunk", [1, 2, 3, 5, 6, 7, 100])
@pytest.mark.parametrize("shape", [(), (0,), (1,), (6,), (2, 3), (7,), (3, 0)])
def test_the_book_does_no_part_larger_than_it_may_be(
    shape: tuple[int, ...], chunk: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    bodies = random_bodies(np.random.default_rng(1), 2, is_floating=True)
    generator = np.random.default_rng(2)
    q, qd = generator.uniform(-1.0, 1.0, (*shape, 2)), generator.uniform(-1.0, 1.0, 2)
    vectors = {"q": q, "qd": qd, "v0": np.arange(6.0), "g": np.array([7.0, 8.0, 9.0])}
    request = Request("bias_torque", shape, vectors)
    whole, sizes, bias = book.evaluate(bodies, request), [], book.newton_euler

    def counted(state: Posture, *others: Array) -> Array:
        sizes.append(len(state.poses))
        return bias(state, *others)

    monkeypatch.setattr(book, "newton_euler", counted)
    monkeypatch.setattr(book, "BODIES_AT_A_TIME", chunk * bodies.n_links)
    np.testing.assert_allclose(book.evaluate(bodies, request), whole, rtol=1e-12)
    size = int(np.prod(shape))
    # A batch without rows is computed once: only the result says how long rows are.
    assert sizes == [chunk] * (size // chunk) + [size % chunk] * bool(size % chunk or not size)
    assert whole.shape == (*shape, 8)


@pytest.mark.parametrize("chunk", [1, 3, 10])
@pytest.mark.parametrize("size", [0, 1, 2, 3, 9, 10, 11, 21])
def test_code_gets_parts_of_nearly_one_size(size: int, chunk: int) -> None:
    """As few as the greatest size allows, each with scratch rows as long as the part."""
    widths: list[int] = []

    def evaluate(
        q: Array, fixed: list[float], cosines: Array, sines: Array, out: Array, scratch: Array
    ) -> None:
        widths.append(q.shape[1])
        assert out.shape == (4, widths[-1]) and scratch.shape == (2, widths[-1])
        out[0], out[1], out[3] = q[1] * fixed[0], cosines[0], sines[1]

    q = np.random.default_rng(1).uniform(-3.0, 3.0, (size, 2))
    function = BatchFunction(evaluate, 2, 4, {2: 5.0})
    found = run_in_chunks(function, [q, [3.0]], size, chunk)
    assert len(widths) == -(-size // chunk)
    assert max(widths, default=0) <= chunk and sum(widths) == size
    assert widths[:-1] == widths[:1] * (len(widths) - 1) and widths[-1:] <= widths[:1]
    expected = [q[:, 1] * 3.0, np.cos(q[:, 0]), np.full(size, 5.0), np.sin(q[:, 1])]
    np.testing.assert_allclose(found, expected, atol=1e-15)
