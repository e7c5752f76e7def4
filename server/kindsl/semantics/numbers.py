"""What is written, as numbers: poses and vectors at given values of the parameters."""

from collections.abc import Mapping

from kindsl.rigid.pose import RigidPose, Triple, pose_from
from kindsl.semantics.declarations import Pose, Vector


def written_pose(pose: Pose, values: Mapping[str, float]) -> RigidPose | None:
    """Return a pose as the document gives it, None where a value is missing or unbound."""
    translation, angles = triple(pose.translation, values), triple(pose.rotation, values)
    if translation is None or angles is None:
        return None
    return pose_from(translation, angles)


def triple(vector: Vector | None, values: Mapping[str, float]) -> Triple | None:
    """Return the three numbers of a vector, None where there are not three."""
    if vector is None or len(vector.components) != 3:
        return None
    x, y, z = (component.value(values) for component in vector.components)
    return None if x is None or y is None or z is None else (x, y, z)
