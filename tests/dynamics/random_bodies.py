"""Random trees of physically consistent bodies."""

from dataclasses import replace

import numpy as np
from tests.support.spatial import rotation_from_intrinsic_xyz

from kindsl.mechanics.dynamics.bodies import Bodies, BodyFrame, Drives
from kindsl.mechanics.rigid.joint_kind import JointKind
from kindsl.mechanics.spatial.arrays import Array

QUARTER_TURNS = (-np.pi / 2, 0.0, np.pi / 2, np.pi)


def random_bodies(
    generator: np.random.Generator, n_links: int, is_floating: bool, frames_per_link: float = 0.3
) -> Bodies:
    """Return a tree in which half of the joint frames are turned by right angles, as usual."""
    names = tuple(f"link{i}" for i in range(1, n_links + 1))
    kinds: list[JointKind] = ["revolute", "revolute", "prismatic"]
    inertias = [random_inertia(generator) for _ in range(n_links + 1)]
    return Bodies(
        base_name="base",
        link_names=names,
        joint_names=tuple(f"joint{i}" for i in range(1, n_links + 1)),
        joint_kinds=tuple(kinds[k] for k in generator.integers(3, size=n_links)),
        parents=tuple(_parent(generator, i) for i in range(1, n_links + 1)),
        p_R_j=np.array([random_rotation(generator) for _ in names]),
        p_r_j=generator.uniform(-0.5, 0.5, (n_links, 3)),
        masses=np.array([mass for mass, _, _ in inertias]),
        coms=np.array([com for _, com, _ in inertias]),
        inertias=np.array([inertia for _, _, inertia in inertias]),
        is_floating=is_floating,
        frames=tuple(
            BodyFrame(
                f"frame{k}",
                int(generator.integers(n_links + 1)),
                random_rotation(generator),
                generator.uniform(-1.0, 1.0, 3),
            )
            for k in range(int(frames_per_link * n_links) + 1)
        ),
    )


def tree_of_seed(seed: int) -> tuple[Bodies, np.random.Generator]:
    """Return a tree of 1 to 40 links, with a floating base for odd seeds, and its generator."""
    generator = np.random.default_rng(seed)
    n_links = int(generator.choice([*range(1, 9)] * 4 + [*range(1, 41)]))
    return random_bodies(generator, n_links, is_floating=bool(seed % 2)), generator


def with_drives(bodies: Bodies, generator: np.random.Generator) -> Bodies:
    """Return bodies with rotors and friction in some joints."""
    amounts = generator.uniform(0.01, 1.0, (3, bodies.n_links))
    known = generator.random((3, bodies.n_links)) < 0.7
    return replace(bodies, drives=Drives(*(amounts * known)))


def random_rotation(generator: np.random.Generator) -> Array:
    """Return a rotation, by right angles or by any."""
    if generator.random() < 0.5:
        return rotation_from_intrinsic_xyz(generator.choice(QUARTER_TURNS, 3))
    return rotation_from_intrinsic_xyz(generator.uniform(-np.pi, np.pi, 3))


def random_inertia(generator: np.random.Generator) -> tuple[float, Array, Array]:
    """Return mass, centre of mass and inertia about the origin of a cloud of masses."""
    masses = generator.uniform(0.1, 2.0, 6)
    points = generator.uniform(-0.2, 0.2, (6, 3)) + generator.uniform(-0.2, 0.2, 3)
    second = (points.T * masses) @ points
    inertia = np.trace(second) * np.eye(3) - second
    return float(masses.sum()), masses @ points / masses.sum(), inertia


def _parent(generator: np.random.Generator, link: int) -> int:
    """Return mostly the link before, so that trees are deep."""
    return link - 1 if generator.random() < 0.6 else int(generator.integers(link))
