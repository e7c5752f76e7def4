"""What is recorded for a library gives, number by number, the right answers of its test program."""

import numpy as np
import pytest
from tests.codegen.robcogen.test_classes import VALUES
from tests.codegen.robcogen.test_kernels import MOVING, TRANSFORMS
from tests.codegen.robots import ALL, bodies_of_seed, library, reference
from tests.support.differences import worst_difference

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.mechanics.dynamics.generation.emitters.numbers import evaluate
from kindsl.mechanics.dynamics.generation.function import Function, Result
from kindsl.mechanics.dynamics.generation.terms import Term
from kindsl.mechanics.spatial.arrays import Array
from kindsl.products.codegen.c_test_program import parameter_values
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.library import Library, Options
from kindsl.products.codegen.reference import Reference, sample
from kindsl.products.codegen.resistance import magnification


def test_rounding_is_magnified_by_the_condition_of_what_is_solved() -> None:
    M = np.eye(8)
    M[0, 1] = M[1, 0] = 0.5
    M[6, 7] = M[7, 6] = 0.8
    units = np.array([1e3, 1e-3, 2.0, 1.0, 1.0, 1.0, 10.0, 0.1])
    for inertia in (M, M * np.outer(units, units)):
        found = [
            magnification(name, inertia, 2)
            for name in ("gravity_torque", "inverse_dynamics", "forward_dynamics")
        ]
        assert found == pytest.approx([1.0, 1.5 / 0.5, 1.8 / 0.2])
    assert magnification("inverse_dynamics", np.eye(2), 2) == 1.0


# Frames of joints among those of links.
WITH_JOINTS = TRANSFORMS.replace(
    "{\n    base",
    "{\n    base=fr_L2, target=fr_R1 base=hand, target=fr_L1 base=fr_L2, target=tip\n    base",
).replace("Frames { ", "Frames { fr_L1, fr_L2, fr_R1, ")


@pytest.fixture(scope="module", params=[4, 3, None], ids=["fixed", "floating", "transforms"])
def pair(request: pytest.FixtureRequest) -> tuple[Library, Reference]:
    """All functions of a robot, or those between all of its frames, and the right answers."""
    if request.param is None:
        bindings = {name: Binding(value) for name, value in VALUES.items()}
        analysis = kindsl.parse(MOVING, Settings(bindings=bindings))
        options = Options("c", ("poses",), "double", False, "unbound", "crab")
        made, _ = generate(Source("crab.kindsl", analysis, {}, WITH_JOINTS), options)
        mechanics = analysis.mechanism()
        return made, Reference(mechanics, sample(mechanics.bodies))
    bodies = bodies_of_seed(request.param, 4)
    return library(bodies, ALL), reference(bodies)


def answers(
    made: Library, function: Function, results: tuple[Result, ...], values: dict[str, Array]
) -> list[Array]:
    """Return what results evaluate to."""
    given = [(values["fext"], made.external)]
    given += [(values[a.name], a.components) for a in function.arguments]
    numbers = {
        term.index: float(value)
        for array, components in given
        for value, term in zip(array, components, strict=True)
        if isinstance(term, Term)
    }
    return [
        np.array(evaluate(made.robot.graph, numbers, result.entries)).reshape(result.shape)
        for result in results
    ]


def test_each_function_gives_the_right_answer(pair: tuple[Library, Reference]) -> None:
    made, expected = pair
    for function in made.all_functions:
        found = answers(made, function, function.results, expected.values)
        right = expected.results(function)
        assert [x.shape for x in found] == [r.shape for r in function.results]
        assert worst_difference([x.ravel() for x in found], right) < 1e-9, function.name
        if function.loaded is not None:
            found = answers(made, function, function.loaded, expected.values)
            right = expected.loaded_results(function)
            assert worst_difference([x.ravel() for x in found], right) < 1e-9, function.name


def test_parameters_without_a_value_have_different_ones() -> None:
    values = parameter_values([("a", None), ("b", 2.0), ("c", None)])
    assert values == pytest.approx({"a": 0.3, "b": 2.0, "c": 0.4})


def test_sampled_values_are_small_and_all_different(pair: tuple[Library, Reference]) -> None:
    values = {name: value for name, value in pair[1].values.items() if name != "active"}
    everything = np.concatenate([*values.values()])
    assert abs(everything).max() < 10.0
    assert len({*everything.tolist()}) > 0.9 * len(everything)
