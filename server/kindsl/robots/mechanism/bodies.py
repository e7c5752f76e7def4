"""From a linkage to the arrays that the dynamics work on, and back."""

from collections.abc import Mapping, Sequence

import numpy as np

from kindsl.language.semantics.parameters import UNTOLD, JointProperties
from kindsl.mechanics.dynamics.bodies import Bodies, BodyFrame, Drives
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose, Vector3
from kindsl.mechanics.spatial.arrays import Array
from kindsl.robots.mechanism.linkage import BodyPart, Linkage, RigidBody


def bodies_of(linkage: Linkage) -> Bodies:
    """Return the bodies of a robot as arrays, numbered like it."""
    return Bodies(
        base_name=linkage.base_name,
        link_names=linkage.link_names,
        joint_names=linkage.joint_names,
        joint_kinds=linkage.joint_kinds,
        parents=linkage.parents,
        p_R_j=np.array([pose.rotation for pose in linkage.placements]),
        p_r_j=np.array([pose.translation for pose in linkage.placements]),
        masses=np.array([body.mass for body in linkage.masses]),
        coms=np.array([body.com for body in linkage.masses]),
        inertias=np.array([_tensor(body) for body in linkage.masses]),
        is_floating=linkage.is_floating,
        frames=tuple(BodyFrame(f.name, f.body, *_arrays(f.pose)) for f in linkage.frames),
    )


def drives_of(names: Sequence[str], joints: Mapping[str, JointProperties]) -> Drives | None:
    """Return rotors and friction of the joints, None if none has any.

    Args:
        names: The joints, in the order of the bodies.
        joints: What is told, by their names.
    """
    told = [joints.get(name, UNTOLD) for name in names]
    drives = Drives(
        np.array([joint.armature or 0.0 for joint in told]),
        np.array([joint.damping or 0.0 for joint in told]),
        np.array([joint.friction or 0.0 for joint in told]),
    )
    is_told = drives.armature.any() or drives.damping.any() or drives.friction.any()
    return drives if is_told else None


def linkage_of_bodies(bodies: Bodies) -> Linkage:
    """Return the bodies of arrays in plain numbers, numbered like them."""
    poses = map(_pose, bodies.p_R_j, bodies.p_r_j)
    masses = map(_mass_distribution, bodies.masses, bodies.coms, bodies.inertias)
    parts = [
        [BodyPart(name, mass=mass)] for name, mass in zip(bodies.body_names, masses, strict=True)
    ]
    for f in bodies.frames:
        pose = _pose(f.body_R_frame, f.body_r_frame)
        parts[f.body].append(BodyPart(f.name, pose, is_link=False))
    base, *others = map(tuple, parts)
    joints = bodies.parents, bodies.joint_names, bodies.joint_kinds, poses
    return Linkage((RigidBody(base), *map(RigidBody, others, *joints)), bodies.is_floating)


def _pose(R: Array, r: Array) -> RigidPose:
    x, y, z = (_triple(row) for row in R)
    return RigidPose((x, y, z), _triple(r))


def _mass_distribution(mass: float, com: Array, tensor: Array) -> MassDistribution:
    (Ix, Ixy, Ixz), (_, Iy, Iyz), (_, _, Iz) = tensor.tolist()
    return MassDistribution(float(mass), _triple(com), (Ix, Iy, Iz, -Ixy, -Ixz, -Iyz))


def _triple(values: Array) -> Vector3:
    x, y, z = values.tolist()
    return x, y, z


def _arrays(pose: RigidPose) -> tuple[Array, Array]:
    return np.array(pose.rotation), np.array(pose.translation)


def _tensor(body: MassDistribution) -> tuple[tuple[float, ...], ...]:
    """Return the inertia tensor, products with their minus signs."""
    Ix, Iy, Iz, Ixy, Ixz, Iyz = body.moments
    return (Ix, -Ixy, -Ixz), (-Ixy, Iy, -Iyz), (-Ixz, -Iyz, Iz)
