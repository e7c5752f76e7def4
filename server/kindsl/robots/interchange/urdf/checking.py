"""Defects of a URDF as a tree with finite numbers: said before it is read, with their lines.

What is kept is what the Kinematics-DSL can say: links with their inertias, joints with their poses
and axes. Meshes, materials, limits and whatever other programs add cannot be wrong for us.
"""

from typing import Any, NamedTuple

from kindsl.language.text.nearest import hint, nearest_name, nearest_word
from kindsl.mechanics.rigid.pose import Rotation, rotation_from_quaternion
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.rigid_links import TENSOR
from kindsl.robots.interchange.xml_reading import XmlElement, XmlError, finite_number, parsed_xml

WORLD = "world"
_TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
_ELSEWHERE = (("transmission", "transmission"), ("gazebo", "Gazebo extension"))


class UrdfError(FormatError):
    """The file is not a URDF, or describes a robot that the Kinematics-DSL does not support."""


class Remarkable(NamedTuple):
    """Parts of a URDF beyond poses and masses.

    Attributes:
        mimics: Pairs of a joint and the joint that it follows.
        n_drawn: How many links have visuals or collisions.
        elsewhere: Nouns, and how many elements are meant for some programs only.
    """

    mimics: tuple[tuple[str, str], ...]
    n_drawn: int
    elsewhere: tuple[tuple[str, int], ...]


def checked(content: bytes | str) -> tuple[XmlElement, Remarkable]:
    """Return the root element of a URDF whose tree, poses and masses are sound.

    Raises:
        UrdfError: It is not well-formed, not a tree, or has a number that is none.
    """
    try:
        robot = parsed_xml(content)
    except XmlError as error:
        raise UrdfError(f"not a readable URDF: {error}") from error
    if robot.tag != "robot":
        raise UrdfError(f"not a URDF: its root element is <{_name_of(robot)}>, not <robot>")
    _required(robot, "name")
    joints = robot.findall("joint")
    _add_world(robot, joints)
    links = robot.findall("link")
    _check_names(links)
    _check_names(joints)
    if not links:
        raise UrdfError("the URDF has no link")
    for link in links:
        _check_link(link)
    for joint in joints:
        _check_joint(joint)
    _check_tree(links, joints)
    return robot, _remarkable(robot, links, joints)


def _add_world(robot: XmlElement, joints: list[Any]) -> None:
    """Add the link 'world', which Drake does not require where it is a joint's parent."""
    names = {link.get("name") for link in robot.findall("link")}
    parents = {parent.get("link") for joint in joints for parent in joint.findall("parent")}
    if WORLD in parents - names:
        world = XmlElement("link", name=WORLD)
        world.sourceline, world.offset, world.comments = robot.sourceline, robot.offset, ()
        robot.insert(0, world)


def _check_names(elements: list[Any]) -> None:
    seen: dict[str, Any] = {}
    for element in elements:
        name = _required(element, "name")
        if not name.strip():
            raise _error(element, "has an empty name")
        if name in seen:
            first = seen[name].sourceline
            raise _error(element, f"has the name of the {element.tag} in line {first}")
        seen[name] = element


def _check_link(link: Any) -> None:
    for inertial in link.findall("inertial"):
        if inertial.find("mass") is None:
            raise _error(inertial, f"of link '{link.get('name')}' has no <mass>")
        numbers_of(inertial.find("mass"), "value", 1)
        for inertia in inertial.findall("inertia"):
            for name in TENSOR:
                _required(inertia, name)
                numbers_of(inertia, name, 1)
        _check_origin(inertial)


def _check_joint(joint: Any) -> None:
    kind = _required(joint, "type")
    if kind not in _TYPES:
        meant = hint(nearest_word(kind, _TYPES))
        raise _error(joint, f"has the unknown type '{kind}'{meant}")
    for end in ("parent", "child"):
        elements = joint.findall(end)
        if len(elements) != 1:
            raise _error(joint, f"has {len(elements) or 'no'} <{end}>, and needs one")
        _required(elements[0], "link")
    _check_origin(joint)
    for axis in joint.findall("axis") if kind not in ("fixed", "floating") else ():
        if axis.get("xyz") is not None and not any(x * x for x in numbers_of(axis, "xyz", 3)):
            raise _error(axis, f"of joint '{joint.get('name')}' has no length")


