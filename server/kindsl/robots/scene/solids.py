"""Links drawn as bodies: the uniform solid with the inertia, and bones to the joints."""

import math
from collections.abc import Collection, Mapping, Sequence
from functools import lru_cache
from statistics import median
from typing import Annotated, Literal, NamedTuple, TypeAlias

from kindsl.mechanics.rigid.body import NO_BODY, MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose, Vector3, dot, minus, nearest_on_way
from kindsl.mechanics.rigid.solid import Solid, equivalent_solid
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.scene.size import Extent, Segment

# How a solid stands to what is plausible. Of glass is what would hide the robot.
Look: TypeAlias = Literal["sound", "glass", "doubtful", "impossible"]

WATER = 1000.0  # kg/m^3, where no link says better
USUAL = (300.0, 3000.0)
LIGHTEST, DENSEST = 50.0, 20_000.0
# Densities go in steps, so that an edit of one mass does not make all bones breathe.
STEP = 1.1
LIGHT = 0.08  # of the robot's own density
PLACEHOLDER = 1e-3  # of the robot's mass
BONE = 0.6  # of the radius that the mass would fill
BENEATH = 0.85  # of a body's least semi-axis: a bone in it stays beneath its surface
THINNEST, THICKEST = 0.55, 4.0  # units
DRUM, MOST_UNLIKE = 1.15, 2.5  # of a bone's radius; of the thinner of two bones'
# Of the robot's size, the longest semi-axis that is drawn unasked, of glass beyond the robot's own.
# Of 1255 plausible bodies of 131 published robots two reach beyond their robot, 1.5 times at most.
LARGEST, LARGEST_DOUBTFUL, LARGEST_IMPOSSIBLE = 2.0, 1.0, 0.5
SUNK = 0.25  # of the robot's size, below the ground
_MOST_KNOWN = 1 << 12


class Doubt(NamedTuple):
    """What the linter says of a body's numbers."""

    code: Annotated[str, "of the rule that reports it"]
    sentence: Annotated[str, "for people"]
    is_error: Annotated[bool, "whether it is an error, else a warning"]


Doubts: TypeAlias = Mapping[str, tuple[Doubt, ...]]
NO_DOUBTS: Doubts = {}


class LinkSolid(NamedTuple):
    """A link as a body; positions are in its frame, lengths in metres.

    Attributes:
        core: Its uniform solid, None where there is none to be drawn.
        look: Its verdict in the picture.
        doubts: The gravest first.
        is_oversized: Whether the core would hide the robot, as a wrong inertia makes it.
        shell: Scale of a shell of the robot's usual density that has the same mass and inertia; 1
            where the core is as dense.
        bone: Radius of the bones to its joints.
        strut: From a bone to the centre of mass where the core touches none, else empty.
        drum: Radius of the supporting joint's drum.
        is_shaded: Whether a shade tells it from its parent.
    """

    core: Solid | None
    look: Look
    doubts: tuple[Doubt, ...]
    is_oversized: bool
    shell: float
    bone: float
    strut: tuple[Vector3, ...]
    drum: float
    is_shaded: bool = False


def link_solids(
    skeleton: Linkage, extent: Extent, doubts: Doubts = NO_DOUBTS, unknown: Collection[str] = ()
) -> list[LinkSolid]:
    """Return the body of each link, the base first.

    Args:
        skeleton: The robot.
        extent: Its measures.
        doubts: What is doubtful about its bodies, by their names, the gravest first.
        unknown: Names of the bodies whose masses or moments are not known.
    """
    masses = known_masses(skeleton, unknown)
    cores = [equivalent_solid(body) for body in masses]
    density = usual_density(masses)
    moving = masses if skeleton.is_floating else masses[1:]
    least = PLACEHOLDER * sum(max(0.0, body.mass) for body in moving)
    alone: list[LinkSolid] = []
    for core, body, segments, name in zip(
        cores, masses, extent.segments, skeleton.body_names, strict=True
    ):
        is_at_rest = not (alone or skeleton.is_floating)
        # The inertia of a placeholder or a fixed base may be anything.
        is_plausible = core and core.is_possible and core.density >= LIGHT * density
        if core and (is_plausible or (body.mass >= least and not is_at_rest)):
            sizes = density, extent.radius, extent.size
            alone.append(_shape(core, body.mass / density, segments, doubts.get(name, ()), *sizes))
        else:
            alone.append(_bare(doubts.get(name, ()), extent.radius))
    return _joined(skeleton, extent, alone)


def known_masses(skeleton: Linkage, unknown: Collection[str]) -> list[MassDistribution]:
    """Return the mass distributions of the base and the links, nothing for those unknown."""
    bodies = zip(skeleton.body_names, skeleton.masses, strict=True)
    return [NO_BODY if name in unknown else body for name, body in bodies]


