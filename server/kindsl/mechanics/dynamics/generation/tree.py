"""A mechanism as nested lists of floats, prepared for tracing."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.generation.mass_moments import (
    MassMoments,
    carried_by_predecessor,
    without,
)
from kindsl.mechanics.dynamics.generation.terms import Scalar, cosine_and_sine, sign
from kindsl.mechanics.dynamics.generation.vectors import (
    EYE,
    ZERO,
    Matrix,
    Vector,
    add,
    cross,
    scale,
    transform,
)
from kindsl.mechanics.rigid.joint_kind import JointKind
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.inertia import second_moment

# A turn by pi/2 leaves cosines of about 1e-16, which would be carried through all the code.
ROUNDING = 1e-15


@dataclass(frozen=True, slots=True)
class TreeDrives:
    """Rotors and friction of the joints, by body less one; see `dynamics.bodies.Drives`."""

    armature: list[float]
    damping: list[float]
    friction: list[float]

    def force(self, qd: Vector, qdd: Vector) -> Vector:
        """Return the joint forces that they take of a motion."""
        own = zip(self.armature, self.damping, self.friction, qd, qdd, strict=True)
        return [
            rotor * rate_of_rate + viscous * rate + (coulomb * sign(rate) if coulomb else 0.0)
            for rotor, viscous, coulomb, rate, rate_of_rate in own
        ]


@dataclass(frozen=True, slots=True)
class Tree:
    """The tree as the traced algorithms see it; all lists by body index, base first.

    Attributes:
        parents: Body index of the parent; 0 for the base itself.
        kinds: Kind of the supporting joint; `"revolute"` for the base, which has none.
        rotations: `p_R_j`, entries within rounding of 0, 1 and -1 made exact.
        positions: `p_r_j`, metres.
        masses: Moments of mass, moved towards the base as far as forces stay the same.
        is_floating: Whether the base is free.
        drives: Rotors and friction of the joints, None where nothing is known of them.
    """

    parents: list[int]
    kinds: list[JointKind]
    rotations: list[Matrix]
    positions: list[Vector]
    masses: list[MassMoments]
    is_floating: bool
    drives: TreeDrives | None = None

    def links(self) -> range:
        """Return the links' body indices, parents first."""
        return range(1, len(self.parents))

    def links_leaves_first(self) -> range:
        """Return the links' body indices, children first."""
        return range(len(self.parents) - 1, 0, -1)


def tree_of(bodies: Bodies) -> Tree:
    """Prepare a mechanism for tracing."""
    parents: list[int] = [0, *bodies.parents]
    kinds: list[JointKind] = ["revolute", *bodies.joint_kinds]
    rotations: list[Matrix] = [EYE, *_snapped(bodies.p_R_j).tolist()]
    positions: list[Vector] = [ZERO, *bodies.p_r_j.tolist()]
    masses = masses_near_base(kinds, parents, rotations, positions, mass_distributions(bodies))
    drives = None
    if (own := bodies.drives) is not None:
        drives = TreeDrives(own.armature.tolist(), own.damping.tolist(), own.friction.tolist())
    return Tree(parents, kinds, rotations, positions, masses, bodies.is_floating, drives)


class Wrench(NamedTuple):
    """A moment about a body's origin, and a force, in the body's coordinates."""

    moment: Vector
    force: Vector


