"""From a linkage to the arrays that the dynamics work on."""

from collections.abc import Mapping, Sequence

import numpy as np

from kindsl.language.semantics.parameters import UNTOLD, JointProperties
from kindsl.mechanics.dynamics.bodies import Bodies, BodyFrame, Drives
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.mechanics.spatial.arrays import Array
from kindsl.robots.mechanism.linkage import Linkage


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


def _arrays(pose: RigidPose) -> tuple[Array, Array]:
    return np.array(pose.rotation), np.array(pose.translation)


def _tensor(body: MassDistribution) -> tuple[tuple[float, ...], ...]:
    """Return the inertia tensor, products with their minus signs."""
    Ix, Iy, Iz, Ixy, Ixz, Iyz = body.moments
    return (Ix, -Ixy, -Ixz), (-Ixy, Iy, -Iyz), (-Ixz, -Iyz, Iz)
