"""What a compiler takes for the generated code of a large robot, in processor time.

    python benchmarks/generated_compiling.py [--seed N] [--links N] [--chain] [--quantities LIST]
    python benchmarks/generated_compiling.py --compiled [--seed N] [--links N] [--chain]

A random tree with a floating base, prismatic joints, branches and frames, or a chain of revolute
joints on a fixed base; all quantities, with derivatives, or those listed, in C. Each file is
compiled by itself with `cc -O2`, and with `cc -O0` as a measure of the machine and its load.
With `--compiled`, what `mechanism.compiled()` takes, and the first call of other methods; a chain
has then rotations of all sorts, which take more operations than right angles.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.dynamics_models import chain
from tests.codegen.robots import ALL, write_c
from tests.dynamics.random_bodies import random_bodies

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.compiled import CompiledMechanics


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--links", type=int, default=30)
    parser.add_argument("--chain", action="store_true")
    parser.add_argument("--quantities", default=",".join(ALL))
    parser.add_argument("--compiled", action="store_true")
    args = parser.parse_args()
    bodies = random_bodies(np.random.default_rng(args.seed), args.links, is_floating=not args.chain)
    if args.compiled:
        parents = tuple(range(args.links)) if args.chain else bodies.parents
        _compiled(replace(bodies, parents=parents, frames=()))
        return
    if args.chain:
        bodies = chain(args.links)
    with tempfile.TemporaryDirectory() as temporary:
        folder = write_c(bodies, Path(temporary), tuple(args.quantities.split(",")))
        paths = sorted(path for path in folder.glob("*.c") if not path.name.endswith("_test.c"))
        rows = [(path.stem, path.stat().st_size, *_seconds(path)) for path in paths]
    for row in sorted(rows, key=lambda row: row[2]):
        _row(*row)
    _row("all", *(sum(column) for column in list(zip(*rows, strict=True))[1:]))


def _compiled(bodies: Bodies) -> None:
    """Print the processor's seconds of the first calls, with nothing compiled before."""
    n, made = np.zeros(bodies.n_links), list[CompiledMechanics]()
    steps: dict[str, Callable[[], object]] = {
        "made": lambda: made.append(CompiledMechanics(bodies)),
        "bias torque": lambda: made[0].bias_torque(n, n),
        "inertia and masses": lambda: made[0].joint_space_inertia(n),
        "derivatives": lambda: made[0].inverse_dynamics_derivatives(n, n, n),
    }
    with tempfile.TemporaryDirectory() as cache:
        os.environ["KINDSL_CACHE"] = cache
        for name, step in steps.items():
            before = _processor_seconds()
            step()
            print(f"{name:20} {_processor_seconds() - before:5.1f} s", flush=True)


def _processor_seconds() -> float:
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def _seconds(path: Path) -> tuple[float, float]:
    """Return the processor's seconds for a file, optimized and not."""
    optimized, plain = (_compile(path, option) for option in ("-O2", "-O0"))
    return optimized, plain


def _compile(path: Path, option: str) -> float:
    before = _processor_seconds()
    command = ["cc", "-std=c11", option, "-c", path.name, "-o", "object.o"]
    subprocess.run(command, cwd=path.parent, check=True)
    return _processor_seconds() - before


def _row(name: str, size: int, optimized: float, plain: float) -> None:
    ratio = optimized / plain
    print(f"{name:36} {size / 1e6:6.2f} MB  -O2 {optimized:6.1f} s  {ratio:5.1f} x -O0", flush=True)


if __name__ == "__main__":
    main()