def usual_density(bodies: Sequence[MassDistribution]) -> float:
    """Return the density that most of a robot's links have, kg/m^3."""
    solids = (equivalent_solid(body) for body in bodies)
    usual = [s.density for s in solids if s and s.is_possible and LIGHTEST < s.density < DENSEST]
    if not usual:
        return WATER
    stepped = float(STEP ** round(math.log(median(usual), STEP)))
    return min(max(stepped, USUAL[0]), USUAL[1])


def _look(doubts: tuple[Doubt, ...]) -> Look:
    has_error = any(doubt.is_error for doubt in doubts)
    return "impossible" if has_error else "doubtful" if doubts else "sound"


def _bare(doubts: tuple[Doubt, ...], unit: float) -> LinkSolid:
    """Return a link that is drawn by its bones alone."""
    return LinkSolid(None, _look(doubts), doubts, False, 1.0, THINNEST * unit, (), unit)


@lru_cache(maxsize=_MOST_KNOWN)
def _shape(
    core: Solid,
    volume: float,
    segments: tuple[Segment, ...],
    doubts: tuple[Doubt, ...],
    density: float,
    unit: float,
    size: float,
) -> LinkSolid:
    ends = [segment.end for segment in segments]
    largest = LARGEST_DOUBTFUL if doubts else LARGEST
    largest = largest if core.is_possible else LARGEST_IMPOSSIBLE
    radius = min(BONE * filling_radius(ends, volume), BENEATH * min(core.semi_axes))
    return LinkSolid(
        core=core,
        look=_look(doubts),
        doubts=doubts,
        is_oversized=core.reach > largest * size,
        shell=shell_factor(core.density / density) if core.is_possible else 1.0,
        bone=min(max(radius, THINNEST * unit), THICKEST * unit),
        strut=_strut(core, ends),
        drum=unit,
    )


def shell_factor(share: float) -> float:
    """Return how much smaller a shell is than the solid with its mass and inertia, as a factor.

    With an inner surface like the outer one, `c` times as large, its second moments are those of
    the solid if it is `f = sqrt((1 - c^3) / (1 - c^5))` times as large, and its mass if `f^3 (1 -
    c^3)` is the solid's density as a share of its own.

    Args:
        share: The density of the solid as a share of the shell's.
    """
    low, high, factor = 0.0, 1.0, 1.0
    for _ in range(30 if share < 1.0 else 0):
        c = 0.5 * (low + high)
        factor = math.sqrt((1.0 - c**3) / (1.0 - c**5))
        low, high = (c, high) if factor**3 * (1.0 - c**3) > share else (low, c)
    return factor


def filling_radius(ends: Sequence[Vector3], volume: float) -> float:
    """Return the radius at which tubes from the origin to some ends and a ball have a volume."""
    length = sum(math.hypot(*end) for end in ends)
    low, high = 0.0, volume ** (1 / 3)
    for _ in range(40):
        middle = 0.5 * (low + high)
        is_more = math.pi * middle**2 * (length + 4 / 3 * middle) > volume
        low, high = (low, middle) if is_more else (middle, high)
    return low


def _strut(core: Solid, ends: Sequence[Vector3]) -> tuple[Vector3, ...]:
    """Return the way from the nearest bone to the centre of mass, empty where they touch."""
    places = [nearest_on_way(core.center, end) for end in ends] or [(0.0, 0.0, 0.0)]
    place = min(places, key=lambda place: math.dist(place, core.center))
    way = minus(place, core.center)
    is_touched = dot(way, core.support(way)) >= dot(way, place)
    return () if is_touched else (place, core.center)


def _joined(skeleton: Linkage, extent: Extent, alone: Sequence[LinkSolid]) -> list[LinkSolid]:
    """Return the bodies with what depends on their parents and on where they stand."""
    parents = (None, *skeleton.parents)
    joined: list[LinkSolid] = []
    for own, parent, pose in zip(alone, parents, skeleton.zero_poses, strict=True):
        is_shaded = parent is not None and not joined[parent].is_shaded
        drum = _drum(own.bone, own.bone if parent is None else alone[parent].bone, extent.radius)
        is_glass = own.look == "sound" and _hides(own, pose, extent)
        look: Look = "glass" if is_glass else own.look
        joined.append(own._replace(look=look, drum=drum, is_shaded=is_shaded))
    return joined


def _drum(own: float, other: float, unit: float) -> float:
    return max(unit, DRUM * min(max(own, other), MOST_UNLIKE * min(own, other)))


def _hides(link: LinkSolid, pose: RigidPose, extent: Extent) -> bool:
    """Return whether a core would hide the robot: larger than it, or well below the ground."""
    core, limit = link.core, extent.ground - SUNK * extent.size
    if core is None:
        return False
    if core.reach > extent.size:
        return True
    if pose.point(core.center)[2] - math.hypot(*core.semi_axes) > limit:
        return False
    x, y, z = pose.rotation[2]
    return pose.point(core.support((-x, -y, -z)))[2] < limit
