"""Defects of a URDF as a tree with finite numbers: said before it is read, with their lines.

What is kept is what the Kinematics-DSL can say: links with their inertias, joints with their poses
and axes. Meshes, materials, limits and whatever other programs add cannot be wrong for us.
"""

from collections import Counter
from collections.abc import Iterator
from typing import Any, NamedTuple

from kindsl.language.text.nearest import hint, nearest_name, nearest_word
from kindsl.language.text.phrases import listed
from kindsl.mechanics.rigid.pose import Rotation, rotation_from_quaternion
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.xml_reading import (
    TENSOR,
    XmlElement,
    XmlError,
    parsed_xml,
    wrong_numbers,
)
from kindsl.robots.limbs.names import label_of

WORLD = "world"
_TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
_SYNTAX, _NUMBER = "KD001", "KD005"
_PROPERTIES = {
    "limit": ("lower", "upper", "effort", "velocity"),
    "dynamics": ("damping", "friction"),
    "mimic": ("multiplier", "offset"),
}


class UrdfDefect(NamedTuple):
    """A defect of a URDF.

    Attributes:
        code: The rule that it is reported under.
        element: Where it is.
        what: What is wrong with the element.
        attribute: The attribute that is to blame, empty where that is the element.
        is_shown: Whether the robot can be shown nevertheless.
        meant: The link that a joint should carry instead, if one is known.
    """

    code: str
    element: Any
    what: str
    attribute: str = ""
    is_shown: bool = False
    meant: str | None = None

    @property
    def message(self) -> str:
        """The defect in one sentence."""
        return f"<{_name_of(self.element)}> {self.what}"


def checked(content: bytes | str) -> tuple[XmlElement, tuple[str, ...]]:
    """Return the root element of a URDF, a tree with known poses, and why it can only be shown.

    It needs no name. Where it has several roots the first one carries the others.

    Raises:
        FormatError: It is not well-formed, not a tree, or a pose has a number that is none.
    """
    try:
        robot = parsed_xml(content)
    except XmlError as error:
        raise FormatError(f"not a readable URDF: {error}") from error
    if robot.tag != "robot":
        raise FormatError(f"not a URDF: its root element is <{_name_of(robot)}>, not <robot>")
    joints = robot.findall("joint")
    _add_world(robot, joints)
    links = robot.findall("link")
    refused = []
    for defect in defects(robot):
        if defect.element is not robot:
            found = _error(defect.element, defect.what)
            if not defect.is_shown:
                raise found
            refused.append(str(found))
    if not links:
        raise FormatError("the URDF has no link")
    first, *others = root_links(links, joints)
    for other in others:
        _fix(robot, first, other)
    if others:
        second: Any = next(link for link in links if link.get("name") == others[0])
        told = ", ".join(f"'{n}'" for n in (first, *others)[:5]) + (", ..." if others[4:] else "")
        number = f"{len(others) + 1} root links, exactly one root link is required"
        refused.append(f"line {second.sourceline}: the URDF has {number}: {told}")
    return robot, tuple(refused)


def _fix(robot: XmlElement, parent: str, child: str) -> None:
    """Fix one root to another one: all are in the world's frame."""
    joint = XmlElement.beside(robot, "joint", name=f"{child}_fixed", type="fixed")
    ends = (("parent", parent), ("child", child))
    joint.extend(XmlElement.beside(robot, tag, link=name) for tag, name in ends)
    robot.append(joint)


def _add_world(robot: XmlElement, joints: list[Any]) -> None:
    """Add the link 'world', which Drake does not require where it is a joint's parent."""
    names = {link.get("name") for link in robot.findall("link")}
    parents = {parent.get("link") for joint in joints for parent in joint.findall("parent")}
    if WORLD in parents - names:
        robot.insert(0, XmlElement.beside(robot, "link", name=WORLD))


def defects(robot: Any) -> Iterator[UrdfDefect]:
    """Yield what keeps a `<robot>` from being a tree with finite numbers, but for several roots."""
    links, joints = robot.findall("link"), robot.findall("joint")
    yield from _missing(robot, "name")
    meant = _meant_by_repeated(links, joints)
    yield from _of_names(links, "KD102", hint(meant))
    yield from _of_names(joints, "KD103")
    for link in links:
        yield from (defect._replace(is_shown=True) for defect in of_inertia(link))
    for joint in joints:
        yield from _of_joint(joint)
    yield from _of_tree(links, joints, meant)


def root_links(links: list[Any], joints: list[Any]) -> list[str]:
    """Return the links that no joint carries."""
    carried = {end_of(joint, "child") for joint in joints}
    names = dict.fromkeys(str(link.get("name")) for link in links)
    return [name for name in names if name not in carried]


def end_of(joint: Any, which: str) -> str:
    """Return the link that is a joint's parent or child, empty where none is named."""
    element = joint.find(which)
    return "" if element is None else str(element.get("link") or "")


