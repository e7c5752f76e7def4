"""The numbers in which two robots differ: the fewest of either file that make the difference."""

from collections.abc import Callable, Sequence
from math import hypot
from typing import NamedTuple

from kindsl.mechanics.rigid.body import MassDistribution, less, lumped, seen_from
from kindsl.mechanics.rigid.pose import RigidPose, angle_between
from kindsl.robots.comparison.alignment import around
from kindsl.robots.comparison.quantities import INERTIA, POSE, TURNS
from kindsl.robots.comparison.rounding import NO_ANGLE, Digits, Form
from kindsl.robots.comparison.side import Pair
from kindsl.robots.comparison.written import (
    WrittenInertia,
    WrittenNumber,
    WrittenPose,
    is_round_angle,
)

_ROUNDING = 1e-11
_FLOAT = 2e-7
# Of a frame whose digits in the other file are not known, beside the robot and in radians.
_FRAME = 1e-5
# Zero in an MJCF, kg m^2: MuJoCo takes nothing less.
_NO_MOMENT = 3e-14
# Of the size of the robot: a mass at the origin of its frame is computed from lengths like these.
_NO_REACH = 1e-3
_UNITS = dict(zip(INERTIA, ("kg", *("m",) * 3, *("kg m²",) * 6), strict=True)) | dict(
    zip(POSE, (*("m",) * 3, *("rad",) * 3), strict=True)
)


class NumberChange(NamedTuple):
    """A number, and the value with which the files would agree."""

    number: WrittenNumber
    value: float


class NumberDifference(NamedTuple):
    """A number that is another in the other file.

    Attributes:
        kind: `"link"`, `"joint"` or `"frame"`.
        owner: Whose number it is, in our file.
        other: Its name in the other file.
        quantity: Of `INERTIA` or `POSE`, or `AXIS`: then the values are nothing and the angle.
        unit: Of both values.
        here: Our file's value, or the one it needs where only the other's number is to blame.
        there: The other's value, or the one it needs.
        here_number: Our number, None if it is not written or not the one that differs.
        there_number: The other's.
        here_near: Our file's text in its place, about another point or along other axes.
        there_near: The other's.
        body: Our body that it moves or weighs.
        is_theirs: Whether it is the other's number that would have to be another.
        our_changes: Edits of our file for both to agree; none where these are not known.
        their_changes: The same in the other file.
        turn: Of an axis: the frame whose z is the other's, in our joint's.
    """

    kind: str
    owner: str
    other: str
    quantity: str
    unit: str
    here: float
    there: float
    here_number: WrittenNumber | None
    there_number: WrittenNumber | None
    here_near: WrittenNumber | None = None
    there_near: WrittenNumber | None = None
    body: int = 0
    is_theirs: bool = False
    our_changes: tuple[NumberChange, ...] = ()
    their_changes: tuple[NumberChange, ...] = ()
    turn: RigidPose | None = None

    @property
    def places(self) -> tuple[WrittenNumber | None, WrittenNumber | None]:
        """Both numbers, or the text in their places."""
        return self.here_number or self.here_near, self.there_number or self.there_near


class _WantedNumbers(NamedTuple):
    """The numbers of one part of a file that would agree with the other file."""

    form: Form
    values: tuple[float, ...]
    unlike: tuple[int, ...]


class Tolerances(NamedTuple):
    """The differences that count as none.

    Attributes:
        size: Of the robot, metres.
        tolerance: Relative, as the user wants it besides the digits.
        is_rough: Whether the digits of the other file do not matter: for a choice, not a verdict.
        digits: Of a file whose numbers are rounded.
    """

    size: float
    tolerance: float = 0.0
    is_rough: bool = False
    digits: Digits | None = None


