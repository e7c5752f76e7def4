"""Some links and joints of a URDF without the rest of it."""

import re
from collections.abc import Iterator
from typing import Any, NamedTuple
from xml.sax.saxutils import quoteattr

from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf
from kindsl.robots.interchange.xml_reading import XmlError, parsed_xml
from kindsl.robots.mechanism.linkage import RigidBody

_PROLOGUE = re.compile(r"<\?.*?\?>|</?robot\b[^<>]*>", re.DOTALL)
_BASE = "the rest of the robot"
_INERTIAL = "the inertial alone"


class Fragment(NamedTuple):
    """Links and joints in frames of the language.

    Attributes:
        links: All links that are given or named, parents first; `parent` is an index in them, and
            None where no joint is given.
        given_links: Names of those that are given.
        given_joints: Names of the joints that are.
        inertial: The link of an inertia that is given without one.
        has_limits: Whether joints have limits, which the document does not hold.
    """

    links: tuple[RigidBody, ...]
    given_links: frozenset[str]
    given_joints: frozenset[str]
    inertial: RigidBody | None = None
    has_limits: bool = False


def fragment_of_urdf(text: str) -> Fragment:
    """Return the links and joints of a text; lines are counted from its first one.

    A joint's axis becomes z; the frames of what it carries turn with it.

    Raises:
        FormatError: It is not readable, or one of them is beyond the language.
    """
    inner = _PROLOGUE.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)
    try:
        robot: Any = parsed_xml(f"<robot>{inner}</robot>")
    except XmlError as error:
        raise FormatError(str(error)) from error
    if robot.find("inertial") is not None:
        return _of_inertial(inner)
    given = {kind: _names(robot, kind) for kind in ("link", "joint")}
    more = "".join(_added(robot, given["link"]))
    read = robot_of_urdf(f'<robot name="pasted">{inner}{more}</robot>', "pasted")
    for reason in read.refused:
        raise FormatError(reason)
    links = [
        _without_base(link)
        for link in read.robot.bodies
        if link.name != _BASE and link.parent is not None
    ]
    names = frozenset(given["link"]), frozenset(given["joint"])
    return Fragment(tuple(links), *names, has_limits=robot.find("joint/limit") is not None)


def _of_inertial(inner: str) -> Fragment:
    link = f"<link name={quoteattr(_INERTIAL)}>{inner}</link>"
    fragment = fragment_of_urdf(link)
    return Fragment((), frozenset(), frozenset(), fragment.links[0])


def _names(robot: Any, kind: str) -> list[str]:
    return [str(element.get("name")) for element in robot.findall(kind)]


def _added(robot: Any, given: list[str]) -> Iterator[str]:
    """Yield the links that are named only, and joints that carry what no joint carries."""
    ends = {
        which: [str(end.get("link")) for end in robot.findall(f"joint/{which}")]
        for which in ("parent", "child")
    }
    named = dict.fromkeys((*given, *ends["parent"], *ends["child"]))
    yield f"<link name={quoteattr(_BASE)}/>"
    for name in named:
        if name not in given:
            yield f"<link name={quoteattr(name)}/>"
        if name not in ends["child"]:
            yield (
                f'<joint name={quoteattr(f"carrying {name}")} type="continuous">'
                f"<parent link={quoteattr(_BASE)}/><child link={quoteattr(name)}/>"
                '<axis xyz="0 0 1"/></joint>'
            )


def _without_base(link: RigidBody) -> RigidBody:
    """Return a link with its parent's index counted from behind the base."""
    return link._replace(parent=link.parent - 1 if link.parent else None)
