"""What generated code says of itself: its README, its head, how long its lines are."""

import re
from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from tests.support.robots import LIFT

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.products.codegen.c_text import _wrapped
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.language import language_named
from kindsl.products.codegen.library import Options
from kindsl.robots.interchange.generated_folder import digest

OPTIONS = Options("c", ("poses", "inverse_dynamics"), "double", False, "unbound", "arm")
BOUND = LIFT.replace("mass = 2.0", "mass = m").replace("mass = 1.0", "mass = n")


def files(options: Options, text: str = LIFT) -> dict[str, str]:
    settings = Settings(bindings={name: Binding(1.5) for name in ("m", "n")})
    return generate(Source("arm.kindsl", analyse(text, settings), {}), options)[1]


def test_the_readme_names_what_is_in_which_order() -> None:
    readme = files(OPTIONS)["README.md"]
    assert "| 0 | shoulder | shoulder | revolute | upper |\n" in readme
    assert "| 1 | lift | lift | prismatic | slider |\n" in readme
    assert "| 2 | tool | slider |\n" in readme
    (row,) = [line for line in readme.splitlines() if line.startswith("| `inverse_dynamics`")]
    assert "fext" in row
    (row,) = [line for line in readme.splitlines() if line.startswith("| `poses`")]
    assert "fext" not in row


def test_one_header_tells_how_it_is_included() -> None:
    readme = files(replace(OPTIONS, is_single_header=True))["README.md"]
    assert '`#define ARM_IMPLEMENTATION` before `#include "arm.h"`' in readme
    assert "arm_model_init(&model, &parameters)" in readme
    readme = files(OPTIONS)["README.md"]
    assert "`find_package(arm)` and `target_link_libraries(program arm::arm)`" in readme
    assert "arm_model_init(&model, &parameters)" in readme


def test_gravity_is_shared_by_a_batch_and_has_three_numbers() -> None:
    header = " ".join(files(OPTIONS)["arm.h"].split())
    (batch,) = re.findall(r"void arm_inverse_dynamics_batch\(([^)]*)\)", header)
    assert batch.split(", ") == [
        "long n", "const arm_model *m", "const arm_real q[]", "const arm_real qd[]",
        "const arm_real qdd[]", "const arm_real g[3]", "const arm_real *fext", "arm_real tau[]",
    ]  # fmt: skip


@pytest.mark.parametrize("language", ["python", "jax", "casadi"])
def test_a_module_tells_where_it_is_from(language: str) -> None:
    (module,) = [
        text for name, text in files(replace(OPTIONS, language=language)).items()
        if name.endswith(".py")
    ]  # fmt: skip
    assert module.startswith('"""Kinematics and dynamics of Arm.\n')
    assert f"SHA-256 of the document: {digest(LIFT.encode())}\n" in module


def test_heads_fill_their_lines_and_no_more() -> None:
    lines = files(OPTIONS)["arm.h"].splitlines()
    starts = [number for number, line in enumerate(lines) if line.startswith("void arm_")]
    assert all(len(lines[number]) <= 100 for number in starts)
    assert any(lines[number].endswith(",") for number in starts)


@given(st.lists(st.text("a b[", min_size=1, max_size=70).map(str.strip).filter(bool), min_size=1))
@example(["a" * 92, "b" * 95, "c" * 96, "d"])
@example(["a" * 120, "b"])
def test_a_line_is_cut_where_the_next_part_would_not_fit(parts: list[str]) -> None:
    lines = _wrapped("void f", parts).split("\n")
    assert " ".join(map(str.strip, lines)) == f"void f({', '.join(parts)})"
    assert all(line.startswith("    ") and line[4] != " " for line in lines[1:])
    assert all(len(line) <= 100 or ", " not in line for line in lines)
    for line, behind in pairwise(lines):
        assert len(f"{line} {behind.strip().split(', ')[0].rstrip(',')},") > 100


