"""What kinematics and dynamics cost, as ratios against pinocchio from Python in the same run.

    python benchmarks/dynamics.py [--quick]

Times are microseconds for one configuration, the least of alternating rounds, so that both sides
see the same machine. `call` is pinocchio's bare call, which leaves its result in its own data or
fills half of a matrix; `same` includes what it takes to hold the same result as ours: poses as 4x4
arrays, M whole, a floating base's acceleration without any wrench. A ratio above 1 means that ours
is faster. `even` is the smallest batch at which ours is no slower than `call`, and than `same`.
"""

import argparse
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import pinocchio as pin
from benchmarks.dynamics_models import arm, chain, quadruped
from tests.dynamics.pinocchio_model import PinocchioModel

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.spatial.arrays import Array

ROOT = Path(__file__).resolve().parents[1]
EVEN_SIZES = (1, 10, 20, 40, 60, 80, 100, 150, 200, 300, 500, 1000, 2000, 5000)
FIRST_ANSWER = """
from benchmarks.dynamics_models import quadruped
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
import numpy as np, time
bodies = quadruped()
start = time.perf_counter()
q = np.zeros(12)
Mechanics(bodies).{call}
print(time.perf_counter() - start)
"""
IMPORT_NUMPY = """
import time
start = time.perf_counter()
import numpy
print(time.perf_counter() - start)
"""


