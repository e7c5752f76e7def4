"""Random robots whose legs are mirror images of each other, in link frames that lie anyhow."""

import random
from collections.abc import Mapping
from math import prod

from tests.support.bodies import Writer, inertia_text, random_body, random_rotation

from kindsl.mechanics.rigid.body import MassDistribution, eigensystem, second_moments_about_com
from kindsl.mechanics.rigid.matter import density_of
from kindsl.mechanics.rigid.pose import RigidPose, Vector3, angles

Legs = Mapping[str, tuple[Vector3, float]]

_KEPT, _LEFT_RIGHT, _FORE_HIND, _BOTH = (
    (1.0, 1.0, 1.0), (1.0, -1.0, 1.0), (-1.0, 1.0, 1.0), (-1.0, -1.0, 1.0),
)  # fmt: skip
# What makes the first leg each of the others: a reflection, and how far it is moved along x then.
SIDES: Legs = {"left": (_KEPT, 0.0), "right": (_LEFT_RIGHT, 0.0)}
REFLECTED: Legs = {
    "LF": (_KEPT, 0.0), "RF": (_LEFT_RIGHT, 0.0), "LH": (_FORE_HIND, 0.0), "RH": (_BOTH, 0.0),
}  # fmt: skip
COPIED: Legs = {
    "LF": (_KEPT, 0.0), "RF": (_LEFT_RIGHT, 0.0), "LH": (_KEPT, -0.8), "RH": (_LEFT_RIGHT, -0.8),
}  # fmt: skip
PARTS = ("thigh", "shank")
_SIGNS = [(x, y, z) for x in (1.0, -1.0) for y in (1.0, -1.0) for z in (1.0, -1.0)]


class Walker:
    """A robot with legs of two links.

    Attributes:
        bodies: Inertia by link name, in its link frame.
        signs: What makes coordinates in the first leg's link frame those in the same link's here.
    """

    def __init__(self, generator: random.Random, legs: Legs) -> None:
        self.bodies: dict[str, MassDistribution] = {}
        self.signs: dict[str, Vector3] = {}
        self._legs = list(legs)
        self._poses: dict[str, RigidPose] = {}
        first = [(_random_pose(generator), _random_body(generator)) for _ in PARTS]
        for leg, (reflection, moved) in legs.items():
            for part, (pose, body) in zip(PARTS, first, strict=True):
                # Reversed axes that keep the frame right-handed.
                signs = generator.choice([s for s in _SIGNS if prod(s) == prod(reflection)])
                name = f"{leg}_{part}"
                self.signs[name] = signs if leg != self._legs[0] else reflection
                self._poses[name] = _placed(pose, reflection, self.signs[name], moved)
                self.bodies[name] = reflected(body, self.signs[name])

    def document(self, bodies: Mapping[str, MassDistribution], write: Writer) -> str:
        """Return the robot with these inertias, written so."""
        hips = " ".join(f"{leg}_thigh via {leg}_hip" for leg in self._legs)
        text = f"Robot Walker {{\nRobotBase trunk {{ children {{ {hips} }} }}\n"
        joints = ""
        for number, name in enumerate(self.bodies, 1):
            leg, part = name.split("_")
            knee = f"{leg}_shank via {leg}_knee" if part == "thigh" else ""
            inertia = inertia_text(bodies[name], write)
            text += f"link {name} {{ id = {number} {inertia} children {{ {knee} }} }}\n"
            pose = self._poses[name]
            if part == "shank":
                pose = self._poses[f"{leg}_thigh"].inverse().then(pose)
            joints += _joint(f"{leg}_{'hip' if part == 'thigh' else 'knee'}", pose)
        return f"{text}{joints}}}\n"


def reflected(body: MassDistribution, signs: Vector3) -> MassDistribution:
    """Return a body with the axes reversed whose signs are negative."""
    a, b, c = signs
    (x, y, z), (ix, iy, iz, ixy, ixz, iyz) = body.com, body.moments
    products = (a * b * ixy, a * c * ixz, b * c * iyz)
    return MassDistribution(body.mass, (a * x, b * y, c * z), (ix, iy, iz, *products))


def _random_pose(generator: random.Random) -> RigidPose:
    x, y, z = (tuple(row) for row in random_rotation(generator))
    place = tuple(generator.uniform(0.1, 0.5) for _ in range(3))
    return RigidPose((x, y, z), place)  # type: ignore[arg-type]


def _random_body(generator: random.Random) -> MassDistribution:
    """Return a body of plastic to steel."""
    body = random_body(generator, generator.choice(("block", "slender", "flat")))
    factor = 10.0 ** generator.uniform(3.0, 3.9) / density_of(
        body.mass, eigensystem(second_moments_about_com(body))
    )
    moments = tuple(factor * moment for moment in body.moments)
    return MassDistribution(factor * body.mass, body.com, moments)  # type: ignore[arg-type]


def _placed(pose: RigidPose, reflection: Vector3, signs: Vector3, moved: float) -> RigidPose:
    rows = zip(reflection, pose.rotation, strict=True)
    rotation = [tuple(r * x * s for x, s in zip(row, signs, strict=True)) for r, row in rows]
    x, y, z = (r * x for r, x in zip(reflection, pose.translation, strict=True))
    return RigidPose((rotation[0], rotation[1], rotation[2]), (x + moved, y, z))  # type: ignore[arg-type]


def _joint(name: str, pose: RigidPose) -> str:
    place, turns = (
        ", ".join(f"{x + 0.0:.9f}" for x in vector)
        for vector in (pose.translation, angles(pose.rotation, 1e-9))
    )
    return f"r_joint {name} {{ ref_frame {{ translation = ({place}) rotation = ({turns}) }} }}\n"
