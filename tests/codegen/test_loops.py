"""Loops over bodies give what straight lines do."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
from tests.codegen.compiling import (
    COMPILERS,
    EIGEN,
    Compiler,
    build,
    each_compiler,
    needs_compiler,
    quickly_compiled,  # noqa: F401
    run_tests,
)
from tests.codegen.loaded import Loaded
from tests.codegen.robots import bodies_of_seed, library, reference, write_c
from tests.codegen.test_python_modules import CORPUS
from tests.dynamics.random_bodies import random_bodies, with_drives
from tests.dynamics.test_compiled import assert_same, calls
from tests.support.amount import usually
from tests.support.differences import worst_difference
from tests.support.robots import LIFT

from kindsl.judgement.analysis.analysis import analyse
from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.compiled import CompiledMechanics
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.generation import loops
from kindsl.mechanics.dynamics.generation.robot import robot_of
from kindsl.mechanics.dynamics.generation.terms import operations
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.language import language_named
from kindsl.products.codegen.library import GenerationError, Options

pytestmark = needs_compiler
IN_LOOPS = tuple(loops.LOOPS)
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
STRICT += ["-isystem", str(EIGEN)]


@pytest.fixture(autouse=True)
def all_in_loops(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no function be short enough."""
    monkeypatch.setattr(loops, "MOST_OPERATIONS", -1)


def _bodies(seed: int) -> Bodies:
    bodies = bodies_of_seed(seed)
    return with_drives(bodies, np.random.default_rng(seed)) if seed % 3 == 0 else bodies


