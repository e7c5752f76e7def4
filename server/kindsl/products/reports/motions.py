"""Configurations of a robot from plain data, as `kindsl compute` and editors give them."""

import sys
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from kindsl.language.text.nearest import hint, nearest_name
from kindsl.language.text.phrases import counted

JOINT_KEYS = ("q", "qd", "qdd", "tau")
BASE_KEY = "base_velocity"
KEYS = (*JOINT_KEYS, BASE_KEY)


class MotionError(ValueError):
    """A configuration is of the wrong length, or not made of numbers."""


class Motion(NamedTuple):
    """One configuration: positions, velocities, accelerations and forces of the joints.

    The velocity of a floating base has its angular part first.
    """

    q: tuple[float, ...]
    qd: tuple[float, ...]
    qdd: tuple[float, ...]
    tau: tuple[float, ...]
    base_velocity: tuple[float, ...]


class ConfigurationSpace(NamedTuple):
    """The space that configurations have to fit."""

    joints: Sequence[str]
    is_floating: bool


def motions_from(content: object, robot: ConfigurationSpace, where: str = "") -> list[Motion]:
    """Return the configurations of an object with `q`, `qd`, ..., or of an array of them.

    Args:
        content: As `json` reads it. A list has one number a joint, an object joints by name.
        robot: The robot that they have to fit.
        where: Name of the origin in messages.

    Raises:
        MotionError: One does not fit, or there is none.
    """
    prefix = f"{where}: " if where else ""
    if not isinstance(content, list):
        return [_entry(prefix, content, robot)]
    if not content:
        raise MotionError(f"{prefix}no configuration is given")
    return [
        _entry(f"{prefix}configuration {number}: ", entry, robot)
        for number, entry in enumerate(content, 1)
    ]


def motion(given: Mapping[str, Any], robot: ConfigurationSpace, names: Mapping[str, str]) -> Motion:
    """Return one configuration; what is not given is zero.

    Raises:
        MotionError: It does not fit.
    """
    base = given.get(BASE_KEY)
    if base is not None and not robot.is_floating:
        raise MotionError(f"{names[BASE_KEY]} is given, but the base is fixed")
    joints = [_joint_values(names[key], given.get(key), robot.joints) for key in JOINT_KEYS]
    velocity = (0.0,) * 6 if base is None else _numbers(names[BASE_KEY], base)
    if len(velocity) != 6:
        has = f"has {counted(len(velocity), 'number')}, the base's velocity has 6"
        raise MotionError(f"{names[BASE_KEY]} {has}")
    return Motion(joints[0], joints[1], joints[2], joints[3], velocity)


def _entry(prefix: str, entry: object, robot: ConfigurationSpace) -> Motion:
    if not isinstance(entry, dict):
        raise MotionError(f"{prefix}must be an object with 'q', not {_kind(entry)}")
    for key in entry:
        if key not in KEYS:
            raise MotionError(f"{prefix}unknown key '{key}' (known: {', '.join(KEYS)})")
    return motion(entry, robot, {key: f"{prefix}'{key}'" for key in KEYS})


def _joint_values(name: str, value: object, joints: Sequence[str]) -> tuple[float, ...]:
    if value is None:
        return (0.0,) * len(joints)
    if isinstance(value, dict):
        for joint in value:
            if joint not in joints:
                near = hint(nearest_name(joint, joints), after=",")
                raise MotionError(f"{name}: there is no joint '{joint}'{near}")
        numbers = dict(zip(value, _numbers(name, list(value.values())), strict=True))
        return tuple(numbers.get(joint, 0.0) for joint in joints)
    found = _numbers(name, value)
    if len(found) != len(joints):
        has = f"has {counted(len(found), 'number')}, the robot has {counted(len(joints), 'joint')}"
        raise MotionError(f"{name} {has}: {', '.join(joints)}")
    return found


def _numbers(name: str, value: object) -> tuple[float, ...]:
    if not isinstance(value, list):
        raise MotionError(f"{name} must be a list of numbers, not {_kind(value)}")
    for entry in value:
        if isinstance(entry, bool) or not isinstance(entry, int | float):
            raise MotionError(f"{name} holds {_kind(entry)}, not only numbers")
        if not abs(entry) <= sys.float_info.max:
            raise MotionError(f"{name} holds a number that is not finite")
    return tuple(float(entry) for entry in value)


def _kind(value: object) -> str:
    kinds = {dict: "an object", list: "a list", str: "a string", bool: "a boolean",
             type(None): "null", int: "a number", float: "a number"}  # fmt: skip
    return kinds[type(value)]
