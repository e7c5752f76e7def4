"""The book's algorithms by themselves: batches of any shape are what their rows are."""

from collections.abc import Callable

import numpy as np
import pytest
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.center_of_mass import center_of_mass, center_of_mass_jacobian
from kindsl.mechanics.dynamics.energy import kinetic_energy, potential_energy
from kindsl.mechanics.dynamics.forward_dynamics import forward_dynamics
from kindsl.mechanics.dynamics.forward_dynamics_derivatives import forward_dynamics_derivatives
from kindsl.mechanics.dynamics.forward_kinematics import body_poses, frame_poses, joint_poses
from kindsl.mechanics.dynamics.inverse_dynamics import floating_base_inverse_dynamics, newton_euler
from kindsl.mechanics.dynamics.inverse_dynamics_derivatives import inverse_dynamics_derivatives
from kindsl.mechanics.dynamics.jacobian import jacobian
from kindsl.mechanics.dynamics.joint_space_inertia import joint_space_inertia
from kindsl.mechanics.dynamics.posture import posture
from kindsl.mechanics.dynamics.regressor import regressor
from kindsl.mechanics.spatial.arrays import Array

FIXED, FLOATING = (
    random_bodies(np.random.default_rng(seed), 4, is_floating)
    for seed, is_floating in ((3, False), (8, True))
)
# Arguments by name: q, qd, x (accelerations or forces), v and a of the base, g.
Algorithm = Callable[[Bodies, dict[str, Array]], object]
ALGORITHMS: dict[str, Algorithm] = {
    "body poses": lambda b, s: body_poses(b, s["q"]),
    "frame poses": lambda b, s: frame_poses(b, body_poses(b, s["q"])),
    "joint poses": lambda b, s: joint_poses(b, body_poses(b, s["q"])),
    "jacobian": lambda b, s: _jacobian(b, body_poses(b, s["q"])),
    "inertia": lambda b, s: joint_space_inertia(b, s["q"]),
    "Newton-Euler": lambda b, s: newton_euler(posture(b, s["q"]), s["qd"], s["x"], s["v"], s["a"]),
    "floating inverse": lambda b, s: floating_base_inverse_dynamics(
        posture(b, s["q"]), s["qd"], s["x"], s["v"], s["g"]
    ),
    "forward": lambda b, s: forward_dynamics(posture(b, s["q"]), s["qd"], s["x"], s["v"], s["g"]),
    "kinetic energy": lambda b, s: kinetic_energy(b, s["q"], s["qd"], s["v"]),
    "potential energy": lambda b, s: potential_energy(b, body_poses(b, s["q"]), s["g"]),
    "CoM": lambda b, s: center_of_mass(b, body_poses(b, s["q"])),
    "CoM jacobian": lambda b, s: center_of_mass_jacobian(b, body_poses(b, s["q"])),
    "inverse derivatives": lambda b, s: inverse_dynamics_derivatives(
        posture(b, s["q"]), s["qd"], s["x"], s["v"], s["a"], s["g"]
    ),
    "forward derivatives": lambda b, s: forward_dynamics_derivatives(
        b, s["q"], s["qd"], s["x"], s["v"], s["g"]
    ),
    "regressor": lambda b, s: regressor(b, s["q"], s["qd"], s["x"], s["v"], s["a"]),
}


def _jacobian(bodies: Bodies, poses: Array) -> Array:
    frame = bodies.frames[0]
    return jacobian(bodies, poses, frame.body, frame_poses(bodies, poses)[..., 0, :, :])


def _state(bodies: Bodies, shape: tuple[int, ...]) -> dict[str, Array]:
    generator = np.random.default_rng(6)
    lengths = {"q": 4, "qd": 4, "x": 4, "v": 6, "a": 6, "g": 3}
    drawn = {name: generator.uniform(-2.0, 2.0, (*shape, n)) for name, n in lengths.items()}
    return drawn | {name: drawn[name] * bodies.is_floating for name in "va"}


def _parts(answer: object) -> list[Array]:
    return list(answer) if isinstance(answer, tuple | list) else [answer]  # type: ignore[list-item]


@pytest.mark.parametrize(
    ("name", "bodies"),
    [
        *((name, FIXED) for name in ALGORITHMS if name != "floating inverse"),
        *((name, FLOATING) for name in ALGORITHMS),
    ],
)
def test_a_batch_is_its_rows(name: str, bodies: Bodies) -> None:
    """As the docstrings promise: `...` may be no, one or two dimensions, and no rows at all."""
    algorithm = ALGORITHMS[name]
    state = _state(bodies, (2, 3))
    whole = _parts(algorithm(bodies, state))
    for at in np.ndindex(2, 3):
        alone = _parts(algorithm(bodies, {key: values[at] for key, values in state.items()}))
        for part, row in zip(whole, alone, strict=True):
            entries = np.broadcast_to(part, (2, 3, *part.shape[-row.ndim or part.ndim :]))[at]
            np.testing.assert_allclose(entries, row, rtol=1e-12, atol=1e-12)
    for shape in ((6,), (0,)):
        flat = {key: values.reshape((6, -1))[: shape[0]] for key, values in state.items()}
        for part, rows in zip(whole, _parts(algorithm(bodies, flat)), strict=True):
            wanted = part.reshape((6, *part.shape[2:]))[: shape[0]]
            np.testing.assert_allclose(rows, wanted, rtol=1e-12, atol=1e-12)
