"""Torques of two robots, the effect of each differing number, base parameters. Needs NumPy."""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple, TypeVar

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.evaluation.whole_body import GRAVITY
from kindsl.mechanics.dynamics.regressor import PARAMETERS_PER_BODY, regressor
from kindsl.mechanics.rigid.body import lumped, seen_from
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.mechanics.spatial.arrays import Array
from kindsl.robots.comparison.alignment import around
from kindsl.robots.comparison.mechanical import MechanicalComparison
from kindsl.robots.comparison.number_differences import NumberDifference
from kindsl.robots.comparison.quantities import INERTIA, POSE
from kindsl.robots.comparison.restated import restated
from kindsl.robots.comparison.side import ComparedSide
from kindsl.robots.comparison.turned_axes import with_axis
from kindsl.robots.mechanism.bodies import bodies_of
from kindsl.robots.mechanism.linkage import Linkage

_T = TypeVar("_T")
_STATES = 20
_SEED = 26
# Greatest effect of the digits of equal numbers on a torque, beside the greatest torque.
_DIGITS = 1e-3
_NOTHING = 1e-10
_TINY = 1e-300
# Of random motions to the columns of a regressor.
_ROWS_PER_PARAMETER = 3
# Of a singular value beside the greatest, of a force beside the weight: rounding.
_SMALLEST = 1e-9


class Torques(NamedTuple):
    """The result of comparing torques.

    Attributes:
        is_seen: Whether the differing numbers change any torque.
        is_confirmed: Whether inertia matrix and bias forces are equal; None if numbers differ.
        effects: The greatest change of a joint torque or force by each number, N m or N.
    """

    is_seen: bool
    is_confirmed: bool | None
    effects: tuple[float, ...]


class _States(NamedTuple):
    """Random motions."""

    q: Array
    qd: Array
    qdd: Array


def torques(ours: ComparedSide, theirs: ComparedSide, found: MechanicalComparison) -> Torques:
    """Compare the torques of two robots whose joints all match."""
    states = _states(ours.skeleton)
    own = _forces(ours.skeleton, states)
    if found.is_equal:
        rounded = replace(found, numbers=found.rounded)
        own = _forces(_carried(ours, theirs, rounded), states) if found.rounded else own
        other = _counted_as_ours(ours.skeleton, theirs.skeleton, found, states)
        return Torques(False, _gap(ours.skeleton, own, other) <= _DIGITS, ())
    carried = _forces(_carried(ours, theirs, found), states)
    effects = tuple(_effect(ours, theirs, found, each) for each in found.numbers)
    gap = _gap(ours.skeleton, own, carried)
    return Torques(bool(found.structure) or gap > _NOTHING, None, effects)


def _states(skeleton: Linkage) -> _States:
    random = np.random.default_rng(_SEED)
    q, qd, qdd = random.uniform(-1.0, 1.0, (3, _STATES, skeleton.n_links))
    return _States(q, qd, qdd)


def _forces(skeleton: Linkage, states: _States) -> tuple[Array, Array]:
    mechanics = Mechanics(bodies_of(skeleton), generates_code=False)
    return mechanics.joint_space_inertia(states.q), mechanics.bias_torque(states.q, states.qd)


def _counted_as_ours(
    ours: Linkage, theirs: Linkage, found: MechanicalComparison, states: _States
) -> tuple[Array, Array]:
    """Return the other's own matrices and forces, in our joints and our base's frame."""
    same = restated(ours, theirs, found)
    places = [same.joint_names.index(name) for name in ours.joint_names]
    M, bias = _forces(same, _States(*(rates[:, np.argsort(places)] for rates in states)))
    first = 6 if same.is_floating else 0
    order = [*range(first), *(first + place for place in places)]
    return M[:, order][:, :, order], bias[:, order]


def _carried(ours: ComparedSide, theirs: ComparedSide, found: MechanicalComparison) -> Linkage:
    """Return our robot with the other's numbers where they differ, in our conventions."""
    one, other = ours.skeleton, theirs.skeleton
    masses, placements = list(one.masses), list(one.placements)
    turns: list[tuple[int, RigidPose]] = []
    frames = found.alignment.frames
    for number in found.numbers:
        body, its = number.body, found.matching.theirs[number.body]
        if number.turn is not None:
            turns.append((body, number.turn))
        elif number.quantity in INERTIA:
            parts = [part.body() for part in theirs.inertias[its]]
            masses[body] = seen_from(lumped(parts), frames[body])
        elif number.kind == "joint":
            before, after = around(one, found.alignment, body)
            placements[body - 1] = before.then(other.placements[its - 1]).then(after)
    carried = one.with_masses(masses).with_placements(placements)
    for body, turn in turns:
        carried = with_axis(carried, body, turn)
    return carried


