"""The places of a URDF's numbers."""

from kindsl.mechanics.rigid.pose import IDENTITY, Rotation, pose_from_fixed_axes
from kindsl.robots.comparison.quantities import AXIS, INERTIA, POSE, TURNS
from kindsl.robots.comparison.written import WrittenNumber
from kindsl.robots.interchange.written_numbers import FileNumbers, XmlNumbers, implied, keyed
from kindsl.robots.interchange.xml_terms import TENSOR


def numbers_of_urdf(content: bytes | str) -> FileNumbers:
    """Return the numbers of a URDF's links and joints, none of a text that is not XML."""
    xml = XmlNumbers(content)
    found: dict[tuple[str, str, str], WrittenNumber] = {}
    turns: dict[str, Rotation] = {}
    for link in xml.root.iterfind("link") if xml.root is not None else ():
        name, inertial = link.get("name") or "", link.find("inertial")
        if inertial is None:
            continue
        origin, inertia = inertial.find("origin"), inertial.find("inertia")
        found |= keyed("link", name, ("mass",), xml.of_attribute(inertial.find("mass"), "value"))
        found |= keyed("link", name, INERTIA[1:4], xml.of_attribute(origin, "xyz"))
        moments = [number for m in TENSOR for number in xml.of_attribute(inertia, m)]
        found |= keyed("link", name, INERTIA[4:], moments)
        rpy = [number.value for number in xml.of_attribute(origin, "rpy")]
        if len(rpy) == 3:
            roll, pitch, yaw = rpy
            pose = pose_from_fixed_axes(IDENTITY.translation, (roll, pitch, yaw))
            turns[name] = pose.rotation
    for joint in xml.root.iterfind("joint") if xml.root is not None else ():
        name, origin = joint.get("name") or "", joint.find("origin")
        axis = xml.of_attribute(joint.find("axis"), "xyz")
        found |= implied("joint", name, (*TURNS, AXIS), axis)
        at, turned = xml.of_attribute(origin, "xyz"), xml.of_attribute(origin, "rpy")
        found |= keyed("joint", name, POSE[:3], at)
        found |= keyed("joint", name, TURNS, turned)
        child = joint.find("child")
        if joint.get("type") == "fixed" and child is not None:
            found |= implied("frame", child.get("link") or "", POSE[:3], at)
            found |= implied("frame", child.get("link") or "", TURNS, turned)
    return FileNumbers(found, turns)
