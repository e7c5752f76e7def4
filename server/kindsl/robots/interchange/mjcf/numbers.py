"""Places of the numbers of an MJCF's bodies, as far as the file itself gives them."""

from typing import Any

from kindsl.robots.comparison.quantities import AXIS, INERTIA, POSE, TURNS
from kindsl.robots.interchange.written_numbers import FileNumbers, XmlNumbers

_ORIENTATIONS = ("quat", "euler", "axisangle", "xyaxes", "zaxis")
_FREE = "free"


def numbers_of_mjcf(content: bytes | str) -> FileNumbers:
    """Return the numbers of inertias along their bodies' axes, and of what carries the bodies."""
    xml = XmlNumbers(content)
    for body in xml.root.iter("body"):
        name, inertial = body.get("name") or "", body.find("inertial")
        xml.keep("link", name, ("mass",), xml.of_attribute(inertial, "mass"))
        xml.keep("link", name, INERTIA[1:4], xml.of_attribute(inertial, "pos"))
        xml.keep("link", name, INERTIA[4:7], xml.of_attribute(inertial, "diaginertia"))
        xml.keep("link", name, INERTIA[4:], xml.of_attribute(inertial, "fullinertia"))
        for placed in (body, *body.iterfind("site")):
            own = placed.get("name") or ""
            xml.keep_place("frame", own, POSE[:3], xml.of_attribute(placed, "pos"))
            _keep_turns(xml, "frame", own, placed)
        joints = [j for j in body.iterfind("joint") if j.get("type") != _FREE]
        for joint, placed in zip(joints, [body, *joints[1:]], strict=False):
            # The body says where its first joint is, and the joint's own attributes what is left.
            name, own = joint.get("name") or "", xml.of_attribute(joint, "pos")
            xml.keep_place("joint", name, POSE[:3], own)
            xml.keep_place("joint", name, (*TURNS, AXIS), xml.of_attribute(joint, "axis"))
            xml.keep("joint", name, POSE[:3], xml.of_attribute(placed, "pos"))
            _keep_turns(xml, "joint", name, placed)
    return xml.found


def _keep_turns(xml: XmlNumbers, kind: str, name: str, placed: Any) -> None:
    for attribute in _ORIENTATIONS:
        xml.keep_place(kind, name, TURNS, xml.of_attribute(placed, attribute))