def test_names_that_are_others_in_code_are_listed() -> None:
    readme = files(OPTIONS, LIFT.replace("shoulder", "class"))["README.md"]
    assert "## Changed names\n\n| document | code |\n| --- | --- |\n| class | class_ |\n" in readme


@pytest.mark.parametrize("language", ["casadi", "jax", "python"])
def test_in_python_names_of_functions_are_others_alone(language: str) -> None:
    text = LIFT.replace("shoulder", "class").replace("upper", "höhe").replace("Arm", "Int")
    options = replace(OPTIONS, language=language, prefix="int_", quantities=("jacobians",))
    library, _ = generate(Source("arm.kindsl", analyse(text, Settings()), {}), options)
    assert language_named(language).renamed(library) == {
        "jacobian_höhe": "jacobian_h_he",
        "jacobian_höhe_in_base": "jacobian_h_he_in_base",
        "Int": "int_",
    }


@pytest.mark.parametrize(
    ("choice", "inputs"),
    [("unbound", []), ("n", ["n"]), ("m, n,", ["m", "n"]), ("all", ["m", "n"])],
)
def test_chosen_parameters_stay_inputs(choice: str, inputs: list[str]) -> None:
    readme = files(replace(OPTIONS, parameters=choice), BOUND).get("README.md", "")
    told = [name for name in ("m", "n") if f"| {name} | {name} | 1.5 |" in readme]
    assert told == inputs
    assert ("## Parameters\n" in readme) is bool(inputs)
    assert "## Changed names" not in readme


@pytest.mark.parametrize("language", ["c", "cpp", "robcogen"])
def test_a_parameter_without_value_is_not_a_number_until_it_is_set(language: str) -> None:
    options = replace(OPTIONS, language=language, parameters="all")
    bound = Settings(bindings={"m": Binding(1.5)})
    _, made = generate(Source("arm.kindsl", analyse(BOUND, bound), {}), options)
    told = "".join(made.values())
    unknown, known = {
        "c": ("parameters.n = (arm_real)NAN;", "parameters.m = 1.5;"),
        "cpp": ("quiet_NaN", "1.5"),
        "robcogen": ("double n = std::numeric_limits<double>::quiet_NaN();", "double m = 1.5;"),
    }[language]
    assert unknown in told
    assert known in told
    if language == "c":
        assert "    arm_real m; /* 1.5 */\n    arm_real n; /* unbound */\n" in made["arm.h"]
    if language == "cpp":
        assert "    arm_model model{arm_parameters()};" in made["arm_test.cpp"]


def test_the_readme_tells_the_columns_of_feet() -> None:
    readme = files(replace(OPTIONS, quantities=("foot_jacobians",)))["README.md"]
    assert "Columns of the foot Jacobians:\n" in readme
    assert "| tool | shoulder, lift |\n" in readme
    assert "Columns" not in files(OPTIONS)["README.md"]


def test_each_source_tells_where_it_is_from() -> None:
    for name, text in files(OPTIONS).items():
        if name.endswith((".c", ".h")):
            head = text.partition("*/")[0]
            assert head.startswith("/* "), name
            assert "from arm.kindsl; do not edit." in head
            assert f"SHA-256 of the document: {digest(LIFT.encode())}\n" in head
            assert "Options: kindsl generate arm.kindsl --language c --name arm" in head


@pytest.mark.parametrize("language", ["python", "jax"])
def test_an_energy_is_one_number_and_a_matrix_is_one(language: str) -> None:
    options = replace(OPTIONS, language=language, quantities=("energies", "joint_space_inertia"))
    (module,) = [text for name, text in files(options).items() if name.endswith(".py")]
    for name, shape in (
        ("kinetic_energy", ()),
        ("potential_energy", ()),
        ("joint_space_inertia", (2, 2)),
    ):
        assert f"_answer(_{name}, {(shape,)!r}, parameters" in module
