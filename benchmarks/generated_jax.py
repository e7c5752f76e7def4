"""Generated modules for JAX under `jit` against mechanics in NumPy.

    python benchmarks/generated_jax.py [DOCUMENT ...] [--states N] [--float32]

Without documents for the robots of `../shared/robcogen_interface`. Prints, for each function and
for the gradients of inverse and forward dynamics, the processor's seconds until the first answer,
the least processor's milliseconds of all threads for an answer, those for one state without `jit`,
those of NumPy, their ratio, and how far the answers are apart, relative to the largest number.
"""

import argparse
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from types import ModuleType

import jax
import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.codegen.robots import PLAIN  # noqa: E402

import kindsl  # noqa: E402
from kindsl.products.codegen.generating import Source, generate  # noqa: E402
from kindsl.products.codegen.library import Options  # noqa: E402

SHARED = ROOT.parent / "shared/robcogen_interface"
DOCUMENTS = (
    SHARED / "testhyq/description/test_hyq.kindsl",
    SHARED / "testIrb4600/description/testirb4600.kindsl",
)
ROUNDS = 15


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("documents", nargs="*", type=Path)
    parser.add_argument("--states", type=int, default=10_000)
    parser.add_argument("--float32", action="store_true")
    args = parser.parse_args()
    jax.config.update("jax_enable_x64", not args.float32)
    for document in args.documents or [path for path in DOCUMENTS if path.is_file()]:
        compare(document, args.states)


def compare(document: Path, states: int) -> None:
    """Print a row for each function of a robot."""
    loaded = kindsl.load(document)
    options = Options("jax", PLAIN, "double", False, "unbound", "r")
    _, files = generate(Source(document.name, loaded, {}), options)
    module, mechanism = ModuleType("r"), loaded.mechanism()
    exec(files["r.py"], module.__dict__)
    generator, n = np.random.default_rng(1), mechanism.n_joints
    q, qd, x = generator.uniform(-1.0, 1.0, (3, states, n))
    base = [generator.uniform(-1.0, 1.0, (states, 6))] if module.IS_FLOATING else []
    calls = {
        "inverse_dynamics": [q, qd, x, *base], "forward_dynamics": [q, qd, x, *base],
        "joint_space_inertia": [q], "poses": [q], "gravity_torque": [q],
        "bias_torque": [q, qd, *base],
    }  # fmt: skip
    for name, values in calls.items():
        function, first = _compiled(getattr(module, name), values)
        other = getattr(mechanism, "forward_kinematics" if name == "poses" else name)
        mine, numpy_s = (_least(partial(f, *values)) for f in (function, other))
        told = f"{_without_jit(getattr(module, name), values)}  "
        told += f"NumPy {numpy_s:6.2f} ms  ratio {mine / numpy_s:5.1f}"
        if name != "poses":
            pairs = zip(
                jax.tree.leaves(function(*values)), jax.tree.leaves(other(*values)), strict=True
            )
            apart = max(np.abs(a - b).max() / np.abs(b).max() for a, b in pairs)
            told += f"  apart {apart:.0e}"
        _row(document, name, first, mine, told)
    for name in ("inverse_dynamics", "forward_dynamics"):
        dynamics = getattr(module, name)
        slope = jax.grad(lambda *v, f=dynamics: sum(a.sum() for a in jax.tree.leaves(f(*v))))
        function, first = _compiled(slope, calls[name])
        mine = _least(partial(function, *calls[name]))
        _row(document, f"grad of {name}", first, mine, _without_jit(slope, calls[name]))


def _compiled(
    function: Callable[..., object], values: list[np.ndarray]
) -> tuple[Callable[..., object], float]:
    compiled = jax.jit(function)
    start = time.process_time()
    jax.block_until_ready(compiled(*values))
    return lambda *v: jax.block_until_ready(compiled(*v)), time.process_time() - start


def _without_jit(function: Callable[..., object], values: list[np.ndarray]) -> str:
    """Return how long answers for one state take that are not the first."""
    one = partial(function, *(rows[0] for rows in values))
    jax.block_until_ready(one())
    return f"without jit {_least(lambda: jax.block_until_ready(one())):6.2f} ms"


def _least(call: Callable[[], object]) -> float:
    """Return the least of the processor's milliseconds."""
    found = []
    for _ in range(ROUNDS):
        start = time.process_time()
        call()
        found.append((time.process_time() - start) * 1e3)
    return min(found)


def _row(document: Path, name: str, first: float, mine: float, told: str) -> None:
    print(f"{document.stem:14} {name:24} first {first:5.1f} s  {mine:7.2f} ms  {told}", flush=True)


if __name__ == "__main__":
    main()
