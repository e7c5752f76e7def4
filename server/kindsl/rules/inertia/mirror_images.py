"""Inertias of a left and a right part that are nearly mirror images."""

from kindsl.rules.inertia.surroundings import SIGNS
from kindsl.semantics.declarations import Inertia, Link
from kindsl.syntax.vocabulary import MOMENTS

_NAMES = ("mass", "x of the CoM", "y of the CoM", "z of the CoM", *MOMENTS)
_SIGNIFICANT = 0.05
_MOST_DIFFERENCES = 2


def mirror_difference(left: Link, right: Link) -> str:
    """Return how an inertia is not the mirror image of its twin's, nothing if it is, or unlike."""
    here, there = _numbers(left.inertia), _numbers(right.inertia)
    if len(here) != 10 or len(there) != 10:
        return ""
    mass, com, moment = _greatest(here, there)
    sizes = enumerate([mass, *[com] * 3, *[moment] * 6])
    differing = [i for i, size in sizes if _differs(abs(here[i]), abs(there[i]), size)]
    exact = sum(abs(a) == abs(b) for a, b in zip(here, there, strict=True))
    if 0 < len(differing) <= _MOST_DIFFERENCES and exact + len(differing) == 10:
        told = (f"{_NAMES[i]} is {there[i]:g} against {here[i]:g}" for i in differing)
        return f"'{right.name}' is not the mirror image of '{left.name}': {', '.join(told)}"
    if exact == 10 and not _is_reflected(here, there, com, moment):
        return f"signs of '{right.name}' do not match a mirror image of '{left.name}'"
    return ""


def _numbers(inertia: Inertia | None) -> list[float]:
    """Return mass, CoM and moments, fewer than ten where one is missing or no plain number."""
    if inertia is None:
        return []
    com = inertia.com.components if inertia.com is not None else ()
    moments = (inertia.moments.get(name) for name in MOMENTS)
    values = (inertia.mass, *com, *moments)
    return [v.literal for v in values if v is not None and v.literal is not None]


def _greatest(here: list[float], there: list[float]) -> tuple[float, float, float]:
    """Return the greatest number of each kind: mass, centre of mass, moments."""
    com = max(map(abs, here[1:4] + there[1:4]))
    moment = max(map(abs, here[4:] + there[4:]))
    return max(here[0], there[0]), com, moment


def _differs(left: float, right: float, size: float) -> bool:
    return abs(left - right) > _SIGNIFICANT * size


def _is_reflected(here: list[float], there: list[float], com: float, moment: float) -> bool:
    """Return whether axes turned round by some signs make one inertia the other."""
    signed = [*there[1:4], *there[7:]]
    sizes = [com] * 3 + [moment] * 3
    return any(not any(map(_differs, signed, _reflected(here, *signs), sizes)) for signs in SIGNS)


def _reflected(numbers: list[float], x: float, y: float, z: float) -> list[float]:
    """Return the centre of mass and the products of inertia with axes turned round by signs."""
    _, cx, cy, cz, _, _, _, ixy, ixz, iyz = numbers
    return [x * cx, y * cy, z * cz, x * y * ixy, x * z * ixz, y * z * iyz]