def joint_differences(pair: Pair, body: int, bounds: Tolerances) -> list[NumberDifference]:
    """Return the numbers that differ in the pose of the joint that carries our body."""
    other = pair.matching.theirs[body]
    mine, its = pair.ours.joints[body - 1], pair.theirs.joints[other - 1]
    before, after = around(pair.ours.skeleton, pair.alignment, body)
    back = before.inverse(), after.inverse()
    tilt = 0.0
    for side, carried in (pair.ours, body), (pair.theirs, other):
        carrier = side.skeleton.parents[carried - 1]
        tilt += _turn_slack(side.joints[carrier - 1], bounds) if carrier else 0.0
    wanted = _wanted_pose(mine, its, (before, after), bounds, tilt)
    if not wanted.unlike:
        return []
    found = _shorter("joint", wanted, _wanted_pose(its, mine, back, bounds, tilt))
    return [each._replace(body=body) for each in found]


def frame_differences(
    frame: WrittenPose, other: WrittenPose | None, pose: RigidPose, bounds: Tolerances
) -> list[NumberDifference]:
    """Return the numbers of a frame that differ from another's pose in the same body."""
    values = frame.values_of(pose)
    scales, slack = _scales_of_pose(bounds), [_FRAME * bounds.size] * 3 + [_FRAME] * 3
    if other is not None:
        slack = list(map(max, slack, _own_slacks(other, bounds)))
    unlike = _unlike(frame, values, scales, bounds, slack)
    # Angles may be ill-defined, a turn is not.
    turn = _turn_slack(frame, bounds) + sum(slack[3:])
    if angle_between(frame.pose(), frame.pose(values)) <= turn:
        unlike = tuple(k for k in unlike if k < 3)
    wanted = _WantedNumbers(frame, values, unlike)
    near = (None,) * len(POSE) if other is None else other.numbers
    return [
        _difference("frame", wanted, frame, k, None)._replace(there_near=near[k]) for k in unlike
    ]


def inertia_differences(pair: Pair, body: int, bounds: Tolerances) -> list[NumberDifference]:
    """Return the numbers of a body's mass that differ; a body may consist of several links."""
    ours, theirs, other = pair.ours, pair.theirs, pair.matching.theirs[body]
    if not (ours.inertias[body] or theirs.inertias[other]):
        return []
    frame = pair.alignment.frames[body]
    mine = ours.inertias[body] or (WrittenInertia(ours.skeleton.body_names[body]),)
    its = theirs.inertias[other] or (WrittenInertia(theirs.skeleton.body_names[other]),)
    joints = (ours.joints[body - 1], theirs.joints[other - 1]) if body else ()
    tilt = sum(_turn_slack(joint, bounds) for joint in joints)
    wanted = _wanted_inertia(mine, its, frame, bounds, tilt)
    if not wanted.unlike:
        return []
    others = _wanted_inertia(its, mine, frame.inverse(), bounds, tilt)
    found = [each._replace(body=body) for each in _shorter("link", wanted, others)]
    if ours.inertias[body] and theirs.inertias[other]:
        return found
    # No single number makes up for an inertia that is not written.
    left = [each for each in found if each.quantity == INERTIA[0]] or found
    return [each._replace(our_changes=(), their_changes=()) for each in left]


def _wanted_pose(
    form: WrittenPose,
    other: WrittenPose,
    around: tuple[RigidPose, RigidPose],
    bounds: Tolerances,
    tilt: float,
) -> _WantedNumbers:
    """Return the numbers that agree, `tilt` being how far the carrying body may be turned, rad."""
    before, after = around

    def values(written: Sequence[float]) -> tuple[float, ...]:
        return form.values_of(before.then(other.pose(written)).then(after))

    wanted = values(other.values)
    scales = _scales_of_pose(bounds)
    unlike = _unlike(form, wanted, scales, bounds)
    if unlike and not bounds.is_rough:
        # Angles may be ill-defined, a turn is not.
        turn = _turn_slack(other, bounds)
        moved = _slack(values, wanted, other, bounds)
        lever = tilt * hypot(*form.values[:3])
        slack = (*(each + lever for each in moved[:3]), *(min(each, turn) for each in moved[3:]))
        unlike = _unlike(form, wanted, scales, bounds, slack)
        apart = angle_between(form.pose(), form.pose(wanted))
        if apart <= turn + _turn_slack(form, bounds) + _ROUNDING:
            unlike = tuple(k for k in unlike if k < 3)
    return _WantedNumbers(form, wanted, unlike)


