"""Models in a model of SDF made one: names and frames as `sub::link`, poses as they were."""

from typing import Any

from kindsl.robots.interchange.sdf.elements import defect, name_of
from kindsl.robots.interchange.sdf.frame_graph import MODEL, WORLD
from kindsl.robots.interchange.xml_reading import XmlElement

NAMED = ("link", "joint", "frame")
# Where an element names a frame, by attribute and by text.
_ATTRIBUTES = ("relative_to", "attached_to", "expressed_in")
_TEXTS = ("parent", "child")


def flatten(model: Any) -> None:
    """Put what is in the models of a model into the model itself, at any depth.

    Each keeps its frame, called `sub::__model__`, attached to its canonical link.

    Raises:
        FormatError: A model in it is placed by one of its frames, or has no link.
    """
    for inner in model.findall("model"):
        flatten(inner)
        if inner.get("placement_frame"):
            raise defect(inner, "has a placement_frame within a model, which is not supported")
        own = name_of(inner)
        parts = [part for part in inner if part.tag in NAMED]
        for part in parts:
            _rename(part, own)
        frame = _frame_of(inner, own)
        place = list(model).index(inner)
        model.remove(inner)
        for offset, part in enumerate((frame, *parts)):
            model.insert(place + offset, part)


def _frame_of(model: Any, own: str) -> XmlElement:
    """Return the frame that stands for a model in another one."""
    links = (name_of(part) for part in model.findall("link"))
    canonical = model.get("canonical_link") or next(links, "")
    if not canonical:
        raise defect(model, "has no link", "KD008")
    # Links have their new names already; the attribute has the old one.
    prefix = "" if canonical.startswith(f"{own}::") else f"{own}::"
    attached = f"{prefix}{canonical}"
    frame = XmlElement.beside(model, "frame", name=f"{own}::{MODEL}", attached_to=attached)
    pose = model.find("pose")
    pose = XmlElement.beside(model, "pose") if pose is None else pose
    frame.append(pose)
    pose.set("relative_to", pose.get("relative_to") or MODEL)
    return frame


def _rename(part: Any, own: str) -> None:
    """Give a part of a model, and the frames that it names, the model's name before theirs."""
    _place(part)
    part.set("name", f"{own}::{name_of(part)}")
    for element in part.iter():
        for attribute in _ATTRIBUTES:
            if element.get(attribute):
                element.set(attribute, _renamed(element.get(attribute), own))
        if element.tag in _TEXTS and element is not part and element.text:
            element.text = _renamed(element.text.strip(), own)
    for mimic in part.iterfind("axis/mimic"):
        mimic.set("joint", _renamed(mimic.get("joint") or "", own))


def _place(part: Any) -> None:
    """Name the model's frame where a pose is in it because no other is named."""
    is_in_model = part.tag == "link" or (part.tag == "frame" and not part.get("attached_to"))
    if part.tag == "frame" and is_in_model:
        part.set("attached_to", MODEL)
    if not is_in_model:
        return
    pose = part.find("pose")
    if pose is None:
        pose = XmlElement.beside(part, "pose")
        part.append(pose)
    if not pose.get("relative_to"):
        pose.set("relative_to", MODEL)


def _renamed(name: str, own: str) -> str:
    return name if name == WORLD else f"{own}::{name}"
