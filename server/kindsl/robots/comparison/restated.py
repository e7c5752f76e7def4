"""Another robot in our conventions: our names, link frames, zeros and signs where bodies match."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from kindsl.mechanics.rigid.body import seen_from
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.comparison.alignment import around
from kindsl.robots.comparison.mechanical import MechanicalComparison
from kindsl.robots.mechanism.skeleton import AttachedFrame, Skeleton


def restated(ours: Skeleton, theirs: Skeleton, found: MechanicalComparison) -> Skeleton:
    """Return the other robot so that our joint values put its bodies where they belong.

    Args:
        ours: A robot.
        theirs: Another; bodies that match none keep their names, as far as these are free.
        found: What comparing them found.
    """
    our_body = {its: body for body, its in found.matching.theirs.items()}
    taken = {*ours.body_names, *ours.joint_names}
    frames = [body_frame(found, our_body.get(its)) for its in range(len(theirs.body_names))]
    joints = enumerate(zip(theirs.parents, theirs.placements, strict=True), 1)
    return replace(
        theirs,
        base_name=ours.base_name,
        link_names=tuple(_names(theirs.link_names, ours.link_names, our_body, taken)),
        joint_names=tuple(_names(theirs.joint_names, ours.joint_names, our_body, taken)),
        placements=tuple(
            _at_our_zero(ours, found, our_body.get(its), frames[parent].then(placement))
            for its, (parent, placement) in joints
        ),
        masses=tuple(seen_from(m, f) for m, f in zip(theirs.masses, frames, strict=True)),
        frames=tuple(_frames(theirs, frames, taken)),
    )


def body_frame(found: MechanicalComparison, body: int | None) -> RigidPose:
    """Return where the other's link frame is in ours; one of a body without a match stays."""
    return IDENTITY if body is None else found.alignment.frames.get(body, IDENTITY)


def _at_our_zero(
    ours: Skeleton, found: MechanicalComparison, body: int | None, pose: RigidPose
) -> RigidPose:
    """Return a joint frame in its predecessor at our zero, of one at the other's."""
    return pose if body is None else pose.then(around(ours, found.alignment, body)[1])


def _names(
    names: Iterable[str], our_names: tuple[str, ...], our_body: dict[int, int], taken: set[str]
) -> Iterator[str]:
    for its, name in enumerate(names, 1):
        yield our_names[our_body[its] - 1] if its in our_body else _free(name, taken)


def _frames(theirs: Skeleton, frames: list[RigidPose], taken: set[str]) -> Iterator[AttachedFrame]:
    for frame in theirs.frames:
        name = _free(frame.name, taken)
        yield AttachedFrame(name, frame.body, frames[frame.body].then(frame.pose))


def _free(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "'"
    taken.add(name)
    return name
