"""Inertias of a left and a right part that are nearly mirror images."""

from kindsl.limbs.mounts import REFLECTIONS
from kindsl.limbs.weighing import seen_by
from kindsl.rigid.body import MassDistribution
from kindsl.rules.inertia.judgements import TEN
from kindsl.semantics.declarations import Inertia, Link
from kindsl.syntax.vocabulary import MOMENTS

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
        told = (f"{TEN[i]} is {there[i]:g} against {here[i]:g}" for i in differing)
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
    (mass, x, y, z, xx, yy, zz, xy, xz, yz), sizes = here, [com] * 3 + [moment] * 3
    body = MassDistribution(mass, (x, y, z), (xx, yy, zz, xy, xz, yz))
    seen = (seen_by(body, C) for C in REFLECTIONS)
    signed = [*there[1:4], *there[7:]]
    return any(not any(map(_differs, signed, (*b.com, *b.moments[3:]), sizes)) for b in seen)
