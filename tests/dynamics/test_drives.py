"""Rotors and friction of joints: the same in every form, and pinocchio's numbers.

pinocchio knows rotors, and friction is a force of joints that depends on their velocities.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.codegen.compiling import (
    COMPILERS,
    build,
    needs_compiler,
    quickly_compiled,  # noqa: F401
    run_tests,
)
from tests.codegen.robots import ALL, bodies_of_seed, write_c
from tests.dynamics.random_bodies import tree_of_seed, with_drives
from tests.dynamics.test_against_pinocchio import _check_tree
from tests.dynamics.test_compiled import assert_same, calls
from tests.dynamics.test_whole_body import _check_generated, _pairs
from tests.support.amount import usually
from tests.support.differences import assert_close

from kindsl.mechanics.dynamics.bodies import Bodies, Drives
from kindsl.mechanics.dynamics.evaluation import book
from kindsl.mechanics.dynamics.evaluation.book import Request
from kindsl.mechanics.dynamics.evaluation.compiled import CompiledMechanics
from kindsl.mechanics.dynamics.evaluation.forms import Forms
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.quantities import JOINT_VECTORS

SEEDS = range(0, 300, usually(15, thoroughly=1))
# A floating base with a revolute and a prismatic joint in a row: what a compiler makes of each
# joint's drive, in the least of code; three links where all cases are tried.
SMALL = usually((1, 3), thoroughly=(7, 3))


def _driven(seed: int) -> tuple[Bodies, np.random.Generator]:
    bodies, generator = tree_of_seed(seed)
    if not bodies.is_floating:
        bodies = replace(bodies, masses=np.concatenate(([0.0], bodies.masses[1:])))
    return with_drives(bodies, generator), generator


@pytest.mark.parametrize("seed", SEEDS)
def test_random_trees_agree_with_pinocchio(seed: int) -> None:
    bodies, generator = _driven(seed)
    _check_tree(seed, bodies, generator)
    for what, got, expected in _pairs(bodies, generator):
        assert_close(f"seed {seed}, {what}", got, expected)


@pytest.mark.parametrize("seed", [1, 2, 9, 12])
def test_all_forms_are_one(seed: int) -> None:
    """And all code, batches and what is recorded for controllers included."""
    bodies = with_drives(bodies_of_seed(seed), np.random.default_rng(seed))
    generator = np.random.default_rng(seed)
    base, g = generator.uniform(-1.0, 1.0, 6) * bodies.is_floating, np.array([1.0, 2.0, -9.0])
    for quantity, names in JOINT_VECTORS.items():
        for n in (2, 60):
            joints = {name: generator.uniform(-1.0, 1.0, (n, bodies.n_links)) for name in names}
            request = Request(quantity, (n,), {**joints, "v0": base, "g": g})
            expected = book.evaluate(bodies, request)
            generated = Forms(bodies).by_code(request)
            np.testing.assert_allclose(generated, expected, rtol=1e-8, atol=1e-8)
    _check_generated(seed, bodies)


@needs_compiler
def test_code_in_c_has_them(tmp_path: Path) -> None:
    bodies = with_drives(bodies_of_seed(*SMALL), np.random.default_rng(1))
    most = tuple(name for name in ALL if name != "frame_motions")
    few = ("inverse_dynamics", "forward_dynamics")
    for real, quantities in ("double", most), ("float", usually(few, thoroughly=most)):
        folder = write_c(bodies, tmp_path / real, quantities, real=real)
        run_tests(build(COMPILERS[0], folder, [], "test"))


@needs_compiler
@pytest.mark.usefixtures("quickly_compiled")
def test_compiled_mechanics_have_them() -> None:
    bodies = with_drives(bodies_of_seed(*SMALL), np.random.default_rng(1))
    compiled, mechanics = CompiledMechanics(bodies), Mechanics(bodies)
    for shape in ((), (11,)):
        for name, arguments in calls(bodies.n_links, bodies.is_floating, shape):
            if name not in ("frame_velocity", "frame_acceleration", "frame_acceleration_drift"):
                found = getattr(compiled, name)(*arguments)
                assert_same(found, getattr(mechanics, name)(*arguments), 1e-9)


@pytest.mark.parametrize("name", ["inverse_dynamics", "forward_dynamics"])
def test_derivatives_are_differences(name: str) -> None:
    bodies = with_drives(bodies_of_seed(4), np.random.default_rng(3))
    mechanics, step = Mechanics(bodies), 1e-6
    q, qd, x = np.random.default_rng(3).uniform(0.2, 1.0, (3, bodies.n_links))
    slopes = getattr(mechanics, f"{name}_derivatives")(q, qd, x)
    for number, slope in enumerate(slopes):
        for joint in range(bodies.n_links):
            ends = []
            for sign in (1.0, -1.0):
                moved = [q.copy(), qd.copy(), x.copy()]
                moved[number][joint] += sign * step
                ends.append(getattr(mechanics, name)(*moved))
            found = (ends[0] - ends[1]) / (2.0 * step)
            np.testing.assert_allclose(found, slope[:, joint], atol=1e-6, rtol=1e-6)


@pytest.mark.parametrize("amount", [np.zeros(3), np.array([np.nan])])
def test_amounts_are_one_a_joint(amount: np.ndarray) -> None:
    bodies = bodies_of_seed(4)
    fitting = np.zeros(bodies.n_links)
    with pytest.raises(ValueError, match="friction"):
        replace(bodies, drives=Drives(fitting, fitting, np.resize(amount, amount.size + 40)))