def _of_names(elements: list[Any], code: str, meant: str = "") -> Iterator[UrdfDefect]:
    seen: dict[str, Any] = {}
    for element in elements:
        name = element.get("name")
        if name is None:
            yield from _missing(element, "name")
        elif not name.strip():
            yield UrdfDefect(_SYNTAX, element, "has an empty name", "name")
        elif name in seen:
            first = seen[name].sourceline
            what = f"has the name of the {element.tag} in line {first}{meant}"
            yield UrdfDefect(code, element, what, "name")
        seen.setdefault(name or "", element)


def of_inertia(link: Any) -> Iterator[UrdfDefect]:
    """Yield what keeps the inertia of a link from being read."""
    for inertial in link.findall("inertial"):
        mass = inertial.find("mass")
        if mass is None:
            what = f"of link '{link.get('name')}' has no <mass>"
            yield UrdfDefect("KD008", inertial, what)
        else:
            yield from _of_numbers(mass, "value", 1)
        for inertia in inertial.findall("inertia"):
            yield from _missing(inertia, *TENSOR)
            for name in TENSOR:
                if inertia.get(name) is not None:
                    yield from _of_numbers(inertia, name, 1)
        yield from _of_origin(inertial)


def _of_joint(joint: Any) -> Iterator[UrdfDefect]:
    kind = joint.get("type")
    if kind is None:
        yield from _missing(joint, "type")
    elif kind not in _TYPES:
        meant = hint(nearest_word(kind, _TYPES))
        what = f"has the unknown type '{kind}'{meant}"
        yield UrdfDefect(_SYNTAX, joint, what, "type", is_shown=True)
    for end in ("parent", "child"):
        elements = joint.findall(end)
        if len(elements) != 1:
            what = f"has {len(elements) or 'no'} <{end}>, and needs one"
            yield UrdfDefect("KD008", joint, what)
        else:
            yield from _missing(elements[0], "link")
    yield from _of_origin(joint)
    moves = kind in ("revolute", "continuous", "prismatic")
    for tag, names in _PROPERTIES.items() if moves else ():
        # Without end it has no limits, whatever stands there.
        for name in names[2:] if kind == "continuous" and tag == "limit" else names:
            for element in joint.findall(tag):
                if element.get(name) is not None:
                    odd = _of_numbers(element, name, 1)
                    yield from (defect._replace(is_shown=True) for defect in odd)
    for axis in joint.findall("axis") if kind not in ("fixed", "floating") else ():
        if axis.get("xyz") is not None:
            found = list(_of_numbers(axis, "xyz", 3))
            yield from found
            if not found and not any(x * x for x in numbers_of(axis, "xyz", 3)):
                what = f"of joint '{joint.get('name')}' has no length"
                yield UrdfDefect(_NUMBER, axis, what, "xyz")


def _of_origin(parent: Any) -> Iterator[UrdfDefect]:
    for origin in parent.findall("origin"):
        for name in ("xyz", "rpy"):
            if origin.get(name) is not None:
                yield from _of_numbers(origin, name, 3)
        if origin.get("quat_xyzw") is not None:
            try:
                rotation_of(origin)
            except FormatError as error:
                what = str(error).partition("> ")[2]
                yield UrdfDefect(_NUMBER, origin, what, "quat_xyzw")


def _repeated(links: list[Any]) -> set[str]:
    count = Counter(link.get("name") for link in links)
    return {name for name, number in count.items() if name and number > 1}


def _meant_by_repeated(links: list[Any], joints: list[Any]) -> str | None:
    """Return the name that joints have for a link whose own is another's, None where that is open.

    One name is there twice, and one is not there at all that is no misspelling of a lost link's.
    """
    names = {link.get("name") for link in links} | {WORLD, ""}
    ends = {end_of(joint, end) for joint in joints for end in ("parent", "child")}
    missing, repeated = ends - names, _repeated(links)
    is_clear = len(missing) == 1 and len(repeated) == 1 and repeated <= ends
    return missing.pop() if is_clear and not _unnamed(links, joints) else None


def _unnamed(links: list[Any], joints: list[Any]) -> list[str]:
    """Return the links that no joint names."""
    ends = {end_of(joint, end) for joint in joints for end in ("parent", "child")}
    return [n for link in links if (n := str(link.get("name") or "")) and n not in ends]