def _turn_slack(form: WrittenPose, bounds: Tolerances) -> float:
    """Return how far a joint may be turned since its angles are rounded, rad."""
    return sum(_own_slacks(form, bounds)[3:])


def _own_slacks(form: Form, bounds: Tolerances) -> list[float]:
    pairs = zip(form.values, form.numbers, strict=True)
    return [_FLOAT * abs(v) if n is None else _own_slack(n, bounds) for v, n in pairs]


def _own_slack(number: WrittenNumber, bounds: Tolerances) -> float:
    if bounds.digits is None:
        return number.slack
    return max(number.slack, min(number.half, bounds.digits.half(number.value)))


def _wanted_inertia(
    mine: Sequence[WrittenInertia],
    its: Sequence[WrittenInertia],
    frame: RigidPose,
    bounds: Tolerances,
    tilt: float,
) -> _WantedNumbers:
    """Return the part of ours that can agree by the fewest numbers, the frame turned by a tilt."""
    options = [_wanted_part(mine, number, its, frame, bounds, tilt) for number in range(len(mine))]
    return min(options, key=lambda option: len(option.unlike))


def _wanted_part(
    mine: Sequence[WrittenInertia],
    number: int,
    its: Sequence[WrittenInertia],
    frame: RigidPose,
    bounds: Tolerances,
    tilt: float,
) -> _WantedNumbers:
    part = mine[number]
    rest = [each.body() for i, each in enumerate(mine) if i != number]
    bodies = [each.body() for each in its]

    def values(parts: Sequence[MassDistribution]) -> tuple[float, ...]:
        return part.values_of(less(seen_from(lumped(parts), frame), rest))

    wanted = values(bodies)
    scales = _scales_of_inertia((*rest, *bodies, part.body()), part, bounds.size)
    unlike = _unlike(part, wanted, scales, bounds)
    if not unlike or bounds.is_rough:
        return _WantedNumbers(part, wanted, unlike)
    reach, moment = hypot(*part.values[1:4]), max(map(abs, part.values[4:]))
    slack = [0.0, *[tilt * reach] * 3, *[tilt * moment] * 6]
    for i, each in enumerate(its):

        def of_part(
            written: Sequence[float], i: int = i, each: WrittenInertia = each
        ) -> tuple[float, ...]:
            return values([*bodies[:i], each.body(written), *bodies[i + 1 :]])

        more = _slack(of_part, wanted, each, bounds)
        slack = [a + b for a, b in zip(slack, more, strict=True)]
    if any(part.values[1:4]) and any(each.is_about_com != part.is_about_com for each in its):
        # Both files may have rounded moments about other points, whose difference is not rounded.
        own = [0.0] * 4 + _own_slacks(part, bounds)[4:]
        slack = [a + b for a, b in zip(slack, own, strict=True)]
    unlike = _unlike(part, wanted, scales, bounds, slack)
    return _WantedNumbers(part, wanted, unlike)


def _slack(
    values: Callable[[Sequence[float]], tuple[float, ...]],
    wanted: Sequence[float],
    form: Form,
    bounds: Tolerances,
) -> list[float]:
    """Return the effect of another form's rounding on the values, to first order."""
    slack = [0.0] * len(wanted)
    for k, (value, step) in enumerate(zip(form.values, _own_slacks(form, bounds), strict=True)):
        if step:
            moved = values([*form.values[:k], value + step, *form.values[k + 1 :]])
            slack = [s + abs(m - w) for s, m, w in zip(slack, moved, wanted, strict=True)]
    return slack


def _unlike(
    form: Form,
    wanted: Sequence[float],
    scales: Sequence[float],
    bounds: Tolerances,
    slack: Sequence[float] = (0.0,) * 10,
) -> tuple[int, ...]:
    """Return the indices of the numbers that differ from wanted ones by more than is open."""
    columns = zip(form.values, wanted, scales, slack, _own_slacks(form, bounds), strict=False)
    return tuple(
        k
        for k, (value, want, scale, others, own) in enumerate(columns)
        if abs(value - want) > max(own, others, bounds.tolerance * abs(value)) + _ROUNDING * scale
    )


