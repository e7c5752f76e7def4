"""A body's mass distribution as written, in its link frame, and seen from other frames."""

from collections.abc import Mapping

from kindsl.rigid.body import MassDistribution, seen_from
from kindsl.semantics.declarations import Inertia, Link, inertia_values
from kindsl.semantics.numbers import mass_distribution, written_pose
from kindsl.semantics.unknown import Unknown, pose_expressions, why_unknown

NO_INERTIA = Unknown("it has no inertia section")


def written_inertia(inertia: Inertia, values: Mapping[str, float]) -> MassDistribution | Unknown:
    """Return an inertia in the frame that it is written in, or why it is not known."""
    body = mass_distribution(inertia, values)
    return why_unknown(inertia_values(inertia), values) if body is None else body


def link_inertia(link: Link, values: Mapping[str, float]) -> MassDistribution | Unknown:
    """Return a link's inertia in its link frame, or why it is not known."""
    if link.inertia is None:
        return NO_INERTIA
    written = written_inertia(link.inertia, values)
    if link.inertia.frame is None or isinstance(written, Unknown):
        return written
    frame = next((f for f in link.frames if f.name == link.inertia.frame), None)
    if frame is None:
        name = link.inertia.frame
        return Unknown(f"it has no frame `{name}`" if name else "its frame has no name")
    pose = written_pose(frame.pose, values)
    if pose is None:
        return why_unknown(pose_expressions(frame.pose), values)
    return seen_from(written, pose)