def _of_tree(links: list[Any], joints: list[Any], meant: str | None) -> Iterator[UrdfDefect]:
    """Yield links that are missing, have two parents, or are part of a loop.

    What follows from a name that is another's is not told again.
    """
    names = dict.fromkeys([*(link.get("name") for link in links), *filter(None, [meant])])
    if any(end_of(joint, "parent") == WORLD for joint in joints):
        names[WORLD] = None
    repeated, unnamed = _repeated(links), _unnamed(links, joints)
    known = [name for name in names if name]
    parent: dict[str, Any] = {}
    second = []
    for joint in joints:
        for end in (*joint.findall("parent")[:1], *joint.findall("child")[:1]):
            name = end.get("link")
            if name is not None and name not in names:
                names[name] = None
                near = unnamed[0] if len(unnamed) == 1 else nearest_name(name, known)
                what = f"of joint '{joint.get('name')}' names a link '{name}' that does not exist"
                is_carried = end.tag == "child" or near in unnamed
                meant = near if is_carried else None
                yield UrdfDefect("KD105", end, what + hint(near), "link", meant=meant)
        child = end_of(joint, "child")
        if child in parent:
            is_repeated = joint.get("name") == parent[child].get("name") or child in repeated
            second += [] if is_repeated else [joint]
        elif child and end_of(joint, "parent"):
            parent[child] = joint
    for joint in second:
        first = parent[end_of(joint, "child")]
        odd, other, lost = _second_parent(first, joint, links, joints)
        order = "after" if odd is joint else "beside"
        what = f"gives link '{end_of(joint, 'child')}' a second parent {order} joint "
        lost = lost if len(second) == 1 else None
        yield UrdfDefect("KD202", odd, f"{what}'{other.get('name')}'{hint(lost)}", meant=lost)
    done: set[str] = set()
    for joint in joints:
        loop = _loop_above(end_of(joint, "child"), parent, done)
        if loop:
            yield UrdfDefect("KD201", parent[loop[-1]], f"closes a loop: {' -> '.join(loop)}")


def _second_parent(
    first: Any, second: Any, links: list[Any], joints: list[Any]
) -> tuple[Any, Any, str | None]:
    """Return which of two joints should not carry a link, the other one, and what it should carry.

    That is the only link which no joint carries, if there is one, and has the side or the number
    of the joint; where neither joint has, or both, the later one is to blame.
    """
    ways = [(each, other, _uncarried(each, links, joints)) for each, other in
            ((second, first), (first, second))]  # fmt: skip
    named = [way for way in ways if way[2] and _mark(way[0].get("name")) == _mark(way[2])]
    if len(named) == 1:
        return named[0]
    lost = ways[0][2] if ways[0][2] == ways[1][2] else None
    return second, first, lost


def _mark(name: str | None) -> tuple[str, ...]:
    side, row, words, _ = label_of(name or "")
    return side, row, *(word for word in words if word.isdigit())


def _uncarried(joint: Any, links: list[Any], joints: list[Any]) -> str | None:
    """Return the only link that no joint carries but for what carries a joint, if there is one."""
    above = {end_of(each, "child"): end_of(each, "parent") for each in reversed(joints)}
    link, seen = end_of(joint, "parent"), set[str]()
    while link in above and link not in seen:
        seen.add(link)
        link = above[link]
    others = [root for root in root_links(links, joints) if root != link]
    return others[0] if len(others) == 1 else None


def _loop_above(link: str, parent: dict[str, Any], done: set[str]) -> list[str]:
    """Return the links of a loop above a link, the first one at both ends; mark what has none."""
    chain: list[str] = []
    while link in parent and link not in done:
        done.add(link)
        chain.append(link)
        link = end_of(parent[link], "parent")
    if link not in chain:
        return []
    loop = chain[chain.index(link) :]
    return [*reversed(loop), loop[-1]]


def _missing(element: Any, *names: str) -> Iterator[UrdfDefect]:
    missing = [f"'{name}'" for name in names if element.get(name) is None]
    if missing:
        attributes = "attributes" if missing[1:] else "attribute"
        yield UrdfDefect(_SYNTAX, element, f"has no {attributes} {listed(missing)}")


def _of_numbers(element: Any, name: str, count: int) -> Iterator[UrdfDefect]:
    if element.get(name) is None:
        yield from _missing(element, name)
        return
    for what in wrong_numbers(element, name, count):
        yield UrdfDefect(_NUMBER, element, what, name)


def numbers_of(element: Any, name: str, count: int) -> list[float]:
    """Return the finite numbers of an attribute, or raise where there are more or fewer."""
    for defect in _of_numbers(element, name, count):
        raise _error(element, defect.what)
    return [float(word) for word in element.get(name).split()]


def rotation_of(origin: Any) -> Rotation:
    """Return the rotation of an origin that is given as a quaternion."""
    if origin.get("rpy") is not None:
        raise _error(origin, "has both 'rpy' and 'quat_xyzw'")
    rotation = rotation_from_quaternion(*numbers_of(origin, "quat_xyzw", 4))
    if rotation is None:
        raise _error(origin, "has a quaternion of no length")
    return rotation


def unsupported(joint: Any) -> FormatError:
    """Return the error for a joint of a kind that only URDF has."""
    return _error(joint, f"is a {joint.get('type')} joint, which the language does not support")


def _error(element: Any, what: str) -> FormatError:
    return FormatError(f"line {element.sourceline}: <{_name_of(element)}> {what}")


def _name_of(element: Any) -> str:
    name = element.get("name")
    tag = str(element.tag)
    return f"{tag} name='{name}'" if name and tag in ("link", "joint") else tag
