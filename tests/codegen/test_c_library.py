"""Libraries in C compile without warnings and compute what the mechanics do."""

import shutil
import subprocess
from dataclasses import replace
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
    run_tests,
)
from tests.codegen.loaded import Loaded
from tests.codegen.robots import CONTROL, PLAIN, bodies_of_seed, library, reference, write_c
from tests.dynamics.random_bodies import random_bodies
from tests.support.differences import worst_difference

from kindsl.products.codegen.c_test_program import TOLERANCES, _tolerance
from kindsl.products.codegen.language import language_named
from kindsl.products.codegen.reference import Reference

pytestmark = needs_compiler
FEW = ("poses", "foot_jacobians", "inverse_dynamics", "forward_dynamics")
EXTREMES = (0.0, 1e-308, 1e4, 1e8, 1e300, np.inf, -np.inf, np.nan)


@pytest.fixture(scope="module", params=[(4, 5), (7, 3)], ids=["fixed", "floating"])
def pair(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Loaded, Reference]:
    """A library with branches, frames and both kinds of joints, compiled once for all tests."""
    bodies, quantities = bodies_of_seed(*request.param), (*PLAIN, *CONTROL)
    folder = write_c(bodies, tmp_path_factory.mktemp("c") / "robot", quantities)
    path = build(COMPILERS[0], folder, ["-shared", "-fPIC"], "robot.so")
    return Loaded(path, library(bodies, quantities)), reference(bodies)


def test_numbers_are_the_mechanics(pair: tuple[Loaded, Reference]) -> None:
    loaded, expected = pair
    free = {**expected.values, "fext": None}
    for function in loaded.library.all_functions:
        found = loaded.call(function, free)
        assert worst_difference(found, expected.results(function)) < 1e-12, function.name
        if function.loaded is not None:
            found = loaded.call(function, expected.values)
            assert worst_difference(found, expected.loaded_results(function)) < 1e-12


def test_batches_are_the_single_answers(pair: tuple[Loaded, Reference]) -> None:
    loaded, expected = pair
    generator = np.random.default_rng(1)
    one = expected.values
    n = 11  # no multiple of a number of lanes
    many = {k: generator.uniform(-1.0, 1.0, (n, len(v))) for k, v in one.items()}
    many["q"][5] = 2e4  # for its sine lanes ask the library
    many["g"] = one["g"]
    for function in loaded.library.all_functions:
        for loads in ({}, {"fext": None}):
            values = many | loads
            batch = loaded.call(function, values, n=n)
            for k in range(n):
                row = {
                    key: v if key == "g" or v is None else np.ascontiguousarray(v[k])
                    for key, v in values.items()
                }
                for whole, single in zip(batch, loaded.call(function, row), strict=True):
                    scale = max(1.0, abs(single).max())
                    np.testing.assert_allclose(
                        whole.reshape(n, -1)[k], single, 1e-12, 1e-12 * scale
                    )


def test_batches_without_lanes_are_the_single_answers(tmp_path: Path) -> None:
    bodies, few = bodies_of_seed(3, 5), ("inverse_dynamics", "joint_space_inertia")
    folder = write_c(bodies, tmp_path / "robot", few)
    assert "ROBOT_LANES" in (folder / "robot_inverse_dynamics.c").read_text()
    path = build(COMPILERS[0], folder, ["-shared", "-fPIC", "-DROBOT_NO_LANES"], "robot.so")
    loaded, one = Loaded(path, library(bodies, few)), {**reference(bodies).values, "fext": None}
    values = {k: np.stack([v, v]) if v is not None and k != "g" else v for k, v in one.items()}
    for function in loaded.library.all_functions:
        single = loaded.call(function, one)
        for whole, once in zip(loaded.call(function, values, n=2), single, strict=True):
            np.testing.assert_array_equal(whole.reshape(2, -1), np.stack([once, once]))


def test_floats_have_no_lanes(tmp_path: Path) -> None:
    folder = write_c(bodies_of_seed(2), tmp_path, ("inverse_dynamics",), real="float")
    assert not list(folder.glob("*lanes*"))


def test_extreme_values_give_numbers_or_none_but_never_a_trap(
    pair: tuple[Loaded, Reference],
) -> None:
    loaded, expected = pair
    generator = np.random.default_rng(2)
    ordinary = expected.values
    inverse = next(f for f in loaded.library.all_functions if f.name == "inverse_dynamics")
    for _ in range(40):
        values = {
            k: np.where(generator.random(len(v)) < 0.3, generator.choice(EXTREMES, len(v)), v)
            for k, v in ordinary.items()
        }
        for function in loaded.library.all_functions:
            loaded.call(function, values)
        broken = {**values, "g": np.full(3, np.nan)}
        assert any(np.isnan(result).any() for result in loaded.call(inverse, broken))


@each_compiler
@pytest.mark.parametrize(
    "options", [{"prefix": "test"}, {"is_single_header": True}, {"real": "float"}]
)
def test_the_test_program_succeeds_under_sanitizers(
    compiler: Compiler, options: dict[str, object], tmp_path: Path
) -> None:
    folder = write_c(bodies_of_seed(1, 3), tmp_path, FEW, **options)
    told = run_tests(build(compiler, folder, list(compiler.sanitizers), "tests"))
    assert "FAILED" not in told
    assert "ok inverse_dynamics: tau with forces" in told


