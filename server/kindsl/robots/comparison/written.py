"""A robot as its file writes it: numbers with their places, and the forms that they are written in.

Two files may write one body about other points and along other axes. A form tells which numbers a
file would have to write for a given body or pose, so that numbers are compared with numbers.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import atan2, pi, remainder
from typing import NamedTuple

from kindsl.language.semantics.places import Located
from kindsl.mechanics.rigid.body import MassDistribution, seen_from, shifted
from kindsl.mechanics.rigid.pose import (
    IDENTITY,
    ORIGIN,
    RigidPose,
    Rotation,
    Vector3,
    angles,
    pose_from,
    pose_from_fixed_axes,
    product,
    round_angle,
    transposed,
)

_GIMBAL = 1e-9
# No number is taken to be less exact than this, however few its digits, nor more exact than a
# float, in which some programs write.
_CAP = 1e-4
_FLOAT = 2e-7


class TextPlace(NamedTuple):
    """The place of a number in a file that is no document of ours; offsets in code points.

    Attributes:
        line: From 1.
        start: First code point.
        end: One past the last.
        file: Its name where the robot is a folder of files, else empty.
    """

    line: int
    start: int
    end: int
    file: str = ""


class WrittenNumber(NamedTuple):
    """A number in a file.

    Attributes:
        text: As written.
        value: In SI units.
        half: Half a unit of its last digit, zero for what is exact.
        at: Where it stands: in a document, or in another file.
        is_implied: Whether the text there says it otherwise, as a quaternion does an angle: a
            place to look at, not to write to.
    """

    text: str
    value: float
    half: float
    at: Located | TextPlace
    is_implied: bool = False

    @property
    def slack(self) -> float:
        """The greatest distance of an equal number."""
        size = abs(self.value)
        return max(min(self.half, _CAP * size), _FLOAT * size)


Numbers = tuple[WrittenNumber | None, ...]


@dataclass(frozen=True, slots=True)
class WrittenInertia:
    """A mass distribution as one link of a file has it.

    Attributes:
        owner: The link's name.
        values: The ten numbers in the order of `INERTIA`.
        numbers: Where they are written, None for one that is not.
        body_T_frame: The frame of the centre of mass in the moving body's frame.
        turn: The axes of the moments in that frame.
        is_about_com: Whether moments are about the centre of mass, and products are the tensor's
            entries, as in XML; else they are a document's, about the frame's origin.
    """

    owner: str
    values: tuple[float, ...] = (0.0,) * 10
    numbers: Numbers = (None,) * 10
    body_T_frame: RigidPose = IDENTITY
    turn: Rotation = IDENTITY.rotation
    is_about_com: bool = False

    @property
    def sign(self) -> float:
        """The sign of the products beside the document's."""
        return -1.0 if self.is_about_com else 1.0

    def body(self, values: Sequence[float] | None = None) -> MassDistribution:
        """Return the mass distribution in the moving body's frame, of these or other values."""
        mass, x, y, z, xx, yy, zz, *products = self.values if values is None else values
        xy, xz, yz = (self.sign * each for each in products)
        moments = MassDistribution(mass, ORIGIN, (xx, yy, zz, xy, xz, yz))
        if not self.is_about_com:
            return seen_from(moments._replace(com=(x, y, z)), self.body_T_frame)
        about_com = seen_from(moments, RigidPose(self.turn, (x, y, z)))
        return seen_from(about_com, self.body_T_frame)

    def values_of(self, body: MassDistribution) -> tuple[float, ...]:
        """Return the numbers that would be written here for a body in the moving body's frame."""
        own = seen_from(body, self.body_T_frame.inverse())
        written = own
        if self.is_about_com:
            about_com = shifted(own, -1.0)._replace(com=ORIGIN)
            written = seen_from(about_com, RigidPose(transposed(self.turn), ORIGIN))
        xx, yy, zz, *products = written.moments
        return (own.mass, *own.com, xx, yy, zz, *(self.sign * each + 0.0 for each in products))