# The first has a fixed base and drives, the second a floating one and none.
@pytest.mark.parametrize("seed", range(usually(2, thoroughly=8)))
def test_numbers_are_those_of_the_mechanics(seed: int, tmp_path: Path) -> None:
    bodies = _bodies(seed)
    folder = write_c(bodies, tmp_path / "robot", IN_LOOPS)
    path = build(COMPILERS[0], folder, ["-shared", "-fPIC"], "robot.so")
    loaded, expected = Loaded(path, library(bodies, IN_LOOPS)), reference(bodies)
    free = {**expected.values, "fext": None}
    assert all(function.is_loop for function in loaded.library.all_functions)
    for function in loaded.library.all_functions:
        found = loaded.call(function, free)
        assert worst_difference(found, expected.results(function)) < 1e-12, function.name
        if function.loaded is not None:
            found = loaded.call(function, expected.values)
            assert worst_difference(found, expected.loaded_results(function)) < 1e-12
            batch = loaded.call(function, _twice(expected.values), n=2)
            assert worst_difference([x[x.size // 2 :] for x in batch], found) == 0.0


# More columns than a block has, and bodies that are not numbered depth first.
@pytest.mark.parametrize("is_floating", [False, True])
def test_numbers_of_many_bodies(*, is_floating: bool, tmp_path: Path) -> None:
    names = tuple(name for name in IN_LOOPS if "deriv" in name or "inverse" in name)
    bodies = random_bodies(np.random.default_rng(7), 25, is_floating=is_floating)
    bodies = with_drives(bodies, np.random.default_rng(8))
    folder = write_c(bodies, tmp_path / "robot", names)
    path = build(COMPILERS[0], folder, ["-shared", "-fPIC"], "robot.so")
    loaded, expected = Loaded(path, library(bodies, names)), reference(bodies)
    for function in loaded.library.all_functions:
        found = loaded.call(function, {**expected.values, "fext": None})
        assert worst_difference(found, expected.results(function)) < 1e-10, function.name


def _twice(values: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    return {name: x if name == "g" else np.tile(x.ravel(), 2) for name, x in values.items()}


# One source is compiled in a fifth of the time that many take.
@each_compiler
@pytest.mark.parametrize("real", ["double", "float"])
def test_the_test_program_succeeds_under_sanitizers(
    compiler: Compiler, real: str, tmp_path: Path
) -> None:
    folder = write_c(_bodies(3), tmp_path, IN_LOOPS, is_single_header=True, real=real)
    told = run_tests(build(compiler, folder, list(compiler.sanitizers), "tests"))
    assert "FAILED" not in told
    assert "ok forward_dynamics: qdd with forces" in told


@pytest.mark.parametrize("language", ["c", "cpp"])
def test_parameters_are_inputs(language: str, tmp_path: Path) -> None:
    compiler = COMPILERS[-1 if language == "c" else 0]
    options = Options(language, IN_LOOPS, "double", False, "all", "robot")
    library, files = generate(Source("r.kindsl", analyse(CORPUS), {}), options)
    assert library.has_loops
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    if language == "c":
        assert "FAILED" not in run_tests(build(compiler, tmp_path, [], "tests"))
        return
    assert "FAILED" not in _eigen(compiler, tmp_path)


@each_compiler
def test_eigen(compiler: Compiler, tmp_path: Path) -> None:
    # A floating base for one compiler, a fixed one for the other.
    bodies = _bodies(3 if compiler is COMPILERS[0] else 4)
    made = library(bodies, IN_LOOPS, language="cpp")
    for name, text in language_named("cpp").files(made, reference(bodies)).items():
        (tmp_path / name).write_text(text)
    assert "FAILED" not in _eigen(compiler, tmp_path)


def _eigen(compiler: Compiler, folder: Path) -> str:
    if EIGEN is None:
        pytest.skip("there is no Eigen")
    command = [f"{compiler.name}++" if compiler.name == "clang" else "g++", "-std=c++14", *STRICT]
    subprocess.run([*command, "robot_test.cpp", "-o", "tests"], cwd=folder, check=True)
    return run_tests(folder / "tests")


@pytest.mark.parametrize("seed", [3, 4])
@pytest.mark.usefixtures("quickly_compiled")
def test_compiled_mechanics(seed: int) -> None:
    bodies = _bodies(seed)
    mine, other = CompiledMechanics(bodies), Mechanics(bodies)
    for name, given in calls(bodies.n_links, bodies.is_floating):
        found, expected = getattr(mine, name)(*given), getattr(other, name)(*given)
        assert_same(found, expected)


def test_functions_of_more_operations_are_loops(monkeypatch: pytest.MonkeyPatch) -> None:
    bodies = bodies_of_seed(4)
    straight = library(bodies, IN_LOOPS, language="python")
    graph = straight.robot.graph
    sizes = {
        f.name: operations(graph, [e for r in f.results for e in r.entries])
        for f in straight.all_functions
    }
    limit = sorted(sizes.values())[4]
    monkeypatch.setattr(loops, "MOST_OPERATIONS", limit)
    found = library(bodies, IN_LOOPS).all_functions
    most = {n: limit // 2 if n.endswith("_derivatives") else limit for n in sizes}
    assert {f.name for f in found if f.is_loop} == {n for n in sizes if sizes[n] > most[n]}


def test_what_is_surely_long_is_not_recorded(monkeypatch: pytest.MonkeyPatch) -> None:
    bodies, few = bodies_of_seed(4), ("forward_dynamics_derivatives",)
    recorded = library(bodies, few, language="python")
    tree = robot_of(bodies).tree
    least = 2 * loops.LOOPS[few[0]] * loops.factorization_operations(tree)
    for limit in (least, least - 1):
        monkeypatch.setattr(loops, "MOST_OPERATIONS", limit)
        made = library(bodies, few)
        assert (made.robot.graph.nodes == recorded.robot.graph.nodes) is (limit == least)
    assert made.has_loops
    # Its arguments and sizes are those of the robot.
    (loop,), (straight,) = made.all_functions, recorded.all_functions
    assert [len(a.components) for a in loop.arguments] == [
        len(a.components) for a in straight.arguments
    ]
    assert [r.shape for r in loop.results] == [r.shape for r in straight.results]


@pytest.mark.usefixtures("quickly_compiled")
def test_matrices_that_fit_on_no_stack_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(loops, "MOST_VELOCITIES", 1)
    options = Options("c", ("coriolis_matrix",), "double", False, "unbound", "robot")
    with pytest.raises(GenerationError, match="'coriolis_matrix' is not generated for more than 1"):
        generate(Source("r.kindsl", analyse(LIFT), {}), options)
    bodies = bodies_of_seed(4)
    q = np.full(bodies.n_links, 0.3)
    found = CompiledMechanics(bodies).coriolis_matrix(q, q)
    assert_same(found, Mechanics(bodies).coriolis_matrix(q, q))
