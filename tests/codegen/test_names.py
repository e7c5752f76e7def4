"""Names in generated code are names in every language, and differ."""

import keyword
import re
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.codegen.robots import bodies_of_seed, library

from kindsl.mechanics.dynamics.bodies import BodyFrame
from kindsl.products.codegen.names_in_code import (
    RESERVED,
    UnusableNameError,
    file_name,
    identifier,
    identifiers,
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
        assert safe not in RESERVED


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
