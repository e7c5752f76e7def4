"""Places of the numbers of an SDF's links and joints."""

from collections.abc import Iterator
from typing import Any

from kindsl.robots.comparison.quantities import AXIS, INERTIA, POSE, TURNS
from kindsl.robots.comparison.written import WrittenNumber
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.sdf.frame_graph import FrameGraph
from kindsl.robots.interchange.sdf.nesting import flatten
from kindsl.robots.interchange.written_numbers import FileNumbers, XmlNumbers, implied, keyed
from kindsl.robots.interchange.xml_terms import TENSOR

_Found = Iterator[tuple[tuple[str, str, str], WrittenNumber]]


def numbers_of_sdf(content: bytes | str) -> FileNumbers:
    """Return the numbers of inertias along their links' axes, and of what places the joints."""
    xml = XmlNumbers(content)
    found: dict[tuple[str, str, str], WrittenNumber] = {}
    for model in _models(xml.root):
        for link in model.iterfind("link"):
            found |= _inertia(xml, link)
        for frame in model.iterfind("frame"):
            found |= _frame(xml, frame.get("name") or "", frame)
        found |= _joints(xml, model)
    return FileNumbers(found, {})


def _models(root: Any) -> Iterator[Any]:
    """Yield the models of a file, each with those in it as one."""
    for model in (*root.findall("model"), *root.findall("world/model")) if root is not None else ():
        try:
            flatten(model)
        except FormatError:
            continue
        yield model


def _inertia(xml: XmlNumbers, link: Any) -> _Found:
    name, inertial = link.get("name") or "", link.find("inertial")
    if inertial is not None:
        yield from keyed("link", name, ("mass",), xml.of_text(inertial.find("mass")))
        yield from keyed("link", name, INERTIA[1:4], xml.of_text(inertial.find("pose"))[:3])
        for key, tag in zip(INERTIA[4:], TENSOR, strict=True):
            yield from keyed("link", name, (key,), xml.of_text(inertial.find(f"inertia/{tag}")))


def _frame(xml: XmlNumbers, name: str, placed: Any) -> _Found:
    """Yield the place of each number of a frame, or of a link that is fixed to another."""
    numbers = xml.of_text(placed.find("pose"))
    yield from implied("frame", name, POSE[:3], numbers[:3])
    yield from implied("frame", name, TURNS, numbers[3:])


def _joints(xml: XmlNumbers, model: Any) -> _Found:
    try:
        graph = FrameGraph(model, "")
        placing = [(joint, graph.placing(joint)) for joint in model.iterfind("joint")]
    except FormatError:
        return
    for joint, placed in placing:
        name, pose = joint.get("name") or "", placed.find("pose")
        axis = xml.of_text(joint.find("axis/xyz"))
        yield from implied("joint", name, (*TURNS, AXIS), axis)
        numbers = xml.of_text(pose)
        if joint.get("type") == "fixed":
            yield from _frame(xml, (joint.findtext("child") or "").strip(), placed)
        yield from keyed("joint", name, POSE[:3], numbers[:3])
        is_as_meant = pose is not None and not pose.get("degrees") and len(numbers) == len(POSE)
        if is_as_meant and any(number.value for number in numbers[3:]):
            yield from keyed("joint", name, TURNS, numbers[3:])
        elif any(number.value for number in numbers[3:6]):
            yield from implied("joint", name, TURNS, numbers[3:])
