"""What generated and compiled code costs, as ratios against others in the same process.

    python benchmarks/generated.py [--robot arm|quadruped]

Times are microseconds of the processor for one configuration. All contestants of a robot take
turns, some dozens of short rounds each, so that a busy machine is as busy for one as for another;
what is printed are medians, and as ratio the median of the rounds' own ratios. A ratio above 1
means that ours is faster. All give the same results, as new arrays or, pinocchio's, in its data.

Against pinocchio from Python: single calls as they are made; derivatives less a trivial call, on
both sides one that takes and gives the same but for a robot of one joint; also ours in C alone, one
of a hundred in one call, against pinocchio's less that of a trivial call without arguments; batches
of 10,000 on one thread against a loop of calls.
"""

import argparse
import statistics
import sys
import time
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import pinocchio as pin
from benchmarks.dynamics_models import arm, pendulum, quadruped
from tests.dynamics.pinocchio_model import PinocchioModel

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.compiled import CompiledMechanics
from kindsl.mechanics.spatial.arrays import Array

ROUNDS = 41
BATCH = 10_000
FEW = 100
GRAVITY = np.array([0.0, 0.0, -9.81])
ROBOTS = {"arm": arm, "quadruped": quadruped}
Call = Callable[[], object]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=_Raw)
    parser.add_argument("--robot", choices=ROBOTS, help="only this one")
    args = parser.parse_args()
    for name, bodies in ROBOTS.items():
        if args.robot in (None, name):
            against_pinocchio(name, bodies())


class _Raw(argparse.RawDescriptionHelpFormatter):
    pass


class Contest(NamedTuple):
    """Calls of both sides, and how many configurations or repetitions each is timed for.

    Attributes:
        ours: The call.
        theirs: The same of the other side.
        repeat: How often ours is called in a round.
        size: How many configurations ours answers in one call.
        less: Trivial calls of both sides, whose times are subtracted.
    """

    ours: Call
    theirs: Call
    repeat: int = 100
    size: int = 1
    less: tuple[Call, Call] | None = None


class Calls(NamedTuple):
    """Both sides of one robot, with single configurations and many."""

    single: dict[str, tuple[Call, Call]]
    derivatives: dict[str, tuple[Call, Call]]
    few: dict[str, Call]
    many: dict[str, Call]
    bare: Call


def against_pinocchio(name: str, bodies: Bodies) -> None:
    """Print a row for each quantity."""
    calls, trivial = calls_of(bodies), calls_of(pendulum())
    contests = {f"{what}, single": Contest(*pair) for what, pair in calls.single.items()}
    for what, pair in calls.derivatives.items():
        contests[what] = Contest(*pair, less=trivial.derivatives[what])
        in_c = Contest(calls.few[what], pair[1], 2, FEW, (_nothing, calls.bare))
        contests[f"{what}, in C"] = in_c
    for what, call in calls.many.items():
        contests[f"{what}, batch"] = Contest(call, calls.single[what][1], 1, BATCH)
    for what, rounds in _played(contests).items():
        _row(name, what, rounds)


def calls_of(bodies: Bodies) -> Calls:
    """Return the calls of both sides for a robot."""
    ours, theirs = CompiledMechanics(bodies), PinocchioModel(bodies, GRAVITY)
    generator, n = np.random.default_rng(1), bodies.n_links
    q, qd, x = generator.uniform(-1.0, 1.0, (3, n))
    v0, a0 = generator.uniform(-1.0, 1.0, (2, 6))
    model, data = theirs.model, theirs.data
    tq, tv, ta = theirs.q_of(q), theirs.v_of(v0, qd), theirs.v_of(a0, x)

    def moving(size: int) -> tuple[Array, tuple[Array, ...], tuple[Array, ...]]:
        base = tuple(generator.uniform(-1.0, 1.0, (2, size, 6))) if bodies.is_floating else ()
        return generator.uniform(-1.0, 1.0, (3, size, n)), base[:1], base

    (Q, QD, X), base_few, moving_few = moving(FEW)
    (Q_, QD_, X_), base_many, _ = moving(BATCH)
    base, both = ((v0,), (v0, a0)) if bodies.is_floating else ((), ())
    # Compiles inertia and all derivatives: methods asked for before are slower.
    ours.joint_space_inertia(q)
    ours.regressor(q, qd, x)
    return Calls(
        {
            "inverse dynamics": (
                partial(ours.inverse_dynamics, q, qd, x, *base),
                partial(pin.rnea, model, data, tq, tv, ta),
            ),
            "forward dynamics": (
                partial(ours.forward_dynamics, q, qd, x, *base),
                partial(pin.aba, model, data, tq, tv, ta),
            ),
            "inertia": (
                partial(ours.joint_space_inertia, q), partial(pin.crba, model, data, tq),
            ),
        },
        {
            "inverse dynamics derivatives": (
                partial(ours.inverse_dynamics_derivatives, q, qd, x, *both),
                partial(pin.computeRNEADerivatives, model, data, tq, tv, ta),
            ),
            "forward dynamics derivatives": (
                partial(ours.forward_dynamics_derivatives, q, qd, x, *base),
                partial(pin.computeABADerivatives, model, data, tq, tv, ta),
            ),
            "regressor": (
                partial(ours.regressor, q, qd, x, *both),
                partial(pin.computeJointTorqueRegressor, model, data, tq, tv, ta),
            ),
        },
        {
            "inverse dynamics derivatives": partial(
                ours.inverse_dynamics_derivatives, Q, QD, X, *moving_few
            ),
            "forward dynamics derivatives": partial(
                ours.forward_dynamics_derivatives, Q, QD, X, *base_few
            ),
            "regressor": partial(ours.regressor, Q, QD, X, *moving_few),
        },
        {
            "inverse dynamics": partial(ours.inverse_dynamics, Q_, QD_, X_, *base_many),
            "forward dynamics": partial(ours.forward_dynamics, Q_, QD_, X_, *base_many),
            "inertia": partial(ours.joint_space_inertia, Q_),
        },
        partial(pin.computeKineticEnergy, model, data),
    )  # fmt: skip


def _nothing() -> None:
    pass


def _played(contests: Mapping[str, Contest]) -> dict[str, list[tuple[float, float]]]:
    """Return the times of both sides in each round, microseconds for one configuration."""
    rounds: dict[str, list[tuple[float, float]]] = {what: [] for what in contests}
    for _ in range(ROUNDS):
        for what, (ours, theirs, repeat, size, less) in contests.items():
            a, b = _time(ours, repeat) / size, _time(theirs, 100)
            if less is not None:
                a, b = a - _time(less[0], 100) / size, b - _time(less[1], 100)
            rounds[what].append((a, b))
    return rounds


def _time(call: Call, repeat: int) -> float:
    """Return the processor's time for a call; what other programs take does not count."""
    start = time.thread_time()
    for _ in range(repeat):
        call()
    return (time.thread_time() - start) / repeat * 1e6


def _row(robot: str, what: str, rounds: list[tuple[float, float]]) -> None:
    ours, theirs = (statistics.median(side) for side in zip(*rounds, strict=True))
    ratio = statistics.median(b / a for a, b in rounds)
    print(
        f"{robot:14} {what:36} ours {ours:8.3f}  other {theirs:8.3f}  ratio {ratio:6.2f}",
        flush=True,
    )


if __name__ == "__main__":
    main()