def _scales_of_pose(bounds: Tolerances) -> tuple[float, ...]:
    return (bounds.size,) * 3 + (NO_ANGLE / _ROUNDING,) * 3


def _scales_of_inertia(
    parts: Sequence[MassDistribution], part: WrittenInertia, size: float
) -> tuple[float, ...]:
    """Return the magnitudes that the numbers were computed from."""
    mass = sum(abs(each.mass) for each in parts)
    reach = max(hypot(*each.com) for each in parts) + hypot(*part.body_T_frame.translation)
    moments = sum(max(map(abs, each.moments)) for each in parts) + mass * reach * reach
    moments = max(moments, _NO_MOMENT / _ROUNDING)
    # What is left of a zero where XML turns the axes by an angle that is rounded.
    products = moments * NO_ANGLE / _ROUNDING if part.is_about_com else moments
    return mass, *(max(reach, _NO_REACH * size),) * 3, *(moments,) * 3, *(products,) * 3


def _shorter(kind: str, ours: _WantedNumbers, theirs: _WantedNumbers) -> list[NumberDifference]:
    """Return the differences as numbers of the file that has fewer to change, ours if equal."""
    if not theirs.unlike:
        return []
    if (len(ours.unlike), _n_round(ours, theirs)) <= (len(theirs.unlike), _n_round(theirs, ours)):
        return [_difference(kind, ours, theirs.form, k, theirs) for k in ours.unlike]
    return [_reversed(_difference(kind, theirs, ours.form, k, ours)) for k in theirs.unlike]


def _n_round(wanted: _WantedNumbers, others: _WantedNumbers) -> int:
    """Return how many round angles would change."""
    form, unlike = wanted.form, wanted.unlike
    if isinstance(form, WrittenInertia) or unlike == others.unlike:
        return 0
    return sum(is_round_angle(form.values[k]) for k in unlike if POSE[k] in TURNS)


def _difference(
    kind: str, wanted: _WantedNumbers, other: Form, k: int, others: _WantedNumbers | None
) -> NumberDifference:
    names = INERTIA if isinstance(wanted.form, WrittenInertia) else POSE
    value, there = wanted.form.values[k], wanted.values[k]
    number = other.numbers[k] if others is not None else None
    needed = () if others is None else others.unlike if wanted.unlike == (k,) else (k,)
    is_one = others is not None and others.unlike == wanted.unlike == (k,)
    is_equal = number is not None and abs(other.values[k] - there) <= number.slack + _ROUNDING
    is_there = number is not None and (is_one or is_equal)
    return NumberDifference(
        kind,
        wanted.form.owner,
        other.owner,
        names[k],
        _UNITS[names[k]],
        value,
        there,
        wanted.form.numbers[k],
        number if is_there else None,
        there_near=number,
        our_changes=_changes(wanted, (k,)),
        their_changes=_changes(others, needed) if others is not None else (),
    )


def _changes(wanted: _WantedNumbers, indices: Sequence[int]) -> tuple[NumberChange, ...]:
    numbers = [wanted.form.numbers[k] for k in indices]
    if any(k not in wanted.unlike for k in indices):
        return ()
    changes = zip(numbers, (wanted.values[k] for k in indices), strict=True)
    found = [NumberChange(n, value) for n, value in changes if n is not None and not n.is_implied]
    return tuple(found) if len(found) == len(numbers) else ()


def _reversed(found: NumberDifference) -> NumberDifference:
    return found._replace(
        owner=found.other,
        other=found.owner,
        here=found.there,
        there=found.here,
        here_number=found.there_number,
        there_number=found.here_number,
        here_near=found.there_near,
        there_near=None,
        is_theirs=True,
        our_changes=found.their_changes,
        their_changes=found.our_changes,
    )