def _check_origin(parent: Any) -> None:
    for origin in parent.findall("origin"):
        for name in ("xyz", "rpy"):
            if origin.get(name) is not None:
                numbers_of(origin, name, 3)
        if origin.get("quat_xyzw") is not None:
            rotation_of(origin)


def _check_tree(links: list[Any], joints: list[Any]) -> None:
    """Raise if a link is missing, has two parents, or is part of a loop."""
    names = dict.fromkeys(link.get("name") for link in links)
    parent: dict[str, Any] = {}
    for joint in joints:
        for end in ("parent", "child"):
            name = joint.find(end).get("link")
            if name not in names:
                meant = hint(nearest_name(name, names))
                raise _error(joint, f"names a link '{name}' that does not exist{meant}")
        child = joint.find("child").get("link")
        if child in parent:
            first = parent[child].get("name")
            raise _error(joint, f"gives link '{child}' a second parent after joint '{first}'")
        parent[child] = joint
    done: set[str] = set()
    for joint in joints:
        loop = _loop_above(joint.find("child").get("link"), parent, done)
        if loop:
            raise _error(parent[loop[-1]], f"closes a loop: {' -> '.join(loop)}")
    roots = [link.get("name") for link in links if link.get("name") not in parent]
    if len(roots) != 1:
        told = ", ".join(f"'{name}'" for name in roots[:5]) + (", ..." if len(roots) > 5 else "")
        raise UrdfError(
            f"the URDF has {len(roots)} root links, exactly one root link is required: {told}"
        )


def _loop_above(link: str, parent: dict[str, Any], done: set[str]) -> list[str]:
    """Return the links of a loop above a link, the first one at both ends; mark what has none."""
    chain: list[str] = []
    while link in parent and link not in done:
        done.add(link)
        chain.append(link)
        link = parent[link].find("parent").get("link")
    if link not in chain:
        return []
    loop = chain[chain.index(link) :]
    return [*reversed(loop), loop[-1]]


def _remarkable(robot: Any, links: list[Any], joints: list[Any]) -> Remarkable:
    drawn = sum(_has(link, "visual") or _has(link, "collision") for link in links)
    mimicking = ((j.get("name"), j.find("mimic")) for j in joints)
    mimics = [(name, m.get("joint") or "?") for name, m in mimicking if m is not None]
    counts = ((noun, len(robot.findall(tag))) for tag, noun in _ELSEWHERE)
    elsewhere = tuple((noun, number) for noun, number in counts if number)
    return Remarkable(tuple(mimics), drawn, elsewhere)


def _has(element: Any, tag: str) -> bool:
    return element.find(tag) is not None


def _required(element: Any, name: str) -> str:
    value = element.get(name)
    if value is None:
        raise _error(element, f"has no attribute '{name}'")
    return str(value)


def numbers_of(element: Any, name: str, count: int) -> list[float]:
    """Return the finite numbers of an attribute, or raise where there are more or fewer."""
    words = _required(element, name).split()
    if len(words) != count:
        raise _error(element, f"has {len(words)} numbers in '{name}', not {count}")
    return [_number(element, name, word) for word in words]


def rotation_of(origin: Any) -> Rotation:
    """Return the rotation of an origin that is given as a quaternion."""
    if origin.get("rpy") is not None:
        raise _error(origin, "has both 'rpy' and 'quat_xyzw'")
    rotation = rotation_from_quaternion(*numbers_of(origin, "quat_xyzw", 4))
    if rotation is None:
        raise _error(origin, "has a quaternion of no length")
    return rotation


def _number(element: Any, name: str, word: str) -> float:
    value = finite_number(word)
    if value is None:
        raise _error(element, f"has '{word}' in '{name}', which is not a finite number")
    return value


def _error(element: Any, what: str) -> UrdfError:
    return UrdfError(f"line {element.sourceline}: <{_name_of(element)}> {what}")


def _name_of(element: Any) -> str:
    name = element.get("name")
    tag = str(element.tag)
    return f"{tag} name='{name}'" if name and tag in ("link", "joint") else tag
