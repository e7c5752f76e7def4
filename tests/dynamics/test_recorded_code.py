"""What generated functions take, what they cost, and what they give for one input.

The answers are in `recorded/code.txt`; how they get there: `tests/support/recorded.py`. That they
are right is compared with the book's form elsewhere.
"""

from collections import Counter
from collections.abc import Iterator
from math import cos
from pathlib import Path
from typing import get_args

import numpy as np
from tests.codegen.robots import bodies_of_seed
from tests.support.recorded import assert_as_recorded

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.generation.emitters.scalar_python import scalar_function
from kindsl.mechanics.dynamics.generation.function import Function, Result, inputs_of
from kindsl.mechanics.dynamics.generation.functions import QUANTITIES
from kindsl.mechanics.dynamics.generation.robot import robot_of
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar, Term
from kindsl.mechanics.dynamics.generation.trace import Conditions, Trace, trace
from kindsl.mechanics.dynamics.quantities import Quantity

RECORDED = Path(__file__).parent / "recorded" / "code.txt"
# A fixed and a floating base, both with branches and both kinds of joints.
ROBOTS = {"fixed": bodies_of_seed(4), "floating": bodies_of_seed(31)}


def costs(recorded: Trace) -> str:
    """Return how many operations of each kind the outputs take."""
    kinds = Counter(recorded.graph.nodes[index][0] for index in recorded.needed())
    return " ".join(f"{kind} {kinds[kind]}" for kind in sorted(kinds) if kind != "input")


def fingerprint(values: list[float]) -> str:
    """Return two sums of numbers that no single one can leave unnoticed."""
    size = max(1.0, *map(abs, values))
    sums = (sum(cos(shift + 1.7 * k) * v for k, v in enumerate(values)) for shift in (0.0, 1.0))
    return " ".join(f"{total / size:.9f}" for total in sums) + f" of {size:.6g}"


def given(recorded: Trace) -> str:
    """Return what the outputs are for one input, as a fingerprint."""
    inputs = [
        np.array([0.3 + cos(1.0 + 2.3 * k + row) for k in range(len(argument))])
        for row, argument in enumerate(recorded.arguments)
    ]
    return fingerprint(list(scalar_function(recorded)(*inputs)))


def of_traces(bodies: Bodies) -> Iterator[str]:
    robot = robot_of(bodies)
    for quantity in get_args(Quantity):
        for conditions in get_args(Conditions)[:2]:
            recorded = trace(robot, quantity, conditions)
            yield f"{quantity} {conditions}: {costs(recorded)}"
            yield f"    {given(recorded)}"


def of_functions(bodies: Bodies) -> Iterator[str]:
    robot = robot_of(bodies)
    inputs = inputs_of(robot)
    for name, quantity in QUANTITIES.items():
        yield f"## {name}: {quantity.needs_mass} {bool(quantity.group)}"
        for function in quantity.build(robot, inputs):
            arguments = ", ".join(f"{a.name} {len(a.components)}" for a in function.arguments)
            yield f"{function.name}({arguments}) {function.about}: {function.summary}"
            for results in filter(None, (function.results, function.loaded)):
                yield from of_results(results, function, robot.graph)


def of_results(results: tuple[Result, ...], function: Function, graph: Graph) -> Iterator[str]:
    every = [Term(graph, index) for index in graph.inputs]
    entries: list[Scalar] = [entry for result in results for entry in result.entries]
    recorded = Trace(graph, [every], entries)
    own = {x.index for argument in function.arguments for x in argument.components}
    others = {x.index for x in every}.intersection(recorded.needed()) - own
    yield f"    {', '.join(f'{r.name} {r.shape}' for r in results)}: {costs(recorded)}"
    yield f"        {given(recorded)}, with {len(others)} inputs besides"


def code() -> Iterator[str]:
    for name, bodies in ROBOTS.items():
        yield f"# {name} base, {bodies.joint_kinds}, {len(bodies.frames)} frames"
        yield from of_traces(bodies)
        yield from of_functions(bodies)


def test_generated_code_is_as_recorded() -> None:
    assert_as_recorded(RECORDED, code())
