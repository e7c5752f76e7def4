"""The thing that a finding is about."""

from enum import StrEnum
from typing import NamedTuple

from kindsl.language.semantics.declarations import Frame, Joint, Link
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.places import Located


class SubjectKind(StrEnum):
    """The kind of thing that a finding is about."""

    LINK = "link"
    JOINT = "joint"
    FRAME = "frame"
    PARAMETER = "parameter"
    DOCUMENT = "document"


class Subject(NamedTuple):
    """A thing by kind and name; the robot's base is a link, the document has no name."""

    kind: SubjectKind
    name: str


DOCUMENT = Subject(SubjectKind.DOCUMENT, "")


def parameter_subject(name: str) -> Subject:
    """Return a parameter as a subject."""
    return Subject(SubjectKind.PARAMETER, str(name))


def link_subject(name: str) -> Subject:
    """Return a link, or the base, as a subject."""
    return Subject(SubjectKind.LINK, str(name))


def subject_at(at: Located) -> Subject:
    """Return the frame with a name, link or joint whose text a place is in, else the document."""
    declared = declarations(at.island)
    for link in declared.bodies():
        for frame in link.frames:
            if frame.name and _holds(frame, at):
                return Subject(SubjectKind.FRAME, str(frame.name))
        if _holds(link, at):
            return Subject(SubjectKind.LINK, str(link.name))
    for joint in declared.joints:
        if _holds(joint, at):
            return Subject(SubjectKind.JOINT, str(joint.name))
    return DOCUMENT


def _holds(thing: Link | Joint | Frame, at: Located) -> bool:
    return thing.start <= at.start and at.end <= thing.end
