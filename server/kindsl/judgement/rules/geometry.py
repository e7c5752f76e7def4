"""Things with a pose or a length, for the rules about geometry."""

from collections.abc import Iterator

from kindsl.language.semantics.declarations import Declarations, Frame, Joint, Vector


def posed_things(declared: Declarations) -> Iterator[Frame | Joint]:
    """Yield everything in an island that has a pose."""
    for body in declared.bodies():
        yield from body.frames
    yield from declared.joints


def rotations(declared: Declarations) -> Iterator[Vector]:
    """Yield the rotations in an island."""
    for thing in posed_things(declared):
        if thing.pose.rotation is not None:
            yield thing.pose.rotation


def lengths(declared: Declarations) -> Iterator[Vector]:
    """Yield the translations and centres of mass in an island."""
    for thing in posed_things(declared):
        if thing.pose.translation is not None:
            yield thing.pose.translation
    for body in declared.bodies():
        if body.inertia is not None and body.inertia.com is not None:
            yield body.inertia.com
