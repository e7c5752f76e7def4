"""Places of the numbers of an MJCF's bodies, as far as the file itself gives them."""

from collections.abc import Iterator
from typing import Any

from kindsl.robots.comparison.quantities import AXIS, INERTIA, POSE, TURNS
from kindsl.robots.comparison.written import WrittenNumber
from kindsl.robots.interchange.written_numbers import FileNumbers, XmlNumbers, implied, keyed

_ORIENTATIONS = ("quat", "euler", "axisangle", "xyaxes", "zaxis")
_FREE = "free"


def numbers_of_mjcf(content: bytes | str) -> FileNumbers:
    """Return the numbers of inertias along their bodies' axes, and of what carries the bodies."""
    xml = XmlNumbers(content)
    found: dict[tuple[str, str, str], WrittenNumber] = {}
    for body in xml.root.iter("body") if xml.root is not None else ():
        name, inertial = body.get("name") or "", body.find("inertial")
        found |= keyed("link", name, ("mass",), xml.of_attribute(inertial, "mass"))
        found |= keyed("link", name, INERTIA[1:4], xml.of_attribute(inertial, "pos"))
        found |= keyed("link", name, INERTIA[4:7], xml.of_attribute(inertial, "diaginertia"))
        found |= keyed("link", name, INERTIA[4:], xml.of_attribute(inertial, "fullinertia"))
        for placed in (body, *body.iterfind("site")):
            found |= _frame(xml, placed)
        for joint, placed in _placed_joints(body):
            found |= _pose(xml, joint, placed)
    return FileNumbers(found, {})


def _frame(xml: XmlNumbers, placed: Any) -> Iterator[tuple[tuple[str, str, str], WrittenNumber]]:
    """Yield the place of each number of a body without joints, or a site."""
    name = placed.get("name") or ""
    yield from implied("frame", name, POSE[:3], xml.of_attribute(placed, "pos"))
    for attribute in _ORIENTATIONS:
        yield from implied("frame", name, TURNS, xml.of_attribute(placed, attribute))


def _placed_joints(body: Any) -> Iterator[tuple[Any, Any]]:
    """Yield the joints of a body, each with what says where it is: the body, then the joint."""
    joints = [j for j in body.iterfind("joint") if (j.get("type") or "") != _FREE]
    yield from ((joint, joint if number else body) for number, joint in enumerate(joints))


def _pose(
    xml: XmlNumbers, joint: Any, placed: Any
) -> Iterator[tuple[tuple[str, str, str], WrittenNumber]]:
    """Yield the place of each number of a joint's pose; its own attributes say what is left."""
    name, own = joint.get("name") or "", xml.of_attribute(joint, "pos")
    yield from implied("joint", name, POSE[:3], own)
    yield from implied("joint", name, (*TURNS, AXIS), xml.of_attribute(joint, "axis"))
    yield from keyed("joint", name, POSE[:3], xml.of_attribute(placed, "pos"))
    for attribute in _ORIENTATIONS:
        yield from implied("joint", name, TURNS, xml.of_attribute(placed, attribute))
