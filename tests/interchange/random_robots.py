"""Random robots: trees of up to a dozen bodies that could exist, both joint kinds, with frames."""

import numpy as np

from kindsl.interchange.robot_description import (
    DescribedFrame,
    DescribedLink,
    MassProperties,
    RobotDescription,
)
from kindsl.spatial.arrays import Array
from kindsl.spatial.inertia import point_inertia
from kindsl.spatial.transforms import homogeneous, rotation_from_intrinsic_xyz


def random_robot(seed: int) -> RobotDescription:
    chance = np.random.default_rng(seed)
    n_links = int(chance.integers(1, 12))
    links = [_link(chance, i) for i in range(n_links + 1)]
    return RobotDescription(f"robot_{seed}", bool(chance.integers(2)), tuple(links))


def _link(chance: np.random.Generator, index: int) -> DescribedLink:
    frames = tuple(
        DescribedFrame(f"frame_{index}_{k}", _pose(chance)) for k in range(chance.integers(3))
    )
    parent = int(chance.integers(index)) if index else None
    kind = str(chance.choice(["revolute", "prismatic"]))
    return DescribedLink(
        f"link_{index}", _body(chance), frames, parent, f"joint_{index}", kind, _pose(chance)
    )


def _pose(chance: np.random.Generator) -> Array:
    angles = chance.choice([0.0, np.pi / 2, -np.pi / 2, np.pi], 3)
    if chance.integers(2):
        angles = chance.uniform(-np.pi, np.pi, 3)
    return homogeneous(rotation_from_intrinsic_xyz(angles), chance.uniform(-1, 1, 3))


def _body(chance: np.random.Generator) -> MassProperties:
    """A cloud of point masses, which is a body for certain."""
    points = chance.uniform(-0.5, 0.5, (6, 3))
    masses = chance.uniform(0.1, 2.0, 6)
    inertia = np.sum(point_inertia(masses, points), axis=0)
    return MassProperties(float(masses.sum()), masses @ points / masses.sum(), inertia)
