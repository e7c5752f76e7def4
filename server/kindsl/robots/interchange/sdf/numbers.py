"""Places of the numbers of an SDF's links and joints."""

from typing import Any

from kindsl.robots.comparison.quantities import AXIS, INERTIA, POSE, TURNS
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.sdf.frame_graph import FrameGraph
from kindsl.robots.interchange.sdf.nesting import flatten
from kindsl.robots.interchange.written_numbers import FileNumbers, XmlNumbers
from kindsl.robots.interchange.xml_reading import TENSOR


def numbers_of_sdf(content: bytes | str) -> FileNumbers:
    """Return the numbers of inertias along their links' axes, and of what places the joints."""
    xml = XmlNumbers(content)
    for model in (*xml.root.findall("model"), *xml.root.findall("world/model")):
        try:
            flatten(model)
        except FormatError:
            continue
        for link in model.iterfind("link[inertial]"):
            name, inertial = link.get("name") or "", link.find("inertial")
            xml.keep("link", name, ("mass",), xml.of_text(inertial.find("mass")))
            xml.keep("link", name, INERTIA[1:4], xml.of_text(inertial.find("pose"))[:3])
            for key, tag in zip(INERTIA[4:], TENSOR, strict=True):
                xml.keep("link", name, (key,), xml.of_text(inertial.find(f"inertia/{tag}")))
        for frame in model.iterfind("frame"):
            _keep_frame(xml, frame.get("name") or "", frame)
        _keep_joints(xml, model)
    return xml.found


def _keep_frame(xml: XmlNumbers, name: str, placed: Any) -> None:
    """Keep the place of each number of a frame, or of a link that is fixed to another."""
    numbers = xml.of_text(placed.find("pose"))
    xml.keep_place("frame", name, POSE[:3], numbers[:3])
    xml.keep_place("frame", name, TURNS, numbers[3:])


def _keep_joints(xml: XmlNumbers, model: Any) -> None:
    try:
        graph = FrameGraph(model, "")
        placing = [(joint, graph.placing(joint)) for joint in model.iterfind("joint")]
    except FormatError:
        return
    for joint, placed in placing:
        name, pose = joint.get("name") or "", placed.find("pose")
        xml.keep_place("joint", name, (*TURNS, AXIS), xml.of_text(joint.find("axis/xyz")))
        numbers = xml.of_text(pose)
        if joint.get("type") == "fixed":
            _keep_frame(xml, (joint.findtext("child") or "").strip(), placed)
        xml.keep("joint", name, POSE[:3], numbers[:3])
        is_as_meant = pose is not None and not pose.get("degrees") and len(numbers) == len(POSE)
        if is_as_meant and any(number.value for number in numbers[3:]):
            xml.keep("joint", name, TURNS, numbers[3:])
        elif any(number.value for number in numbers[3:6]):
            xml.keep_place("joint", name, TURNS, numbers[3:])