@dataclass(frozen=True, slots=True)
class WrittenPose:
    """A pose as a joint or frame of a file has it.

    Attributes:
        owner: The joint's name.
        values: Translation and angles, in the order of `POSE`.
        numbers: Where they are written.
        before: The frame that it is written in, in the predecessor's frame.
        after: The frame meant in the one that is written.
        is_intrinsic: Whether angles are about own axes x, y, z in turn, else about fixed ones.
        axis: Where the axis of a joint is written, if that is apart from the pose.
    """

    owner: str
    values: tuple[float, ...]
    numbers: Numbers = (None,) * 6
    before: RigidPose = IDENTITY
    after: RigidPose = IDENTITY
    is_intrinsic: bool = True
    axis: WrittenNumber | None = None

    def pose(self, values: Sequence[float] | None = None) -> RigidPose:
        """Return the frame meant in the predecessor's frame, of these or other values."""
        x, y, z, *turns = self.values if values is None else values
        made = pose_from if self.is_intrinsic else pose_from_fixed_axes
        return self.before.then(made((x, y, z), (turns[0], turns[1], turns[2]))).then(self.after)

    def values_of(self, pose: RigidPose) -> tuple[float, ...]:
        """Return the numbers for a pose; of the angles that mean the same, the most like these."""
        own = self.before.inverse().then(pose).then(self.after.inverse())
        written = self.values[3], self.values[4], self.values[5]
        if self.is_intrinsic:
            return (*own.translation, *_nearest_turns(own.rotation, written))
        # Turns about fixed axes are those about own axes of the way back, backwards.
        back = _nearest_turns(transposed(own.rotation), _negated(written))
        return (*own.translation, *_negated(back))


def with_meant_angles(joint: WrittenPose) -> WrittenPose:
    """Return a pose whose angles are the ones meant: `1.5708` is a quarter turn."""
    pairs = zip(joint.values[3:], joint.numbers[3:], strict=True)
    turns = (_meant_angle(value, number) for value, number in pairs)
    return replace(joint, values=(*joint.values[:3], *turns))


def _meant_angle(value: float, number: WrittenNumber | None) -> float:
    """Return the fraction of a turn that an angle is within its digits, else the angle."""
    slack = max(_FLOAT, number.slack if number is not None else 0.0)
    fraction = round_angle(value)
    return fraction if abs(value - fraction) <= slack else value


def is_round_angle(value: float) -> bool:
    """Return whether an angle is a fraction of a turn, as it is when nobody changed it."""
    return abs(value - round_angle(value)) <= _FLOAT


def written_frame(name: str, pose: RigidPose) -> WrittenPose:
    """Return the form of a frame that is only known as a pose."""
    return WrittenPose(name, (*pose.translation, *angles(pose.rotation, _GIMBAL)))


def _options(rotation: Rotation, written: Vector3) -> list[Vector3]:
    """Return the turns about x, the new y, the new z that make a rotation.

    Where y is a quarter turn, x and z turn about one axis: either may then be as it is written.
    """
    x, y, z = angles(rotation, _GIMBAL)
    options = [(x, y, z), (x + pi, pi - y, z + pi)]
    a = product(rotation, pose_from(ORIGIN, (0.0, 0.0, -written[2])).rotation)
    if abs(a[0][1]) < _GIMBAL:
        options.append((atan2(a[2][1], a[1][1]), atan2(a[0][2], a[0][0]), written[2]))
    b = product(pose_from(ORIGIN, (-written[0], 0.0, 0.0)).rotation, rotation)
    if abs(b[1][2]) < _GIMBAL:
        options.append((written[0], atan2(b[0][2], b[2][2]), atan2(b[1][0], b[1][1])))
    return options


def _nearest_turns(rotation: Rotation, written: Vector3) -> Vector3:
    """Return those angles that differ from what is written in the fewest, and by the least."""
    wound = [
        tuple(w + remainder(o - w, 2.0 * pi) for o, w in zip(option, written, strict=True))
        for option in _options(rotation, written)
    ]
    x, y, z = min(wound, key=lambda option: _otherness(option, written))
    return x, y, z


def _otherness(option: Sequence[float], written: Sequence[float]) -> tuple[int, int, float]:
    """Return how many angles are others, how many of these were round, and by how much they are."""
    apart = [abs(a - b) for a, b in zip(option, written, strict=True)]
    others = [b for b, gap in zip(written, apart, strict=True) if gap > _CAP]
    return len(others), sum(map(is_round_angle, others)), sum(apart)


def _negated(vector: Vector3) -> Vector3:
    x, y, z = vector
    return 0.0 - x, 0.0 - y, 0.0 - z
