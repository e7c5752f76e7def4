"""Random robots: trees of up to a dozen bodies that could exist, both joint kinds, with frames."""

import numpy as np

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose, pose_from
from kindsl.mechanics.spatial.inertia import point_inertia
from kindsl.robots.mechanism.linkage import BodyPart, Linkage, RigidBody


def random_robot(seed: int) -> Linkage:
    chance = np.random.default_rng(seed)
    n_links = int(chance.integers(1, 12))
    bodies = [_made(chance, i) for i in range(n_links + 1)]
    return Linkage(tuple(bodies), bool(chance.integers(2)), f"robot_{seed}")


def _made(chance: np.random.Generator, index: int) -> RigidBody:
    frames = [
        BodyPart(f"frame_{index}_{k}", _pose(chance), is_link=False)
        for k in range(chance.integers(3))
    ]
    parent = int(chance.integers(index)) if index else None
    kind = str(chance.choice(["revolute", "prismatic"]))
    link = BodyPart(f"link_{index}", mass=_body(chance))
    return RigidBody(
        (link, *frames), parent, f"joint_{index}" if index else "", kind, _pose(chance)
    )


def _pose(chance: np.random.Generator) -> RigidPose:
    angles = chance.choice([0.0, np.pi / 2, -np.pi / 2, np.pi], 3)
    if chance.integers(2):
        angles = chance.uniform(-np.pi, np.pi, 3)
    return pose_from(tuple(chance.uniform(-1, 1, 3).tolist()), tuple(angles.tolist()))


def _body(chance: np.random.Generator) -> MassDistribution:
    """A cloud of point masses, which is a body for certain."""
    points = chance.uniform(-0.5, 0.5, (6, 3))
    masses = chance.uniform(0.1, 2.0, 6)
    (Ix, Ixy, Ixz), (_, Iy, Iyz), (_, _, Iz) = np.sum(point_inertia(masses, points), axis=0)
    moments = tuple(map(float, (Ix, Iy, Iz, -Ixy, -Ixz, -Iyz)))
    com = tuple((masses @ points / masses.sum()).tolist())
    return MassDistribution(float(masses.sum()), com, moments)
