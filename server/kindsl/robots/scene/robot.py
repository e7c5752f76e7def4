"""The drawing of a mechanism, as pure data: messages by key.

Marks (joints, frames, centres of mass, bodies' thickness) have the unit size that the `model`
message tells, so another size of robot changes one message. Bodies hang under their link's node,
joints' marks under their joint's, and the page places these nodes by forward kinematics.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache

from kindsl.language.semantics.parameters import JointProperties
from kindsl.mechanics.rigid.pose import Vector3
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.scene.ellipsoids import InertiaEllipsoid, inertia_ellipsoid
from kindsl.robots.scene.guesses import NO_GUESSES, Guesses
from kindsl.robots.scene.marks import (
    FRAME,
    ROBOT_BALL,
    SLAB,
    body_marks,
    column_major,
    joint_marks,
    mark,
    mass_marks,
)
from kindsl.robots.scene.messages import (
    Core,
    FrameMessage,
    JointMessage,
    LimitsMessage,
    LinkMessage,
    ModelMessage,
    Part,
    SolidMessage,
    path_of,
)
from kindsl.robots.scene.size import Extent, Segment, extent
from kindsl.robots.scene.solids import (
    NO_DOUBTS,
    Doubts,
    LinkSolid,
    known_masses,
    link_solids,
    usual_density,
)

# What is the same at each keystroke is made once.
_MOST_KNOWN = 1 << 12
NO_LIMITS: Mapping[str, JointProperties] = {}
NOTHING_UNKNOWN: Mapping[str, str] = {}


def robot_messages(
    name: str,
    skeleton: Linkage,
    guessed: Guesses = NO_GUESSES,
    limits: Mapping[str, JointProperties] = NO_LIMITS,
    unknown: Mapping[str, str] = NOTHING_UNKNOWN,
) -> list[Part]:
    """Return what is drawn of a mechanism but its solids, and the numbers the page places it by.

    Args:
        name: The robot's.
        skeleton: Its bodies.
        guessed: Which places are guesses.
        limits: How far joints go, by name.
        unknown: Why the mass distributions of some bodies are not known, by the bodies' names.
    """
    size = extent(skeleton)
    ellipsoids = [inertia_ellipsoid(body) for body in skeleton.masses]
    messages: list[Part] = [_model(name, skeleton, size, unknown)]
    messages.extend(_numbers("robot", skeleton, size, ellipsoids, guessed, unknown))
    messages.extend(_limits(skeleton, limits))
    messages.extend(_robot_marks(skeleton, size, ellipsoids))
    return messages


def solid_messages(
    skeleton: Linkage, doubts: Doubts = NO_DOUBTS, unknown: Mapping[str, str] = NOTHING_UNKNOWN
) -> list[Part]:
    """Return the bodies of a mechanism."""
    return list(_solids("robot", skeleton, extent(skeleton), doubts, unknown))


def ghost_messages(skeleton: Linkage) -> list[Part]:
    """Return the bodies of a former version, to stand behind the present one."""
    size = extent(skeleton)
    ellipsoids = [inertia_ellipsoid(body) for body in skeleton.masses]
    nothing = NO_GUESSES, NOTHING_UNKNOWN
    messages: list[Part] = list(_numbers("ghost", skeleton, size, ellipsoids, *nothing))
    messages.extend(_solids("ghost", skeleton, size, NO_DOUBTS, NOTHING_UNKNOWN))
    for link, segments in zip(skeleton.body_names, size.segments, strict=True):
        messages.extend(body_marks("ghost", link, segments, "body"))
    return messages


def _model(name: str, skeleton: Linkage, size: Extent, unknown: Mapping[str, str]) -> ModelMessage:
    return ModelMessage(
        name=name,
        is_floating=skeleton.is_floating,
        size=size.size,
        center=size.center,
        ground=size.ground,
        unit=size.radius,
        density=usual_density(known_masses(skeleton, unknown)),
    )


def _robot_marks(
    skeleton: Linkage, size: Extent, ellipsoids: Sequence[InertiaEllipsoid]
) -> Iterator[Part]:
    for body, link in enumerate(skeleton.body_names):
        yield from body_marks("robot", link, size.segments[body], "body" if body else "base")
        yield mark(FRAME, "links", link, "link-frame", "triad")
        # A fixed base's inertia does not matter.
        if body or skeleton.is_floating:
            yield from mass_marks(link, skeleton.masses[body].com, ellipsoids[body])
    if not skeleton.is_floating:
        yield mark(SLAB, "links", skeleton.base_name, "base", "slab")
    for joint, kind in zip(skeleton.joint_names, skeleton.joint_kinds, strict=True):
        yield from joint_marks(joint, kind)
    for frame in skeleton.frames:
        yield mark(FRAME, "frames", frame.name, "optional-frame", "triad")
    # The page places it.
    yield mark(ROBOT_BALL, "total", "robot", "robot-com", "ball")


def _numbers(
    tree: str,
    skeleton: Linkage,
    size: Extent,
    ellipsoids: Sequence[InertiaEllipsoid],
    guessed: Guesses,
    unknown: Mapping[str, str],
) -> Iterator[Part]:
    """Yield what the page needs for kinematics, gravity torques and its panel."""
    joints = ("", *skeleton.joint_names)
    for body, name in enumerate(skeleton.body_names):
        is_at_rest = body == 0 and not skeleton.is_floating
        yield LinkMessage(
            path=path_of(tree, "links", name),
            name=name,
            index=body,
            joint=joints[body],
            mass=skeleton.masses[body].mass,
            com=skeleton.masses[body].com,
            inertia=ellipsoids[body].about_com,
            is_consistent=is_at_rest or ellipsoids[body].is_consistent,
            lacks=unknown.get(name, ""),
            anchor=_anchor(size.segments[body]),
            ends=tuple(segment.end for segment in size.segments[body]),
        )
    yield from _joints(tree, skeleton, guessed)
    yield from _frames(tree, skeleton, guessed)


def _solids(
    tree: str, skeleton: Linkage, size: Extent, doubts: Doubts, unknown: Mapping[str, str]
) -> Iterator[Part]:
    solids = link_solids(skeleton, size, doubts, unknown)
    for name, solid, segments in zip(skeleton.body_names, solids, size.segments, strict=True):
        yield _solid(path_of(tree, "links", name, "solid"), name, solid, segments)


@lru_cache(maxsize=_MOST_KNOWN)
def _solid(path: str, name: str, own: LinkSolid, segments: tuple[Segment, ...]) -> SolidMessage:
    core = own.core
    return SolidMessage(
        path=path,
        name=name,
        core=core
        and Core(
            center=core.center,
            axes=tuple(number for axis in core.axes for number in axis),
            semi_axes=core.semi_axes,
            gyration=core.gyration,
            exponents=core.exponents,
            density=core.density,
            shell=own.shell,
        ),
        look=own.look,
        doubts=own.doubts,
        is_oversized=own.is_oversized,
        bones=segments,
        radius=own.bone,
        strut=own.strut,
        drum=own.drum,
        is_shaded=own.is_shaded,
    )


def _joints(tree: str, skeleton: Linkage, guessed: Guesses) -> Iterator[Part]:
    names = skeleton.body_names
    for link, parent in skeleton.links():
        name = skeleton.joint_names[link - 1]
        yield JointMessage(
            path=path_of(tree, "joints", name),
            name=name,
            index=link,
            kind=skeleton.joint_kinds[link - 1],
            predecessor=names[parent],
            successor=names[link],
            placement=column_major(skeleton.placements[link - 1]),
            is_guess=name in guessed.joints,
        )


def _limits(skeleton: Linkage, limits: Mapping[str, JointProperties]) -> Iterator[Part]:
    for name in skeleton.joint_names:
        if name in limits:
            own = limits[name]
            yield LimitsMessage(path_of("limits", name), name, own.minimum, own.maximum)


def _frames(tree: str, skeleton: Linkage, guessed: Guesses) -> Iterator[Part]:
    for frame in skeleton.frames:
        yield FrameMessage(
            path=path_of(tree, "frames", frame.name),
            name=frame.name,
            link=skeleton.body_names[frame.body],
            placement=column_major(frame.pose),
            is_guess=frame.name in guessed.frames,
        )


def _anchor(segments: tuple[Segment, ...]) -> Vector3:
    """Return where a link's name stands: half way along its segments."""
    ends = [segment.end for segment in segments]
    share = 0.5 / len(ends) if ends else 0.0
    x, y, z = (share * sum(end[axis] for end in ends) for axis in range(3))
    return x, y, z
