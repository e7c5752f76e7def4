"""The mechanisms that benchmarks measure: an arm, a quadruped, a long chain, a pendulum."""

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.rigid.pose import Vector3, pose_from
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.inertia import point_inertia

RIGHT = np.pi / 2


def pendulum() -> Bodies:
    """Return one revolute joint on a fixed base."""
    return _bodies(range(1), [(RIGHT, 0.0, 0.0)], [(0.0, 0.0, 0.3)], is_floating=False)


def arm() -> Bodies:
    """Return seven revolute joints whose axes are normal to one another, on a fixed base."""
    angles = [(0.0, 0.0, 0.0), *((RIGHT if i % 2 else -RIGHT, 0.0, 0.0) for i in range(6))]
    offsets = [(0.0, 0.0, 0.3), *((0.0, 0.2 * (i % 2), 0.2 * ((i + 1) % 2)) for i in range(6))]
    return _bodies(range(7), angles, offsets, is_floating=False)


def quadruped() -> Bodies:
    """Return a floating trunk with four legs of three joints: abduction, hip, knee."""
    parents: list[int] = []
    angles: list[Vector3] = []
    offsets: list[tuple[float, ...]] = []
    for leg, (front, left) in enumerate(((1, 1), (1, -1), (-1, 1), (-1, -1))):
        parents += [0, 3 * leg + 1, 3 * leg + 2]
        angles += [(0.0, RIGHT, np.pi * (left < 0)), (RIGHT * left, 0.0, 0.0), (0.0, 0.0, 0.0)]
        offsets += [(0.37 * front, 0.21 * left, 0.0), (0.08, 0.0, 0.0), (0.35, 0.0, 0.0)]
    return _bodies(parents, angles, offsets, is_floating=True)


def chain(n_links: int = 100) -> Bodies:
    """Return a chain of revolute joints at right angles of all sorts, on a fixed base."""
    generator = np.random.default_rng(3)
    choices = ((0.0, 0.0, 0.0), (RIGHT, 0.0, 0.0), (-RIGHT, 0.0, 0.0), (0.0, RIGHT, 0.0))
    angles = [choices[k] for k in generator.integers(len(choices), size=n_links)]
    offsets = generator.uniform(-0.2, 0.2, (n_links, 3)) * (1.0, 0.0, 1.0)
    return _bodies(range(n_links), angles, offsets.tolist(), is_floating=False)


def _bodies(
    parents: range | list[int],
    angles: list[Vector3],
    offsets: list[tuple[float, ...]],
    is_floating: bool,
) -> Bodies:
    n_links = len(parents)
    masses, coms, inertias = _symmetric_bodies(n_links + 1)
    return Bodies(
        base_name="base",
        link_names=tuple(f"link{i}" for i in range(1, n_links + 1)),
        joint_names=tuple(f"joint{i}" for i in range(1, n_links + 1)),
        joint_kinds=("revolute",) * n_links,
        parents=tuple(parents),
        p_R_j=np.array([pose_from((0.0, 0.0, 0.0), turns).rotation for turns in angles]),
        p_r_j=np.array(offsets),
        masses=masses,
        coms=coms,
        inertias=inertias,
        is_floating=is_floating,
    )


def _symmetric_bodies(count: int) -> tuple[Array, Array, Array]:
    """Return bodies with a plane of symmetry, as most links have: y = 0, one product of inertia."""
    generator = np.random.default_rng(1)
    masses = generator.uniform(0.5, 5.0, count)
    coms = generator.uniform(-0.15, 0.15, (count, 3)) * (1.0, 0.0, 1.0)
    about_com = (
        masses[:, None, None] * 0.01 * np.eye(3) * generator.uniform(1.0, 1.5, (count, 1, 3))
    )
    about_com[:, 0, 2] = about_com[:, 2, 0] = 0.001 * masses
    return masses, coms, about_com + point_inertia(masses, coms)
