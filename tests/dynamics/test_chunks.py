"""Large batches are done a part at a time, and the borders do not show."""

import numpy as np
import pytest

from kindsl.mechanics.dynamics.evaluation.chunks import BODIES_AT_A_TIME, evaluate_in_chunks
from kindsl.mechanics.dynamics.evaluation.request import Request
from kindsl.mechanics.dynamics.generation.emitters.numpy_rows import BatchFunction, run_in_chunks
from kindsl.mechanics.spatial.arrays import Array


def _request(shape: tuple[int, ...]) -> Request:
    """Joint vectors of two components that differ everywhere, a base velocity and gravity."""
    q = np.arange(2.0 * np.prod(shape)).reshape((*shape, 2))
    qd = -np.arange(2.0 * shape[-1]).reshape((shape[-1], 2)) if shape else -np.ones(2)
    return Request("bias_torque", shape, (q, qd), np.arange(6.0), np.array([7.0, 8.0, 9.0]))


def _told(request: Request) -> Array:
    """Return one row per configuration that says all that it was given."""
    return np.concatenate((*request.joint_vectors, request.base_velocity, request.gravity), axis=-1)


@pytest.mark.parametrize("chunk", [1, 2, 3, 5, 6, 7, 100])
@pytest.mark.parametrize("shape", [(), (0,), (1,), (6,), (2, 3), (7,), (3, 0)])
def test_no_part_is_larger_than_it_may_be(shape: tuple[int, ...], chunk: int) -> None:
    sizes = []

    def evaluate(part: Request) -> Array:
        assert part.quantity == "bias_torque"
        rows = {len(vector) for vector in (*part.joint_vectors, part.base_velocity, part.gravity)}
        assert rows == {*part.batch_shape}
        sizes.extend(rows)
        return _told(part)

    request = _request(shape)
    found = evaluate_in_chunks(evaluate, BODIES_AT_A_TIME // chunk, request)
    size = int(np.prod(shape))
    # A batch without rows is asked once: only the answer says how long rows are.
    assert sizes == [chunk] * (size // chunk) + [size % chunk] * bool(size % chunk or not size)
    full = [
        np.broadcast_to(v, (*shape, v.shape[-1])) for v in (*request.joint_vectors, *request[3:])
    ]
    np.testing.assert_array_equal(found, np.concatenate(full, axis=-1))


def test_the_longest_chains_are_done_one_by_one() -> None:
    sizes = []

    def evaluate(part: Request) -> Array:
        sizes.append(*part.batch_shape)
        return _told(part)

    evaluate_in_chunks(evaluate, BODIES_AT_A_TIME + 1, _request((3,)))
    assert sizes == [1, 1, 1]


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
    function = BatchFunction(evaluate, 2, 4, np.array([2]), np.array([[5.0]]))
    found = run_in_chunks(function, [q, [3.0]], size, chunk)
    assert len(widths) == -(-size // chunk)
    assert max(widths, default=0) <= chunk and sum(widths) == size
    assert widths[:-1] == widths[:1] * (len(widths) - 1) and widths[-1:] <= widths[:1]
    expected = [q[:, 1] * 3.0, np.cos(q[:, 0]), np.full(size, 5.0), np.sin(q[:, 1])]
    np.testing.assert_allclose(found, expected, atol=1e-15)