def _gap(skeleton: Linkage, one: tuple[Array, Array], other: tuple[Array, Array]) -> float:
    """Return the greatest difference relative to the greatest entry.

    Forces that are next to nothing beside the robot's weight are rounding.
    """
    mass = sum(abs(body.mass) for body in skeleton.masses)
    least = _TINY, _TINY + _SMALLEST * mass * float(np.linalg.norm(GRAVITY))
    pairs = zip(one, other, least, strict=True)
    return float(max(np.abs(a - b).max() / max(np.abs(a).max(), c) for a, b, c in pairs))


def _effect(
    ours: ComparedSide, theirs: ComparedSide, found: MechanicalComparison, number: NumberDifference
) -> float:
    """Return the greatest change of a torque or force by this number alone."""
    its = found.matching.theirs[number.body]
    if number.quantity in INERTIA and not (ours.inertias[number.body] and theirs.inertias[its]):
        # The whole inertia is another.
        side, changed = ours, _carried(ours, theirs, replace(found, numbers=(number,)))
    else:
        side = theirs if number.is_theirs else ours
        changed = _changed(side, found, number)
    states = _states(side.skeleton)
    first = 6 if side.skeleton.is_floating else 0
    taus = []
    for skeleton in (side.skeleton, changed):
        M, bias = _forces(skeleton, states)
        taus.append(np.einsum("sij,sj->si", M[:, :, first:], states.qdd) + bias)
    return float(np.abs(taus[0] - taus[1]).max())


def _changed(side: ComparedSide, found: MechanicalComparison, number: NumberDifference) -> Linkage:
    skeleton = side.skeleton
    body = found.matching.theirs[number.body] if number.is_theirs else number.body
    if number.turn is not None:
        return with_axis(skeleton, body, number.turn)
    if number.kind == "frame":
        return skeleton
    value = number.here if number.is_theirs else number.there
    owner = number.other if number.is_theirs else number.owner
    if number.kind == "joint":
        form = side.joints[body - 1]
        pose = form.pose(_with(form.values, POSE.index(number.quantity), value))
        return skeleton.with_placements(_with(skeleton.placements, body - 1, pose))
    parts = [
        part.body(_with(part.values, INERTIA.index(number.quantity), value))
        if part.owner == owner
        else part.body()
        for part in side.inertias[body]
    ]
    return skeleton.with_masses(_with(skeleton.masses, body, lumped(parts)))


def _with(values: Sequence[_T], index: int, value: _T) -> tuple[_T, ...]:
    return (*values[:index], value, *values[index + 1 :])


def n_base_parameters(bodies: Bodies) -> tuple[int, int]:
    """Return the number of base parameters, which motions can identify, and of all parameters.

    The rest is the null space: changes of masses, centres of mass and moments that leave every
    joint torque, and the wrench on a floating base, as it is.

    Source: Wensing, Niemeyer, Slotine 2017, Observability in inertial parameter identification;
    the rank is taken of random motions.
    """
    random = np.random.default_rng(_SEED)
    n = bodies.n_links
    n_velocities = n + (6 if bodies.is_floating else 0)
    states = 1 + _ROWS_PER_PARAMETER * PARAMETERS_PER_BODY * (n + 1) // n_velocities
    q, qd, qdd = random.uniform(-1.0, 1.0, (3, states, n))
    v = random.uniform(-1.0, 1.0, (states, 6)) if bodies.is_floating else np.zeros((states, 6))
    a = random.uniform(-1.0, 1.0, (states, 6)) if bodies.is_floating else np.zeros((states, 6))
    a[:, 3:] -= GRAVITY
    Y = regressor(bodies, q, qd, qdd, v, a)
    columns = Y.reshape(-1, Y.shape[-1])
    moving = n + (1 if bodies.is_floating else 0)
    values = np.linalg.svd(columns, compute_uv=False)
    rank = int(np.count_nonzero(values > _SMALLEST * values[0]))
    return rank, PARAMETERS_PER_BODY * moving
