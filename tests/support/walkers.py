"""Robots with legs that are copies of each other, with mistakes in their inertias."""

import random
import re

from tests.support.bodies import inertia_text, random_body, significant
from tests.support.examples import joint, link, robot

from kindsl.mechanics.rigid.body import MassDistribution, shifted

LEGS = ("LF", "RF", "LH", "RH")
SLIPS = ("none", "reference", "signs", "unit", "mass", "reference and signs")


def walker(generator: random.Random) -> str:
    """Return a robot with four legs of two links, many of whose inertias are wrong."""
    links, joints, children = [], [], []
    slips = generator.choice((SLIPS, SLIPS, ("reference",), ("unit",)))
    for part in ("hip", "shank"):
        body = random_body(generator)
        for number, leg in enumerate(LEGS, 1 if part == "hip" else 5):
            section = inertia_text(planted(generator, body, slips), significant(4))
            if leg == "RH" and slips is SLIPS:
                section = re.sub(r"mass = \S+", "mass = load", section)
            below = f"{leg}_shank via {leg}_knee" if part == "hip" else ""
            links.append(link(f"{leg}_{part}", number, below, section))
    for leg in LEGS:
        joints += [joint(f"{leg}_top"), joint(f"{leg}_knee", generator.choice((0.2, 0.3)))]
        children.append(f"{leg}_hip via {leg}_top")
    return robot(*links, *joints, base=" ".join(children))


def planted(
    generator: random.Random, body: MassDistribution, slips: tuple[str, ...]
) -> MassDistribution:
    """Return a leg's body on some side, with a mistake in it."""
    (x, y, z), (ix, iy, iz, ixy, ixz, iyz) = body.com, body.moments
    side, slip = generator.choice((1.0, -1.0)), generator.choice(slips)
    body = body._replace(com=(x, side * y, z), moments=(ix, iy, iz, side * ixy, ixz, side * iyz))
    if "reference" in slip:
        body = shifted(body, -1.0)
    sign, unit = -1.0 if "signs" in slip else 1.0, 1e7 if slip == "unit" else 1.0
    plain, products = body.moments[:3], body.moments[3:]
    moments = (*(unit * m for m in plain), *(sign * unit * p for p in products))
    return MassDistribution((1000.0 if slip == "mass" else 1.0) * body.mass, body.com, moments)
