"""Names in generated code are names in every language, and differ."""

import keyword
import re
import subprocess
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.codegen.compiling import EIGEN, Compiler, each_compiler
from tests.codegen.robots import bodies_of_seed, library

from kindsl.mechanics.dynamics.bodies import BodyFrame
from kindsl.products.codegen.names_in_code import (
    RESERVED,
    UnusableNameError,
    file_name,
    identifier,
    identifiers,
    is_reserved,
    prefix_of,
)

ODD = [*sorted(RESERVED), "a.b", "a_b"]
NAMES = st.one_of(st.text(min_size=1, max_size=6), st.sampled_from(ODD))


@settings(max_examples=300, deadline=None, derandomize=True)
@given(st.lists(NAMES, max_size=8, unique=True))
def test_names_are_valid_and_differ(names: list[str]) -> None:
    found = identifiers(names)
    assert list(found) == names
    assert len(set(found.values())) == len(names)
    for safe in found.values():
        assert re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", safe)
        assert not is_reserved(safe)


HEADERS = """
    assert complex ctype errno float inttypes limits math stdbool stddef stdint stdio stdlib string
    time
"""
EIGEN_AND_COMPANY = ("Eigen/Dense", "chrono", "fstream", "iostream", "memory", "mutex", "thread")


@each_compiler
@pytest.mark.parametrize("standard", ["c99", "gnu17", "c++14", "gnu++20"])
def test_no_name_is_a_macro_of_a_header(compiler: Compiler, standard: str) -> None:
    headers = [f"{name}.h" for name in HEADERS.split()]
    language, folder = "c", []
    if "+" in standard:
        language, folder = "c++", [f"-I{EIGEN}"] if EIGEN else []
        headers += EIGEN_AND_COMPANY[0 if EIGEN else 1 :]
    text = "".join(f"#include <{name}>\n" for name in headers)
    command = [*compiler.command, f"-std={standard}", *folder, "-x", language, "-dM", "-E", "-"]
    told = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
    macros = re.findall(r"^#define ([A-Za-z]\w*)(?: |$)", told, flags=re.M)
    assert len(macros) > 200
    assert [name for name in macros if not is_reserved(name)] == []


def test_names_of_robots_are_no_macros() -> None:
    names = "L1 L_MAX EE ELBOW LC_ANKLE LF_HAA M_ARM MOD_A INTAKE SYS_BASE INT_ARM LINK1_MAX"
    assert [name for name in names.split() if is_reserved(name)] == []


def test_prefixes() -> None:
    assert prefix_of("HyQ", None) == "hyq"
    assert prefix_of("", None) == "robot"
    assert prefix_of("Int", None) == "int_"
    assert identifier("2") == "x2"
    assert prefix_of("Gamma", None) == "gamma_"  # a function of <math.h>
    assert not keyword.iskeyword(prefix_of("Class", None))
    with pytest.raises(UnusableNameError, match="'time' is a reserved word in C"):
        prefix_of("Clock", "time")


def test_a_files_name_ends_no_comment() -> None:
    assert file_name('a*/b\n"""\\.kindsl') == "a__b_____.kindsl"


def test_functions_of_frames_called_like_other_functions_differ() -> None:
    bodies = bodies_of_seed(2)
    frames = tuple(
        BodyFrame(name, 1, bodies.frames[0].body_R_frame, bodies.frames[0].body_r_frame)
        for name in ("tip", "tip_batch", "tip_in_base", "drift_tip")
    )
    renamed = library(replace(bodies, frames=frames), ("jacobians", "frame_motions"))
    names = [renamed.function_names[function.key] for function in renamed.all_functions]
    names += [f"{name}_batch" for name in names]
    assert len(set(names)) == len(names)
    assert {"jacobian_tip_in_base", "acceleration_drift_tip"} <= {*names}
