"""The elements of an SDF file and the values in them, each error with its line."""

import re
from math import isfinite, radians
from typing import Any

import numpy as np

from kindsl.interchange.format import FormatError
from kindsl.spatial.arrays import Array
from kindsl.spatial.transforms import homogeneous

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_GREATEST = 1e50


def parsed(content: bytes) -> Any:
    """Return the root element.

    Raises:
        FormatError: It is no well-formed SDF.
    """
    from lxml import etree

    parser = etree.XMLParser(
        resolve_entities=False, no_network=True, remove_comments=True, remove_pis=True
    )
    try:
        root = etree.fromstring(content, parser=parser)
    except (etree.XMLSyntaxError, ValueError) as error:
        line = getattr(error, "lineno", None)
        where = f" at line {line}" if line else ""
        raise FormatError(f"not a readable SDF: not well-formed XML{where}") from error
    if root.tag != "sdf":
        raise FormatError(f"not an SDF: its root element is <{root.tag}>, not <sdf>")
    return root


def defect(element: Any, what: str) -> FormatError:
    """Return the error for what is wrong with an element."""
    name = element.get("name")
    told = f"{element.tag} name='{name}'" if name else element.tag
    return FormatError(f"line {element.sourceline}: <{told}> {what}")


def name_of(element: Any) -> str:
    """Return an element's name, which it must have."""
    name = (element.get("name") or "").strip()
    if not name:
        raise defect(element, "has no name")
    return str(name)


def text_of(element: Any, tag: str) -> str:
    """Return the text of a child, which must be there."""
    child = element.find(tag)
    text = "" if child is None else (child.text or "").strip()
    if not text:
        raise defect(element, f"has no <{tag}>")
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
        raise defect(element, f"has {len(words)} numbers, not {count}")
    return [_number(element, word) for word in words]


def pose_of(element: Any) -> Array:
    """Return the pose that an element's <pose> gives, shape (4, 4); none is the identity."""
    pose = element.find("pose")
    if pose is None or not (pose.text or "").strip():
        return np.eye(4)
    if pose.get("rotation_format", "euler_rpy") == "quat_xyzw":
        x, y, z, *quaternion = numbers_in(pose, 7)
        return homogeneous(_rotation_of_quaternion(pose, np.array(quaternion)), np.array([x, y, z]))
    x, y, z, *angles = numbers_in(pose, 6)
    if (pose.get("degrees") or "").lower() in ("1", "true"):
        angles = [radians(angle) for angle in angles]
    return homogeneous(_rotation_of_angles(*angles), np.array([x, y, z]))


def _number(element: Any, word: str) -> float:
    value = float(word) if _NUMBER.fullmatch(word) else float("nan")
    if not isfinite(value) or abs(value) > _GREATEST:
        raise defect(element, f"has '{word}', which is not a finite number")
    return value


def _rotation_of_angles(roll: float, pitch: float, yaw: float) -> Array:
    """Return the rotation about fixed axes: x, then y, then z."""
    (cr, cp, cy), (sr, sp, sy) = np.cos([roll, pitch, yaw]), np.sin([roll, pitch, yaw])
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, cr, -sr], [0.0, sr, cr]])
    about_y = np.array([[cp, 0.0, sp], [0.0, 1.0, 0.0], [-sp, 0.0, cp]])
    about_z = np.array([[cy, -sy, 0.0], [sy, cy, 0.0], [0.0, 0.0, 1.0]])
    return np.asarray(about_z @ about_y @ about_x)


def _rotation_of_quaternion(element: Any, quaternion: Array) -> Array:
    length = float(np.linalg.norm(quaternion))
    if not length > 0.0:
        raise defect(element, "has a quaternion of no length")
    x, y, z, w = quaternion / length
    return np.array(
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
            [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
            [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
        ]
    )