def test_the_test_program_fails_for_wrong_numbers(tmp_path: Path) -> None:
    folder = write_c(bodies_of_seed(2), tmp_path, ("gravity_torque",))
    source = folder / "robot_gravity_torque.c"
    text = source.read_text()
    source.write_text(text.replace("tau[0] = ", "tau[0] = 1.0 + ", 1))
    program = build(COMPILERS[0], folder, [], "tests")
    done = subprocess.run([program], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "FAILED gravity_torque: tau" in done.stdout


def test_long_functions_are_cut_without_loss(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("kindsl.mechanics.dynamics.generation.emitters.c.OPERATIONS_PER_PART", 7)
    folder = write_c(bodies_of_seed(9, 3), tmp_path, FEW)
    text = (folder / "robot_inverse_dynamics.c").read_text()
    assert "robot_inverse_dynamics_loaded_part5(" in text
    assert "FAILED" not in run_tests(build(COMPILERS[0], folder, [], "tests"))


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no C++ compiler")
def test_one_header_tells_that_its_code_is_c(tmp_path: Path) -> None:
    folder = write_c(bodies_of_seed(2), tmp_path, ("poses",), is_single_header=True)
    (folder / "main.cpp").write_text('#define ROBOT_IMPLEMENTATION\n#include "robot.h"\n')
    command = ["g++", "-fsyntax-only", "-fmax-errors=1", "main.cpp"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert "#error ROBOT_IMPLEMENTATION belongs in a C source file" in done.stderr


def test_in_floats_the_test_program_allows_for_rounding_only(tmp_path: Path) -> None:
    """A mistake of a ten-thousandth is found, rounding is not."""
    folder = write_c(bodies_of_seed(2), tmp_path, ("poses",), real="float")
    run_tests(build(COMPILERS[0], folder, [], "tests"))
    source = folder / "robot_poses.c"
    source.write_text(source.read_text().replace("T[0] = ", "T[0] = 1e-4f + ", 1))
    program = build(COMPILERS[0], folder, [], "tests")
    assert subprocess.run([program], capture_output=True, check=False).returncode == 1


def test_accelerations_of_a_long_chain_are_allowed_their_rounding() -> None:
    tree = random_bodies(np.random.default_rng(1), 60, is_floating=False)
    bodies = replace(tree, parents=tuple(range(60)))
    made = library(bodies, ("forward_dynamics", "joint_space_inertia"))
    solved, given = (_tolerance(made, reference(bodies), f) for f in made.all_functions)
    assert TOLERANCES["double"] == given < solved < TOLERANCES["float"]


def test_tolerances_of_the_test_program_are_those_of_the_type() -> None:
    assert TOLERANCES["double"] < 1e-8 < TOLERANCES["float"]


@pytest.mark.skipif(shutil.which("cmake") is None, reason="there is no CMake")
@pytest.mark.parametrize(
    "language",
    ["c", pytest.param("cpp", marks=pytest.mark.skipif(EIGEN is None, reason="there is no Eigen"))],
)
def test_cmake_builds_tests_installs_and_finds(language: str, tmp_path: Path) -> None:
    folder, program = tmp_path / "robot", tmp_path / "program"
    bodies, quantities = bodies_of_seed(2), ("poses", "gravity_torque")
    folder.mkdir()
    made = library(bodies, quantities, language=language)
    for name, text in language_named(language).files(made, reference(bodies)).items():
        (folder / name).write_text(text)
    program.mkdir()
    (program / "main.c").write_text(
        "#include <robot.h>\n"
        "int main(void) { double q[ROBOT_NJ] = {0}, T[ROBOT_NPOSES * 12];\n"
        "robot_poses(&robot_default_model, q, T); return T[0] < -2.0; }\n"
    )
    (program / "main.cpp").write_text(
        "#include <robot.hpp>\n"
        "int main() { const robot::JointVector q = robot::JointVector::Zero();\n"
        "return robot::Model().gravity_torque(q, Eigen::Vector3d::Zero()).hasNaN(); }\n"
    )
    (program / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.13)\nproject(program)\nfind_package(robot REQUIRED)\n"
        f"add_executable(program main.{language})\ntarget_link_libraries(program robot::robot)\n"
    )
    eigen = [f"-DEigen3_ROOT={EIGEN.parent.parent}"] if EIGEN else []
    steps = [
        ["cmake", "-S", folder, "-B", tmp_path / "b", f"-DCMAKE_INSTALL_PREFIX={tmp_path / 'i'}"],
        ["cmake", "--build", tmp_path / "b", "--target", "install"],
        ["ctest", "--test-dir", tmp_path / "b"],
        ["cmake", "-S", program, "-B", tmp_path / "p", f"-DCMAKE_PREFIX_PATH={tmp_path / 'i'}"],
        ["cmake", "--build", tmp_path / "p"],
        [tmp_path / "p" / "program"],
    ]
    for step in steps:
        command = [*step, *eigen] if "-S" in step else step
        done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
        assert done.returncode == 0, done.stdout + done.stderr


def test_every_quantity_is_a_file(tmp_path: Path) -> None:
    folder = write_c(bodies_of_seed(1), tmp_path)
    assert {path.name for path in folder.glob("robot_*.c")} >= {f"robot_{q}.c" for q in PLAIN}