class JointMotion:
    """Moves vectors across the supporting joint of one link: (p)arent and (i) the link.

    Attributes:
        kind: The joint's kind.
        offset: The link's origin in the parent, `p_r_i`.
    """

    __slots__ = ("_R", "_cosine", "_sine", "kind", "offset")

    def __init__(self, tree: Tree, body: int, q: Scalar) -> None:
        self.kind = tree.kinds[body]
        self._R = tree.rotations[body]
        self.offset = tree.positions[body]
        self._cosine: Scalar = 1.0
        self._sine: Scalar = 0.0
        if self.kind == "prismatic":
            self.offset = add(self.offset, scale(q, [row[2] for row in self._R]))
        else:
            self._cosine, self._sine = cosine_and_sine(q)

    def to_link(self, v: Vector) -> Vector:
        """Rotate the parent's coordinates of a vector to the link's."""
        x, y, z = transform([list(column) for column in zip(*self._R, strict=True)], v)
        return [self._cosine * x + self._sine * y, self._cosine * y - self._sine * x, z]

    def to_parent(self, v: Vector) -> Vector:
        """Rotate the link's coordinates of a vector to the parent's."""
        x, y, z = v
        turned = [self._cosine * x - self._sine * y, self._sine * x + self._cosine * y, z]
        return transform(self._R, turned)

    def wrench_in_parent(self, wrench: Wrench) -> Wrench:
        """Return a wrench on the link about the parent's origin, in the parent's coordinates."""
        force = self.to_parent(wrench.force)
        return Wrench(add(self.to_parent(wrench.moment), cross(self.offset, force)), force)

    def along(self, wrench: Wrench) -> Scalar:
        """Return the force that a wrench on the link is along the joint."""
        return wrench.moment[2] if self.kind == "revolute" else wrench.force[2]

    def mass_in_parent(self, body: MassMoments) -> MassMoments:
        """Express a mass distribution, given in the link, in the parent."""
        turned = body.rotated_about_z(self._cosine, self._sine)
        return turned.rotated(self._R).displaced(self.offset)

    def symmetric_in_parent(self, M: Matrix) -> Matrix:
        """Rotate the link's coordinates of a symmetric matrix to the parent's."""
        turned = MassMoments(M, ZERO, 0.0).rotated_about_z(self._cosine, self._sine)
        return turned.rotated(self._R).second

    def rotation_in(self, base_R_p: Matrix) -> Matrix:
        """Return `base_R_i` from the parent's `base_R_p`."""
        rows = [transform([list(c) for c in zip(*self._R, strict=True)], row) for row in base_R_p]
        c, s = self._cosine, self._sine
        return [[c * x + s * y, c * y - s * x, z] for x, y, z in rows]


def joint_motions(tree: Tree, q: Vector) -> list[JointMotion]:
    """Return the motion across each supporting joint, by body; the base's is not to be used."""
    links = [JointMotion(tree, i, q[i - 1]) for i in tree.links()]
    return [links[0], *links]


def mass_distributions(bodies: Bodies) -> list[MassMoments]:
    """Return each body's moments of mass about its own origin, base first."""
    firsts = bodies.masses[:, None] * bodies.coms
    rows = zip(second_moment(bodies.inertias), firsts, bodies.masses, strict=True)
    return [
        MassMoments(second.tolist(), first.tolist(), float(mass)) for second, first, mass in rows
    ]


def masses_near_base(
    kinds: list[JointKind],
    parents: list[int],
    rotations: list[Matrix],
    positions: list[Vector],
    bodies: list[MassMoments],
) -> list[MassMoments]:
    """Return bodies that take the same forces, with all that can moved towards the base.

    All lists are by body, base first; see `Tree`.
    """
    masses = list(bodies)
    for i in range(len(parents) - 1, 0, -1):
        part = carried_by_predecessor(kinds[i], masses[i])
        masses[i] = _without_rounding(without(masses[i], part))
        masses[parents[i]] += part.rotated(rotations[i]).displaced(positions[i])
    return masses


def _without_rounding(body: MassMoments) -> MassMoments:
    """Return a body without the constants that only rounding left."""
    second, (first,) = _cleared(body.second), _cleared([body.first])
    return MassMoments(second, first, body.mass)


def _cleared(rows: Matrix) -> Matrix:
    constants = [abs(x) for row in rows for x in row if isinstance(x, float)]
    least = ROUNDING * max(constants, default=0.0)
    return [[0.0 if isinstance(x, float) and abs(x) < least else x for x in row] for row in rows]


def _snapped(rotations: Array) -> Array:
    nearest = np.rint(rotations)
    return np.where(abs(rotations - nearest) < ROUNDING, nearest, rotations)
