"""Limits and friction of a joint in SDF, both ways."""

from typing import Any
from xml.etree.ElementTree import Element

from kindsl.language.semantics.parameters import JointProperties
from kindsl.robots.interchange.sdf.elements import number_of
from kindsl.robots.interchange.xml_writing import added, numbers

# SDFormat's own defaults, which say that there is no limit.
_ENDLESS = 1e16
_UNLIMITED = -1.0
_LIMIT = ("lower", "upper", "effort", "velocity")
_DYNAMICS = ("damping", "friction")


def joint_properties(joint: Any) -> JointProperties:
    """Return what the axis of a joint element tells."""
    limit, dynamics = joint.find("axis/limit"), joint.find("axis/dynamics")
    lower, upper, effort, velocity = (_number(limit, tag) for tag in _LIMIT)
    damping, friction = (_number(dynamics, tag) for tag in _DYNAMICS)
    return JointProperties(
        lower if lower is not None and lower > -_ENDLESS else None,
        upper if upper is not None and upper < _ENDLESS else None,
        _amount(effort),
        _amount(velocity),
        damping=damping,
        friction=friction,
    )


def add_properties(axis: Element, own: JointProperties) -> None:
    """Add what is known of a joint to its axis."""
    limits = (*own.limits, own.effort, own.velocity)
    _add(axis, "limit", dict(zip(_LIMIT, limits, strict=True)))
    _add(axis, "dynamics", dict(zip(_DYNAMICS, (own.damping, own.friction), strict=True)))


def _number(element: Any, tag: str) -> float | None:
    """Return the number of a child, None of an infinite one, which SDFormat takes for none."""
    text = None if element is None else element.findtext(tag)
    is_endless = text is None or text.strip().lstrip("+-").lower() in ("inf", "infinity")
    return None if is_endless else number_of(element, tag, 0.0)


def _amount(value: float | None) -> float | None:
    """Return an effort or a speed; a negative one means none, and so does the default."""
    return value if value is not None and _UNLIMITED < value < _ENDLESS else None


def _add(axis: Element, tag: str, values: dict[str, float | None]) -> None:
    known = {name: value for name, value in values.items() if value is not None}
    if known:
        parent = added(axis, tag)
        for name, value in known.items():
            added(parent, name).text = numbers([value])
