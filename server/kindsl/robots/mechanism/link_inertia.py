"""A body's mass distribution as written, in its link frame, and seen from other frames."""

from functools import partial

from kindsl.language.semantics.declarations import Inertia, Link
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.numbers import mass_distribution, written_pose
from kindsl.language.semantics.unknown import Unknown, pose_expressions, why_unknown
from kindsl.language.text.facts import Fact
from kindsl.mechanics.rigid.body import MassDistribution, seen_from

NO_INERTIA = Unknown("it has no inertia section")
_IN_LINK_FRAME = Fact[tuple[object, MassDistribution | Unknown]]("inertia seen in the link frame")


def written_inertia(inertia: Inertia, values: Values) -> MassDistribution | Unknown:
    """Return an inertia in the frame that it is written in, or why it is not known."""
    body = mass_distribution(inertia, values)
    return why_unknown(inertia.values(), values) if body is None else body


def link_inertia(link: Link, values: Values) -> MassDistribution | Unknown:
    """Return a link's inertia in its link frame, or why it is not known."""
    if link.inertia is None:
        return NO_INERTIA
    if link.inertia.frame is None:
        return written_inertia(link.inertia, values)
    seen = partial(_seen_in_link_frame, link, link.inertia, values)
    return link.facts.made_of(_IN_LINK_FRAME, dict(values), seen)


def _seen_in_link_frame(link: Link, inertia: Inertia, values: Values) -> MassDistribution | Unknown:
    written = written_inertia(inertia, values)
    if isinstance(written, Unknown):
        return written
    frame = next((f for f in link.frames if f.name == inertia.frame), None)
    if frame is None:
        name = inertia.frame
        return Unknown(f"it has no frame `{name}`" if name else "its frame has no name")
    pose = written_pose(frame.pose, values)
    if pose is None:
        return why_unknown(pose_expressions(frame.pose), values)
    return seen_from(written, pose)