class Contest(NamedTuple):
    """One quantity of one mechanism, computed in three ways.

    Attributes:
        name: The quantity.
        ours: Computes a batch, or one configuration.
        bare: Calls pinocchio for one configuration.
        same: Calls pinocchio for one configuration and keeps the same result.
        rows: Our arguments, each (configurations, n).
        pinocchio_rows: Pinocchio's arguments.
    """

    name: str
    ours: Callable[..., object]
    bare: Callable[..., object]
    same: Callable[..., object]
    rows: list[Array]
    pinocchio_rows: list[Array]


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--quick", action="store_true", help="smaller batches, fewer rounds")
    quick = parser.parse_args().quick
    rounds = 3 if quick else 9
    print("                               one configuration               |   batch")
    print("mechanism  quantity            ours    call    same   ours/call ours/same |", end="")
    print("    size    ours  call/ours  same/ours  even with call, same")
    for name, bodies, size in (
        ("arm", arm(), 10_000),
        ("quadruped", quadruped(), 10_000),
        ("chain", chain(), 5_000),
    ):
        for contest in contests(bodies, size // 10 if quick else size):
            print(f"{name:10} {contest.name:18}", _single(contest, rounds), end=" | ")
            print(_batch(contest, rounds), flush=True)
    _print_robot_model_tools(rounds)
    _print_first_answers(rounds)


def contests(bodies: Bodies, size: int) -> list[Contest]:
    """Return what to measure of a mechanism."""
    mechanics, theirs = Mechanics(bodies), PinocchioModel(bodies, np.array([0.0, 0.0, -9.81]))
    model, data = theirs.model, theirs.data
    q, qd, x = np.random.default_rng(0).uniform(-1.0, 1.0, (3, size, bodies.n_links))
    base = np.zeros((size, 6)) if bodies.is_floating else np.zeros((size, 0))
    origin = np.tile([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0], (size, 1))[:, : 7 * bodies.is_floating]
    Q, V, X = (np.concatenate((b, v), axis=1) for b, v in ((origin, q), (base, qd), (base, x)))
    joints = range(model.njoints - bodies.n_links, model.njoints)

    def poses(q: Array) -> list[Array]:
        pin.forwardKinematics(model, data, q)
        return [data.oMi[joint].homogeneous for joint in joints]

    def inertia(q: Array) -> Array:
        M = pin.crba(model, data, q)
        return np.triu(M) + np.triu(M, 1).T

    def free_inverse(q: Array, v: Array, a: Array) -> tuple[Array, Array]:
        """Return joint forces and base acceleration, at which the base feels no wrench."""
        M, bias = inertia(q), pin.nonLinearEffects(model, data, q, v)
        a0 = -np.linalg.solve(M[:6, :6], bias[:6] + M[:6, 6:] @ a[6:])
        return bias[6:] + M[6:, :6] @ a0 + M[6:, 6:] @ a[6:], a0

    def inverse(q: Array, v: Array, a: Array) -> Array:
        return np.array(pin.rnea(model, data, q, v, a))

    def forward(q: Array, v: Array, tau: Array) -> Array:
        return np.array(pin.aba(model, data, q, v, tau))

    def bare(function: Callable[..., object]) -> Callable[..., object]:
        return lambda *rows: function(model, data, *rows)

    same_inverse = free_inverse if bodies.is_floating else inverse
    fk, M = mechanics.forward_kinematics, mechanics.joint_space_inertia
    id_, fd = mechanics.inverse_dynamics, mechanics.forward_dynamics
    return [
        Contest("forward kinematics", fk, bare(pin.forwardKinematics), poses, [q], [Q]),
        Contest("inverse dynamics", id_, bare(pin.rnea), same_inverse, [q, qd, x], [Q, V, X]),
        Contest("joint inertia", M, bare(pin.crba), inertia, [q], [Q]),
        Contest("forward dynamics", fd, bare(pin.aba), forward, [q, qd, x], [Q, V, X]),
    ]


def _single(contest: Contest, rounds: int) -> str:
    row = [argument[0].copy() for argument in contest.rows]
    pinocchio_row = [argument[0].copy() for argument in contest.pinocchio_rows]
    ours, bare, same = _least_times(
        [
            lambda: contest.ours(*row),
            lambda: contest.bare(*pinocchio_row),
            lambda: contest.same(*pinocchio_row),
        ],
        rounds,
    )
    return f"{ours:8.2f}{bare:8.2f}{same:8.2f} {ours / bare:10.1f}{ours / same:10.1f}"


def _batch(contest: Contest, rounds: int) -> str:
    size = len(contest.rows[0])
    ours, bare, same = _batch_times(contest, size, rounds)
    even = [_break_even(contest, theirs) for theirs in (contest.bare, contest.same)]
    return f"{size:7}{ours:8.3f}{bare / ours:10.1f}{same / ours:11.1f}{even[0]:>12}{even[1]:>8}"


def _batch_times(contest: Contest, size: int, rounds: int) -> list[float]:
    times = _least_times(
        [
            lambda: contest.ours(*contest.rows),
            lambda: [contest.bare(*row) for row in zip(*contest.pinocchio_rows, strict=True)],
            lambda: [contest.same(*row) for row in zip(*contest.pinocchio_rows, strict=True)],
        ],
        rounds,
    )
    return [time / size for time in times]


def _break_even(contest: Contest, theirs: Callable[..., object]) -> str:
    for size in EVEN_SIZES:
        if size > len(contest.rows[0]):
            break
        rows = [argument[:size].copy() for argument in contest.rows]
        pinocchio_rows = [argument[:size].copy() for argument in contest.pinocchio_rows]

        def batch(rows: list[Array] = rows) -> object:
            return contest.ours(*rows)

        def loop(rows: list[Array] = pinocchio_rows) -> object:
            return [theirs(*row) for row in zip(*rows, strict=True)]

        ours, others = _least_times([batch, loop], 5)
        if ours <= others:
            return str(size)
    return "none"


def _least_times(functions: list[Callable[[], object]], rounds: int) -> list[float]:
    """Return each function's least time, microseconds, over rounds in which they alternate."""
    repeats = [_repeats(function) for function in functions]
    least = [np.inf] * len(functions)
    for _ in range(rounds):
        for number, function in enumerate(functions):
            start = time.thread_time()
            for _ in range(repeats[number]):
                function()
            each = (time.thread_time() - start) / repeats[number]
            least[number] = min(least[number], 1e6 * each)
    return least


def _repeats(function: Callable[[], object]) -> int:
    """Return how often to call a function so that it takes some 10 ms, having called it once."""
    function()
    start = time.thread_time()
    function()
    return max(1, int(0.01 / (time.thread_time() - start)))


def _print_robot_model_tools(rounds: int) -> None:
    import kgprim.ct.frommotions as from_motions
    import kgprim.ct.repr.mxrepr as matrices
    import rmt.kinematics
    import rmt.rmt
    import robmodel.jposes

    path = ROOT / "examples" / "industrial_arm.kindsl"
    robot, frames, geometry = rmt.rmt.getmodels(str(path))[1:4]
    joints = robmodel.jposes.JointPoses(robot, frames, geometry.jointAxes)
    kinematics = rmt.kinematics.RobotKinematics(geometry, joints)
    mechanics = _mechanics_of(path)
    transforms = []
    for name in mechanics.bodies.link_names:
        link = frames.linkFrames[robot.links[name]]
        pose = kinematics.framesConnectivity.getPoseSpec(link, kinematics.baseFrame)
        transforms.append(matrices.hCoordinatesSymbolic(from_motions.toCoordinateTransform(pose)))
    q = np.linspace(0.1, 0.6, mechanics.bodies.n_links)
    batch = np.tile(q, (10_000, 1))
    ours, ours_batch, theirs = _least_times(
        [
            lambda: mechanics.forward_kinematics(q),
            lambda: mechanics.forward_kinematics(batch),
            lambda: [H.setVariablesValue(valueslist=q[: len(H.variables)]) for H in transforms],
        ],
        rounds,
    )
    print(f"\nrobot-model-tools, poses of {path.stem}: {theirs:.0f}; times that of ours:", end=" ")
    print(f"one {theirs / ours:.0f}, batch of 10,000 {theirs / (ours_batch / 10_000):.0f}")


def _mechanics_of(path: Path) -> Mechanics:
    from kindsl.language.semantics.model import Model
    from kindsl.language.syntax.document import parse
    from kindsl.robots.mechanism.build import mechanism_of

    model = Model(parse(path.read_text()))
    return mechanism_of(model, {str(parameter.name): 0.1 for parameter in model.parameters})


def _print_first_answers(rounds: int) -> None:
    calls = {
        "forward kinematics": "forward_kinematics(q)",
        "inverse dynamics": "inverse_dynamics(q, q, q)",
        "joint inertia": "joint_space_inertia(q)",
        "forward dynamics": "forward_dynamics(q, q, q)",
    }
    numpy_time = _median_output(IMPORT_NUMPY, rounds)
    print(
        f"\nfirst answer on the quadruped, in units of importing NumPy ({1e3 * numpy_time:.0f} ms):"
    )
    for name, call in calls.items():
        seconds = _median_output(FIRST_ANSWER.format(call=call), rounds)
        print(f"  {name:18} {seconds / numpy_time:6.2f}")


def _median_output(program: str, rounds: int) -> float:
    """Return the median of the number that a program prints, each time in a new process."""
    outputs = [
        subprocess.run(
            [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=True
        ).stdout
        for _ in range(rounds)
    ]
    return statistics.median(map(float, outputs))


if __name__ == "__main__":
    main()
