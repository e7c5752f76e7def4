"""Another robot in our conventions: our names, link frames, zeros and signs where bodies match."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from kindsl.mechanics.rigid.body import seen_from
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.comparison.alignment import around
from kindsl.robots.comparison.mechanical import MechanicalComparison
from kindsl.robots.mechanism.linkage import BodyPart, Linkage, RigidBody


def restated(ours: Linkage, theirs: Linkage, found: MechanicalComparison) -> Linkage:
    """Return the other robot so that our joint values put its bodies where they belong.

    Args:
        ours: A robot.
        theirs: Another; bodies that match none keep their names, as far as these are free.
        found: What comparing them found.
    """
    our_body = {its: body for body, its in found.matching.theirs.items()}
    taken = {*ours.body_names, *ours.joint_names}
    frames = [body_frame(found, our_body.get(its)) for its in range(len(theirs.body_names))]
    links = [*_names(theirs.link_names, ours.link_names, our_body, taken)]
    joints = ["", *_names(theirs.joint_names, ours.joint_names, our_body, taken)]
    named = zip(theirs.bodies, (ours.base_name, *links), joints, frames, strict=True)
    bodies = [_in_frame(body, name, frame)._replace(joint=j) for body, name, j, frame in named]
    for its, body in enumerate(bodies):
        if body.parent is not None:
            pose = frames[body.parent].then(body.placement)
            if its in our_body:
                pose = pose.then(around(ours, found.alignment, our_body[its])[1])
            bodies[its] = body._replace(placement=pose)
    for frame in theirs.frames:
        pose = frames[frame.body].then(frame.pose)
        part = BodyPart(_free(frame.name, taken), pose, is_link=False)
        bodies[frame.body] = bodies[frame.body]._replace(parts=(*bodies[frame.body].parts, part))
    return replace(theirs, bodies=tuple(bodies))


def _in_frame(body: RigidBody, name: str, frame: RigidPose) -> RigidBody:
    """Return a body by another name, without frames, its own frame being at a pose."""
    mass = None if body.mass is None else seen_from(body.mass, frame)
    return body._replace(parts=(BodyPart(name, mass=mass),))


def body_frame(found: MechanicalComparison, body: int | None) -> RigidPose:
    """Return where the other's link frame is in ours; one of a body without a match stays."""
    return IDENTITY if body is None else found.alignment.frames.get(body, IDENTITY)


def _names(
    names: Iterable[str], our_names: tuple[str, ...], our_body: dict[int, int], taken: set[str]
) -> Iterator[str]:
    for its, name in enumerate(names, 1):
        yield our_names[our_body[its] - 1] if its in our_body else _free(name, taken)


def _free(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "'"
    taken.add(name)
    return name
