"""Where nothing resists a motion, the joint is named; where numbers are too large, they are."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.evaluation.singular import singular_inertia
from kindsl.mechanics.dynamics.quantities import SingularInertiaError
from kindsl.mechanics.rigid.joint_kind import JointKind
from kindsl.mechanics.spatial.arrays import Array

METHODS = ("inverse_dynamics", "forward_dynamics", "forward_dynamics_derivatives")


def chain(
    kinds: Sequence[JointKind],
    coms: Sequence[float],
    masses: Sequence[float],
    offsets: Sequence[float] = (0.0, 1.0),
    is_floating: bool = False,
) -> Bodies:
    """Return point masses along the links' x axes; joints are parallel to z, base first."""
    n = len(kinds)
    at = np.zeros((n + 1, 3))
    at[:, 0] = coms
    return Bodies(
        base_name="base",
        link_names=tuple(f"l{i}" for i in range(1, n + 1)),
        joint_names=tuple(f"j{i}" for i in range(1, n + 1)),
        joint_kinds=tuple(kinds),
        parents=tuple(range(n)),
        p_R_j=np.array([np.eye(3)] * n),
        p_r_j=np.array([[x, 0.0, 0.0] for x in offsets]),
        masses=np.array(masses),
        coms=at,
        inertias=np.array(
            [m * (c @ c * np.eye(3) - np.outer(c, c)) for m, c in zip(masses, at, strict=True)]
        ),
        is_floating=is_floating,
    )


TURNS: tuple[JointKind, ...] = ("revolute", "revolute")
SLIDES: tuple[JointKind, ...] = ("prismatic", "prismatic")


@pytest.mark.parametrize(
    ("bodies", "moving"),
    [
        (chain(TURNS, (0.0, 1.0, 0.0), (0.0, 1.0, 0.0)), "joint 'j2'"),
        (chain(TURNS, (0.0, 0.0, 0.0), (0.0, 1.0, 1e-13), (0.0, 0.0)), "joint 'j2'"),
        # The links' inertia is there; none of it is the outer joint's, on whose axis all lies.
        (chain(TURNS, (0.0, 0.5, 0.0), (0.0, 1.0, 1.0)), "joint 'j2'"),
        # Of several the outermost: it is what its links lack.
        (chain(TURNS, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)), "joint 'j2'"),
        (chain(TURNS, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), is_floating=True), "joint 'j2'"),
        (chain(SLIDES, (0.0, 0.0, 0.0), (0.0, 1.0, 1.0), (0.0, 0.0), True), "the base"),
        # Stretched or folded, one point mass has two turns that move it alike.
        (chain(TURNS, (0.0, 0.0, 0.5), (0.0, 0.0, 1.0)), "joint 'j2'"),
        (chain(TURNS, (0.0, 0.0, -2.0), (0.0, 0.0, 1.0)), "joint 'j1'"),
        (chain(SLIDES, (0.0, 0.0, 0.5), (0.0, 0.0, 1.0)), "joint 'j[12]'"),
    ],
)
def test_what_moves_without_inertia_is_named(bodies: Bodies, moving: str) -> None:
    for q in (np.zeros(2), np.zeros((3, 2))):
        error = singular_inertia(bodies, q)
        with pytest.raises(SingularInertiaError, match=f"nothing resists motion of {moving}: "):
            raise error


def test_a_light_link_is_no_link_without_inertia() -> None:
    """Two joints on one axis move the last links alike; the last joint moves but a gram."""
    turns: tuple[JointKind, ...] = ("revolute",) * 3
    bodies = chain(turns, (0.0, 0.0, 1.0, 0.1), (0.0, 0.0, 1.0, 1e-3), (0.0, 0.0, 1.0))
    assert singular_inertia(bodies, np.full(3, 0.3)).moving in ("joint 'j1'", "joint 'j2'")


def test_the_configuration_that_is_singular_tells_the_joint() -> None:
    bent, folded = (0.3, 1.2), (0.7, 0.0)
    bodies = chain(TURNS, (0.0, 0.0, -2.0), (0.0, 0.0, 1.0))
    for q in ([bent, folded], [folded, bent], [[bent, bent], [bent, folded]]):
        assert singular_inertia(bodies, np.array(q)).moving == "joint 'j1'"


@pytest.mark.parametrize("q", [np.zeros((0, 2)), np.full((2, 2), np.inf)])
def test_without_a_matrix_none_is_named(q: Array) -> None:
    error = singular_inertia(chain(TURNS, (0.0, 1.0, 0.0), (0.0, 1.0, 0.0)), q)
    assert error.moving == ""
    assert str(error) == "the acceleration is not defined: the inertia matrix is singular"


@pytest.mark.parametrize("is_floating", [False, True])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("shape", [(), (3,), (2, 30)])
def test_large_numbers_are_no_lack_of_inertia(
    method: str, is_floating: bool, shape: tuple[int, ...]
) -> None:
    """A joint that nothing resists would be looked for in vain."""
    bodies = random_bodies(np.random.default_rng(1), 4, is_floating)
    assert "prismatic" in bodies.joint_kinds
    zero, large = np.zeros((*shape, 4)), np.full((*shape, 4), 1e200)
    last = "qdd" if method == "inverse_dynamics" else "tau"
    for q, qd in ((zero, large), (large, large)):
        with pytest.raises(ValueError, match=f"^'q', 'qd', '{last}': the values are too large$"):
            getattr(Mechanics(bodies), method)(q, qd, zero)


@pytest.mark.parametrize("is_floating", [False, True])
@pytest.mark.parametrize("shape", [(), (3,), (60,)])
def test_one_singular_row_of_a_batch_is_an_error(is_floating: bool, shape: tuple[int, ...]) -> None:
    bodies = chain(TURNS, (0.1, 0.5, 0.0), (1.0, 1.0, 0.0), is_floating=is_floating)
    q = np.zeros((*shape, 2))
    for method in METHODS[1:]:
        with pytest.raises(SingularInertiaError, match="motion of joint 'j2'"):
            getattr(Mechanics(bodies), method)(q, q, q)


@pytest.mark.parametrize("is_floating", [False, True])
@pytest.mark.parametrize("generates_code", [True, False])
@pytest.mark.parametrize("shape", [(), (3,), (60,)])
def test_mass_on_the_last_axis_is_no_inertia_anywhere(
    is_floating: bool, generates_code: bool, shape: tuple[int, ...]
) -> None:
    """About the base, far from that axis, rounding leaves an inertia of 1e-16."""
    generator = np.random.default_rng(3)
    whole = random_bodies(generator, 6, is_floating)
    masses, coms, inertias = whole.masses.copy(), whole.coms.copy(), whole.inertias.copy()
    masses[6], coms[6], inertias[6] = 1.3, (0.0, 0.0, 0.37), 0.18 * np.diag((1.0, 1.0, 0.0))
    bodies = replace(
        whole, masses=masses, coms=coms, inertias=inertias,
        joint_kinds=("revolute",) * 6, parents=tuple(range(6)),
    )  # fmt: skip
    mechanics = Mechanics(bodies, generates_code=generates_code)
    q, qd, tau = generator.uniform(-1.0, 1.0, (3, *shape, 6))
    with pytest.raises(SingularInertiaError, match="motion of joint 'joint6'"):
        mechanics.forward_dynamics(q, qd, tau)
    with pytest.raises(SingularInertiaError, match="motion of joint 'joint6'"):
        mechanics.forward_dynamics_derivatives(q, qd, tau)
    with pytest.raises(SingularInertiaError, match="motion of joint 'joint6'"):
        mechanics.joint_space_inertia_inverse(q)
