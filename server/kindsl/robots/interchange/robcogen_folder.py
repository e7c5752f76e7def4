"""The robot in a folder that RobCoGen wrote, read off its C++ as text: no compiler is needed.

Masses, centres of mass and tensors stand in `inertia_properties`, about the link frames' origins;
the tree and the joints follow from which joint each transform between two links depends on.
"""

import ast
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from math import cos, isfinite, sin
from pathlib import Path
from typing import NamedTuple

from kindsl.language.text.lines import LineIndex
from kindsl.mechanics.rigid.joint_kind import JointKind
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.comparison.side import ComparedSide, exactly_turned, written_joints
from kindsl.robots.comparison.written import TextPlace, WrittenInertia, WrittenNumber
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.written_numbers import written_number
from kindsl.robots.mechanism.linkage import BodyPart, Linkage, RigidBody, checked

_INERTIA_FILES = ("inertia_properties.impl.h", "inertia_properties.cpp", "inertia_properties.h")
_TRANSFORM_FILES = ("transforms.impl.h", "transforms.cpp", "transforms.h")
_TOLD = re.compile(r'<<\s*"\s*(\w+)\s*=\s*"')
_CONSTANT = re.compile(
    r"\bconst(?:expr)?\b[^;={}]*?\b(\w+)\s*=\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*;"
)
_COM = re.compile(r"\bcom_(\w+)\s*=([^;]*);")
_TENSOR = re.compile(r"\btensor_(\w+)\s*\.\s*fill\s*\(([^;]*);")
_WORD = re.compile(
    r"(?P<number>(?:-\s*)?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)|(?P<name>(?:-\s*)?[A-Za-z_]\w*)"
)
_METHOD = re.compile(
    r"HomogeneousTransforms(?:<\w+>)?::Type_(\w+)::(?:Type_\w+|update)\s*\([^)]*\)[^{;]*\{"
)
_ENTRY = re.compile(r"\(\*this\)\((\d),\s*(\d)\)\s*=([^;]*);")
_LOCAL = re.compile(r"(\w+)\s*=\s*(?:\w+::)?(?:\w+::)?(sin|cos)\(\s*q\s*\(\s*(\w+)\s*\)\s*\)\s*;")
_JOINT_VALUE = re.compile(r"\bq\s*\(\s*(\w+)\s*\)")
_OPERATORS: Mapping[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: lambda a, b: a + b,
    ast.Sub: lambda a, b: a - b,
    ast.Mult: lambda a, b: a * b,
    ast.Div: lambda a, b: a / b,
}


class _Source(NamedTuple):
    """A file of the folder."""

    name: str
    text: str


class _Transform(NamedTuple):
    """A transform between two frames.

    Attributes:
        zero: The pose of the second frame in the first, all joints at zero.
        turning: The joints whose sine or cosine it has.
        sliding: The joints whose value itself it has.
    """

    zero: RigidPose
    turning: frozenset[str]
    sliding: frozenset[str]


def is_robcogen_folder(folder: Path) -> bool:
    """Return whether a folder has what RobCoGen writes."""
    return (
        _first(folder, _INERTIA_FILES) is not None and _first(folder, _TRANSFORM_FILES) is not None
    )


def described_robcogen(folder: Path, label: str) -> ComparedSide:
    """Return the robot of a folder of generated C++.

    Raises:
        FormatError: It is not as RobCoGen writes it, or depends on parameters.
        OSError: A file cannot be read.
    """
    inertia, transforms = _read(folder, _INERTIA_FILES), _read(folder, _TRANSFORM_FILES)
    links = _told_names(folder / "link_data_map.h")
    names = _told_names(folder / "joint_data_map.h")
    constants = dict(_constants(folder))
    found = dict(_transforms(transforms.text, constants))
    written = [_inertia(name, inertia, constants) for name in links]
    bodies = [RigidBody(()), *(_body(i, links, names, found) for i in range(1, len(links)))]
    masses = [None if each is None else each.body() for each in written]
    named = zip(bodies, links, masses, strict=True)
    whole = (body._replace(parts=(BodyPart(name, mass=mass),)) for body, name, mass in named)
    try:
        skeleton = checked(Linkage(tuple(whole), is_floating=masses[0] is not None))
    except ValueError as error:
        raise FormatError(str(error)) from None
    inertias = tuple(() if each is None else (each,) for each in written)
    return exactly_turned(ComparedSide(label, skeleton, inertias, written_joints(skeleton)))


def _first(folder: Path, names: Iterable[str]) -> Path | None:
    return next((folder / name for name in names if (folder / name).is_file()), None)


def _read(folder: Path, names: tuple[str, ...]) -> _Source:
    path = _first(folder, names)
    if path is None:
        raise FormatError(f"has no '{names[0]}'")
    return _Source(path.name, path.read_text("utf-8", "replace"))


def _told_names(path: Path) -> list[str]:
    """Return the names that a data map prints, in the order of the ids."""
    if not path.is_file():
        raise FormatError(f"has no '{path.name}'")
    names = _TOLD.findall(path.read_text("utf-8", "replace"))
    if not names:
        raise FormatError(f"'{path.name}' names nothing")
    return names


