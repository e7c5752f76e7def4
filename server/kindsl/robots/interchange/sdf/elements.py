"""The elements of an SDF file and the values in them, each error with its line."""

from math import radians
from typing import Any

from kindsl.mechanics.rigid.pose import (
    IDENTITY,
    RigidPose,
    meant_angle,
    pose_from_fixed_axes,
    rotation_from_quaternion,
)
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.xml_reading import XmlError, finite_number, parsed_xml

# What a model's own frame is called in a model that holds it.
OF_MODEL = "::__model__"
_NUMBER = "KD005"


def parsed(content: bytes | str) -> Any:
    """Return the root element.

    Raises:
        FormatError: It is no well-formed SDF.
    """
    try:
        root = parsed_xml(content)
    except XmlError as error:
        raise FormatError(f"not a readable SDF: {error}") from error
    if root.tag != "sdf":
        raise FormatError(f"not an SDF: its root element is <{root.tag}>, not <sdf>")
    return root


class SdfError(FormatError):
    """Something is wrong with an element.

    Attributes:
        sentence: What is wrong, without the line.
        code: The rule that it is reported under, empty for what is only not supported.
        missing: The name that the element gives of what is not there, if that is wrong.
        is_misspelt: Whether something is there that is nearly called so.
    """

    missing = ""
    is_misspelt = False

    def __init__(self, element: Any, sentence: str, code: str) -> None:
        super().__init__(f"line {element.sourceline}: {sentence}")
        self.element, self.sentence, self.code = element, sentence, code


def defect(element: Any, what: str, code: str = "") -> SdfError:
    """Return the error for what is wrong with an element, or not supported, which has no code."""
    name, tag = element.get("name"), element.tag
    if name and name.endswith(OF_MODEL):
        name, tag = name.removesuffix(OF_MODEL), "model"
    told = f"{tag} name='{name}'" if name else tag
    return SdfError(element, f"<{told}> {what}", code)


def name_of(element: Any) -> str:
    """Return an element's name, which it must have."""
    name = (element.get("name") or "").strip()
    if not name:
        raise defect(element, "has no name", "KD001")
    return str(name)


def text_of(element: Any, tag: str) -> str:
    """Return the text of a child, which must be there."""
    child = element.find(tag)
    text = "" if child is None else (child.text or "").strip()
    if not text:
        raise defect(element, f"has no <{tag}>", "KD008")
    return str(text)


def is_true(element: Any, tag: str) -> bool:
    """Return whether a child says so."""
    return (element.findtext(tag) or "").strip().lower() in ("1", "true")


def number_of(element: Any, tag: str, default: float) -> float:
    """Return the number in a child, the default where there is no such child."""
    child = element.find(tag)
    return default if child is None else numbers_in(child, 1)[0]


def numbers_in(element: Any, count: int) -> list[float]:
    """Return the finite numbers in an element, or raise where there are more or fewer."""
    words = (element.text or "").split()
    if len(words) != count:
        raise defect(element, f"has {len(words)} numbers, not {count}", _NUMBER)
    return [_number(element, word) for word in words]


def pose_of(element: Any) -> RigidPose:
    """Return the pose that an element's <pose> gives; none is the identity."""
    pose = element.find("pose")
    if pose is None or not (pose.text or "").strip():
        return IDENTITY
    if pose.get("rotation_format", "euler_rpy") == "quat_xyzw":
        x, y, z, *quaternion = numbers_in(pose, 7)
        rotation = rotation_from_quaternion(*quaternion)
        if rotation is None:
            raise defect(pose, "has a quaternion of no length", _NUMBER)
        return RigidPose(rotation, (x, y, z))
    x, y, z, *angles = numbers_in(pose, 6)
    if (pose.get("degrees") or "").lower() in ("1", "true"):
        angles = [radians(angle) for angle in angles]
    roll, pitch, yaw = map(meant_angle, angles)
    return pose_from_fixed_axes((x, y, z), (roll, pitch, yaw))


def _number(element: Any, word: str) -> float:
    value = finite_number(word)
    if value is None:
        raise defect(element, f"has '{word}', which is not a finite number", _NUMBER)
    return value
