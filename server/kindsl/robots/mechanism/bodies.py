"""From a skeleton to the arrays that the dynamics work on."""

from collections.abc import Mapping, Sequence

import numpy as np

from kindsl.language.semantics.parameters import UNTOLD, JointProperties
from kindsl.mechanics.dynamics.bodies import Bodies, BodyFrame, Drives
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose, Vector3
from kindsl.mechanics.spatial.arrays import Array
from kindsl.robots.mechanism.skeleton import AttachedFrame, Skeleton


def bodies_of(skeleton: Skeleton) -> Bodies:
    """Return the bodies of a skeleton, numbered like it."""
    return Bodies(
        base_name=skeleton.base_name,
        link_names=skeleton.link_names,
        joint_names=skeleton.joint_names,
        joint_kinds=skeleton.joint_kinds,
        parents=skeleton.parents,
        p_R_j=np.array([pose.rotation for pose in skeleton.placements]),
        p_r_j=np.array([pose.translation for pose in skeleton.placements]),
        masses=np.array([body.mass for body in skeleton.masses]),
        coms=np.array([body.com for body in skeleton.masses]),
        inertias=np.array([_tensor(body) for body in skeleton.masses]),
        is_floating=skeleton.is_floating,
        frames=tuple(BodyFrame(f.name, f.body, *_arrays(f.pose)) for f in skeleton.frames),
    )


def drives_of(names: Sequence[str], joints: Mapping[str, JointProperties]) -> Drives | None:
    """Return rotors and friction of joints, None if nothing is told of any.

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


def skeleton_of_bodies(bodies: Bodies) -> Skeleton:
    """Return the skeleton of bodies, numbered like them."""
    poses = zip(bodies.p_R_j, bodies.p_r_j, strict=True)
    masses = zip(bodies.masses, bodies.coms, bodies.inertias, strict=True)
    return Skeleton(
        base_name=bodies.base_name,
        link_names=bodies.link_names,
        joint_names=bodies.joint_names,
        joint_kinds=bodies.joint_kinds,
        parents=bodies.parents,
        placements=tuple(_pose(R, r) for R, r in poses),
        masses=tuple(_mass_distribution(float(m), com, tensor) for m, com, tensor in masses),
        is_floating=bodies.is_floating,
        frames=tuple(
            AttachedFrame(f.name, f.body, _pose(f.body_R_frame, f.body_r_frame))
            for f in bodies.frames
        ),
    )


def _pose(R: Array, r: Array) -> RigidPose:
    x, y, z = (_triple(row) for row in R)
    return RigidPose((x, y, z), _triple(r))


def _mass_distribution(mass: float, com: Array, tensor: Array) -> MassDistribution:
    (Ix, Ixy, Ixz), (_, Iy, Iyz), (_, _, Iz) = tensor.tolist()
    return MassDistribution(mass, _triple(com), (Ix, Iy, Iz, -Ixy, -Ixz, -Iyz))


def _triple(values: Array) -> Vector3:
    x, y, z = values.tolist()
    return x, y, z


def _arrays(pose: RigidPose) -> tuple[Array, Array]:
    return np.array(pose.rotation), np.array(pose.translation)


def _tensor(body: MassDistribution) -> tuple[tuple[float, ...], ...]:
    """Return the inertia tensor, products with their minus signs."""
    Ix, Iy, Iz, Ixy, Ixz, Iyz = body.moments
    return (Ix, -Ixy, -Ixz), (-Ixy, Iy, -Iyz), (-Ixz, -Iyz, Iz)