def _constants(folder: Path) -> Iterator[tuple[str, float]]:
    for path in sorted(folder.glob("*.h")):
        for name, value in _CONSTANT.findall(path.read_text("utf-8", "replace")):
            yield name, float(value)


def _inertia(name: str, source: _Source, constants: Mapping[str, float]) -> WrittenInertia | None:
    com = next((m for m in _COM.finditer(source.text) if m[1] == name), None)
    tensor = next((m for m in _TENSOR.finditer(source.text) if m[1] == name), None)
    if tensor is None:
        return None
    lines = LineIndex(source.text)
    mass_and_moments = list(_numbers(source, tensor, constants, lines))
    center = list(_numbers(source, com, constants, lines)) if com is not None else []
    if len(mass_and_moments) != 7 or len(center) != 3:
        raise FormatError(f"'{source.name}': the inertia of '{name}' depends on parameters")
    numbers = (mass_and_moments[0], *center, *mass_and_moments[1:])
    values = tuple(number.value for number in numbers)
    return WrittenInertia(name, values, numbers)


def _numbers(
    source: _Source, match: re.Match[str], constants: Mapping[str, float], lines: LineIndex
) -> Iterator[WrittenNumber]:
    """Yield the numbers of an assignment, written there or named constants."""
    for word in _WORD.finditer(match[2]):
        start, end = match.start(2) + word.start(), match.start(2) + word.end()
        place = TextPlace(lines.place(start)[0], start, end, source.name)
        if word["number"]:
            yield written_number("".join(word["number"].split()), place)
            continue
        sign, name = word["name"].startswith("-"), word["name"].lstrip("- \n\t\r")
        if name in constants:
            value = -constants[name] if sign else constants[name]
            yield written_number(repr(value), place)


def _transforms(
    text: str, constants: Mapping[str, float]
) -> Iterator[tuple[tuple[str, str], _Transform]]:
    bodies: dict[str, str] = {}
    for method in _METHOD.finditer(text):
        end = text.find("\n}", method.end())
        bodies[method[1]] = bodies.get(method[1], "") + text[method.end() : end]
    for name, body in bodies.items():
        frames = name.split("_X_")
        transform = _transform(body, constants) if len(frames) == 2 else None
        if transform is not None:
            yield (frames[0].removeprefix("fr_"), frames[1].removeprefix("fr_")), transform


def _transform(body: str, constants: Mapping[str, float]) -> _Transform | None:
    """Return a transform, None of one that depends on parameters."""
    locals_ = {name: (function, joint) for name, function, joint in _LOCAL.findall(body)}
    at_zero = {name: (sin if f == "sin" else cos)(0.0) for name, (f, _) in locals_.items()}
    rows = [[float(r == c) for c in range(4)] for r in range(4)]
    used: set[str] = set()
    sliding: set[str] = set()
    for row, column, expression in _ENTRY.findall(body):
        sliding |= set(_JOINT_VALUE.findall(expression))
        used |= {word for word in re.findall(r"\w+", expression) if word in locals_}
        value = _value(expression, {**constants, **at_zero})
        if value is None or int(row) > 3 or int(column) > 3:
            return None
        rows[int(row)][int(column)] = value
    x, y, z = ((row[0], row[1], row[2]) for row in rows[:3])
    pose = RigidPose((x, y, z), (rows[0][3], rows[1][3], rows[2][3]))
    return _Transform(pose, frozenset(locals_[name][1] for name in used), frozenset(sliding))


def _value(expression: str, names: Mapping[str, float]) -> float | None:
    """Return the value of arithmetic on numbers and known names; a joint's value is zero."""
    try:
        value = _of_node(ast.parse(expression.strip(), mode="eval").body, names)
    except (SyntaxError, ValueError, ZeroDivisionError, RecursionError, OverflowError):
        return None
    return value if isfinite(value) else None


def _of_node(node: ast.expr, names: Mapping[str, float]) -> float:
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        return float(node.value)
    if isinstance(node, ast.Name) and node.id in names:
        return names[node.id]
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "q":
        return 0.0
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return -_of_node(node.operand, names)
    if isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
        left, right = _of_node(node.left, names), _of_node(node.right, names)
        return _OPERATORS[type(node.op)](left, right)
    raise ValueError("not arithmetic on known numbers")


def _body(
    index: int,
    links: list[str],
    joints: list[str],
    transforms: Mapping[tuple[str, str], _Transform],
) -> RigidBody:
    """Return a link on what carries it: the only transform to an earlier one with one joint."""
    link = links[index]
    for parent, its_name in enumerate(links[:index]):
        pose = _between(its_name, link, transforms)
        if pose is None:
            continue
        moving = pose.turning | pose.sliding
        if len(moving) == 1:
            (joint,) = moving
            name = next((each for each in joints if each.upper() == joint.upper()), joint)
            kind: JointKind = "prismatic" if pose.sliding else "revolute"
            return RigidBody((), parent, name, kind, pose.zero)
    raise FormatError(f"has no transform between '{link}' and a parent, with numbers alone in it")


def _between(
    parent: str, link: str, transforms: Mapping[tuple[str, str], _Transform]
) -> _Transform | None:
    found = transforms.get((parent, link))
    if found is not None:
        return found
    back = transforms.get((link, parent))
    return None if back is None else back._replace(zero=back.zero.inverse())
