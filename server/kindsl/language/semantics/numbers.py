"""Written values as numbers: poses, vectors and bodies at given values of the parameters.

What comes from an island without parameters and constants is computed once in the island's life.
"""

from math import isfinite

from kindsl.language.semantics.declarations import FixedAxes, Frame, Inertia, Link, Pose, Vector
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.parameters import island_symbols
from kindsl.language.syntax.tree import Island
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.facts import Fact
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose, Vector3, pose_from, pose_from_fixed_axes

POSES = Fact[dict[Vector, RigidPose]]("poses")
BODIES = Fact[dict[Inertia, MassDistribution]]("mass distributions")


def written_pose(pose: Pose, values: Values) -> RigidPose | None:
    """Return a pose in numbers, None where one is missing, unbound or infinite."""
    if pose.translation is None or pose.rotation is None:
        return None
    island = pose.translation.island
    known = island.facts.get(POSES)
    if known is not None and pose.translation in known:
        return known[pose.translation]
    translation, angles = triple(pose.translation, values), triple(pose.rotation, values)
    if translation is None or angles is None:
        return None
    is_fixed = isinstance(pose.rotation, FixedAxes)
    written = (pose_from_fixed_axes if is_fixed else pose_from)(translation, angles)
    if _is_literal(island):
        (known or island.facts.keep(POSES, {}))[pose.translation] = written
    return written


def frame_of_com(link: Link) -> Frame | None:
    """Return the frame that an inertia brings along, as in XML: its origin is the CoM.

    None where CoM and moments are in the link's frame, or in one of its named ones.
    """
    inertia = link.inertia
    return next((f for f in link.frames if inertia and f.node is inertia.node), None)


def pose_of_com(link: Link, values: Values) -> RigidPose | None:
    """Return the pose of that frame in its link's, None where there is none that is known."""
    frame = frame_of_com(link)
    return None if frame is None else written_pose(frame.pose, values)


def mass_distribution(inertia: Inertia, values: Values) -> MassDistribution | None:
    """Return the numbers of an inertia, None where one is missing, unbound or infinite."""
    island = inertia.island
    known = island.facts.get(BODIES)
    if known is not None and inertia in known:
        return known[inertia]
    mass = inertia.mass.value(values) if inertia.mass is not None else None
    com = triple(inertia.com, values)
    given = inertia.moments
    moments = tuple([given[name].value(values) for name in MOMENTS if name in given])
    if mass is None or com is None or None in moments or len(moments) != len(MOMENTS):
        return None
    if not all(map(isfinite, (mass, *moments))):  # type: ignore[arg-type]
        return None
    written = MassDistribution(mass, com, moments)  # type: ignore[arg-type]
    if _is_literal(island):
        (known or island.facts.keep(BODIES, {}))[inertia] = written
    return written


def triple(vector: Vector | None, values: Values) -> Vector3 | None:
    """Return three components as written, None where one is missing, unbound or infinite."""
    if vector is None:
        return None
    first, second, third = vector.components
    x, y, z = first.value(values), second.value(values), third.value(values)
    if x is None or y is None or z is None or not all(map(isfinite, (x, y, z))):
        return None
    return x, y, z


def _is_literal(island: Island) -> bool:
    """Return whether an island has the same numbers whatever the parameters' values are."""
    return not any(island_symbols(island))
