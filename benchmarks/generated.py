"""What generated and compiled code costs, as ratios against others in the same process.

    python benchmarks/generated.py [--robcogen FOLDER]

Times are microseconds for one configuration, medians of alternating rounds, so that both sides see
the same machine. A ratio above 1 means that ours is faster.

Against pinocchio from Python: single calls as they are made; derivatives less the time of a trivial
call on both sides; batches of 10,000 on one thread against a loop of calls.

Against RobCoGen's own C++ for HyQ, if FOLDER has its generated headers (the folder above
`testhyq/generated` with the shims that they include; Eigen's headers are found beside Python's
packages or in /usr/include): both sides are compiled into one program, and results escape.
"""

import argparse
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import pinocchio as pin
from benchmarks.dynamics_models import arm, quadruped
from tests.dynamics.pinocchio_model import PinocchioModel

from kindsl.analysis.analysis import analyse
from kindsl.codegen.generating import Source, generate
from kindsl.codegen.library import Options
from kindsl.dynamics.bodies import Bodies
from kindsl.dynamics.evaluation.compiled import CompiledMechanics
from kindsl.dynamics.generation.functions import QUANTITIES

ROUNDS = 41
BATCH = 10_000
GRAVITY = np.array([0.0, 0.0, -9.81])
Call = Callable[[], object]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=_Raw)
    parser.add_argument("--robcogen", metavar="FOLDER", type=Path)
    args = parser.parse_args()
    for name, bodies in (("arm", arm()), ("quadruped", quadruped())):
        against_pinocchio(name, bodies)
    if args.robcogen is not None:
        against_robcogen(args.robcogen)


class _Raw(argparse.RawDescriptionHelpFormatter):
    pass


def against_pinocchio(name: str, bodies: Bodies) -> None:
    """Print a row for each quantity."""
    ours, theirs = CompiledMechanics(bodies), PinocchioModel(bodies, GRAVITY)
    generator, n = np.random.default_rng(1), bodies.n_links
    q, qd, x = generator.uniform(-1.0, 1.0, (3, n))
    v0, a0 = generator.uniform(-1.0, 1.0, (2, 6))
    base, moving = ((v0,), (v0, a0)) if bodies.is_floating else ((), ())
    model, data = theirs.model, theirs.data
    tq, tv, ta = theirs._q(q), theirs._v(v0, qd), theirs._v(a0, x)
    pairs: dict[str, tuple[Call, Call]] = {
        "inverse dynamics": (
            lambda: ours.inverse_dynamics(q, qd, x, *base),
            lambda: pin.rnea(model, data, tq, tv, ta),
        ),
        "forward dynamics": (
            lambda: ours.forward_dynamics(q, qd, x, *base),
            lambda: pin.aba(model, data, tq, tv, ta),
        ),
        "inertia": (lambda: ours.joint_space_inertia(q), lambda: pin.crba(model, data, tq)),
    }
    derivatives: dict[str, tuple[Call, Call]] = {
        "inverse dynamics derivatives": (
            lambda: ours.inverse_dynamics_derivatives(q, qd, x, *moving),
            lambda: pin.computeRNEADerivatives(model, data, tq, tv, ta),
        ),
        "forward dynamics derivatives": (
            lambda: ours.forward_dynamics_derivatives(q, qd, x, *base),
            lambda: pin.computeABADerivatives(model, data, tq, tv, ta),
        ),
        "regressor": (
            lambda: ours.regressor(q, qd, x, *moving),
            lambda: pin.computeJointTorqueRegressor(model, data, tq, tv, ta),
        ),
    }
    for what, (mine, other) in pairs.items():
        _row(name, f"{what}, single", *_medians(mine, other))
    # The least that a call with arguments costs.
    trivial = _median(lambda: None, 1000)
    bare = _medians(lambda: None, lambda: pin.computeKineticEnergy(model, data))[1]
    for what, (mine, other) in derivatives.items():
        a, b = _medians(mine, other, repeat=100)
        _row(name, what, a - trivial, b - bare)
    Q, QD, X = generator.uniform(-1.0, 1.0, (3, BATCH, n))
    many = (generator.uniform(-1.0, 1.0, (BATCH, 6)),) if bodies.is_floating else ()
    for what, method, call in (
        ("inverse dynamics", ours.inverse_dynamics, pin.rnea),
        ("forward dynamics", ours.forward_dynamics, pin.aba),
    ):
        a = _median(lambda m=method: m(Q, QD, X, *many), 1) / BATCH
        b = _median(lambda c=call: c(model, data, tq, tv, ta), 1000)
        _row(name, f"{what}, batch", a, b)


def against_robcogen(folder: Path) -> None:
    """Print a row for each quantity of HyQ, both sides in one program."""
    document = folder / "testhyq" / "description" / "test_hyq.kindsl"
    analysis = analyse(document.read_text(encoding="utf-8"))
    options = Options("c", tuple(QUANTITIES)[:12], "double", False, "unbound", "hyq")
    _, files = generate(Source(document.name, analysis, {}), options)
    here = Path(__file__).resolve().parent
    with tempfile.TemporaryDirectory() as temporary:
        place = Path(temporary)
        for name, text in files.items():
            (place / name).write_text(text, encoding="utf-8")
        sources = [str(p) for p in place.glob("hyq_*.c") if p.name != "hyq_test.c"]
        include = [f"-I{folder}", f"-I{folder / 'include'}", f"-I{place}", f"-I{_eigen()}"]
        theirs = sorted(map(str, (folder / "testhyq" / "generated").glob("*.cpp")))
        program = here / "generated_robcogen.cpp"
        for command in (
            ["gcc", "-std=c11", "-O2", "-c", *sources],
            ["g++", "-std=c++17", "-O3", *include, str(program), *theirs,
             *(f"{Path(s).stem}.o" for s in sources), "-o", "contest"],
        ):  # fmt: skip
            subprocess.run(command, cwd=place, check=True)
        done = subprocess.run(["./contest"], cwd=place, check=True, capture_output=True, text=True)
    for line in done.stdout.splitlines():
        what, theirs_us, ours_us = line.split("\t")
        _row("HyQ, RobCoGen", what, float(ours_us), float(theirs_us))


def _eigen() -> Path:
    places = [Path("/usr/include/eigen3")]
    places += [Path(p) / "cmeel.prefix" / "include" / "eigen3" for p in sys.path if p]
    return next((p for p in places if p.is_dir()), places[0])


def _medians(a: Call, b: Call, repeat: int = 1000) -> tuple[float, float]:
    """Return medians of both, in alternating rounds."""
    rounds = [(_time(a, repeat), _time(b, repeat)) for _ in range(ROUNDS)]
    first, second = zip(*rounds, strict=True)
    return statistics.median(first), statistics.median(second)


def _median(call: Call, repeat: int) -> float:
    return statistics.median(_time(call, repeat) for _ in range(ROUNDS))


def _time(call: Call, repeat: int) -> float:
    start = time.perf_counter()
    for _ in range(repeat):
        call()
    return (time.perf_counter() - start) / repeat * 1e6


def _row(robot: str, what: str, ours: float, theirs: float) -> None:
    print(f"{robot:14} {what:30} ours {ours:8.3f}  other {theirs:8.3f}  ratio {theirs / ours:6.2f}")


if __name__ == "__main__":
    main()
