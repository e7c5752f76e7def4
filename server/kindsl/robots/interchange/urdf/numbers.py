"""The places of a URDF's numbers."""

from kindsl.robots.comparison.quantities import AXIS, INERTIA, POSE, TURNS
from kindsl.robots.interchange.written_numbers import FileNumbers, XmlNumbers
from kindsl.robots.interchange.xml_terms import TENSOR


def numbers_of_urdf(content: bytes | str) -> FileNumbers:
    """Return the numbers of a URDF's links and joints, none of a text that is not XML."""
    xml = XmlNumbers(content)
    for link in xml.root.iterfind("link[inertial]"):
        name, inertial = link.get("name") or "", link.find("inertial")
        origin, inertia = inertial.find("origin"), inertial.find("inertia")
        xml.keep("link", name, ("mass",), xml.of_attribute(inertial.find("mass"), "value"))
        xml.keep("link", name, INERTIA[1:4], xml.of_attribute(origin, "xyz"))
        moments = [number for m in TENSOR for number in xml.of_attribute(inertia, m)]
        xml.keep("link", name, INERTIA[4:], moments)
        xml.keep("link", name, TURNS, xml.of_attribute(origin, "rpy"))
    for joint in xml.root.iterfind("joint"):
        name, origin = joint.get("name") or "", joint.find("origin")
        xml.keep_place("joint", name, (*TURNS, AXIS), xml.of_attribute(joint.find("axis"), "xyz"))
        at, turned = xml.of_attribute(origin, "xyz"), xml.of_attribute(origin, "rpy")
        xml.keep("joint", name, POSE[:3], at)
        xml.keep("joint", name, TURNS, turned)
        child = joint.find("child")
        if joint.get("type") == "fixed" and child is not None:
            xml.keep_place("frame", child.get("link") or "", POSE[:3], at)
            xml.keep_place("frame", child.get("link") or "", TURNS, turned)
    return xml.found
