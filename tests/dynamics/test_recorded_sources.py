"""A small program with every operation, as each emitter writes it.

The texts are in `recorded/sources.txt`; how they get there: `tests/support/recorded.py`.
"""

from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.support.recorded import assert_as_recorded

from kindsl.mechanics.dynamics.generation.emitters import c
from kindsl.mechanics.dynamics.generation.emitters.c import CBody, Dialect, c_definition, literal
from kindsl.mechanics.dynamics.generation.emitters.numpy_rows import batch_source
from kindsl.mechanics.dynamics.generation.emitters.python_lines import python_function
from kindsl.mechanics.dynamics.generation.emitters.scalar_python import scalar_source
from kindsl.mechanics.dynamics.generation.emitters.straight_line import computed, cut, setup_nodes
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar, cosine_and_sine, operations
from kindsl.mechanics.dynamics.generation.trace import Trace

RECORDED = Path(__file__).parent / "recorded" / "sources.txt"
DOUBLE, FLOAT = Dialect("double", ""), Dialect("float", "f", "NOINLINE ", "wide({})")


def program() -> Trace:
    graph = Graph()
    (x, y, angle), (z, _) = arguments = [graph.vector(3), graph.vector(2)]
    cosine, sine = cosine_and_sine(angle)
    shared = x * y + 0.25
    long = sum((z * float(k) + cosine for k in range(2, 9)), start=shared * shared)
    outputs: list[Scalar] = [
        x + y, x - y, x * -2.5, x / z, -z, cosine * sine, shared, shared, long, 0.0, -0.0, 1.5,
        -3.0, y, 1e-40, shared - z,
    ]  # fmt: skip
    return Trace(graph, arguments, outputs)


def sources(patch: pytest.MonkeyPatch) -> Iterator[str]:
    recorded = program()
    graph, outputs = recorded.graph, recorded.outputs
    yield "## nodes"
    yield from (f"{index}: {node}" for index, node in enumerate(graph.nodes))
    yield f"needed {recorded.needed()}, {operations(graph, outputs)} operations"
    yield "## scalars"
    yield from scalar_source(recorded).splitlines()
    yield "## rows"
    rows, n_scratch, constants = batch_source(recorded)
    yield from rows.splitlines()
    yield f"{n_scratch} rows besides, {constants}"
    yield "## lines"
    named = dict(zip("qp", recorded.arguments, strict=True))
    results = [outputs[:5], outputs[5:]]
    yield from python_function(graph, "f", named, results).splitlines()
    given = {"q": [0.0, *recorded.arguments[0][:2]], "none": []}
    yield from python_function(graph, "g", given, [outputs[:2], []]).splitlines()
    for size in (500, 6):
        patch.setattr(c, "OPERATIONS_PER_PART", size)
        for dialect in (DOUBLE, FLOAT):
            yield f"## {dialect.type}, {size} operations a part"
            yield from c_definition(graph, body(recorded), dialect, "static ").splitlines()
    order = computed(graph, outputs, graph.inputs)
    for size in (1, 4, 100):
        yield f"## cut by {size}"
        parts = cut(graph, order, size)
        yield f"{parts.n_kept} kept"
        yield from (f"{part.nodes} {part.kept}" for part in parts.parts)
    found = setup_nodes(graph, [graph.inputs[0], graph.inputs[1]], order)
    yield f"set up {sorted(found)}"
    yield f"nothing {cut(graph, [], 3)}"


def body(recorded: Trace) -> CBody:
    takes = dict(zip("qp", recorded.arguments, strict=True))
    gives = {"a": recorded.outputs[:5], "b": recorded.outputs[5:], "none": []}
    known = {recorded.arguments[0][0].index: "m->x"}
    declared = {name: f"const double {name}[]" for name in takes}
    declared |= {name: f"double {name}[]" for name in gives}
    return CBody("f", takes, gives, known, ("m", "const model *m"), declared=declared)


def test_sources_are_as_recorded(monkeypatch: pytest.MonkeyPatch) -> None:
    assert_as_recorded(RECORDED, sources(monkeypatch))


@pytest.mark.parametrize(
    ("value", "as_double", "as_float"),
    [
        (1.5, "1.5", "1.5f"),
        (-1.5, "(-1.5)", "(-1.5f)"),
        (0.0, "0.0", "0.0f"),
        (1.2e-38, "1.2e-38", "1.2e-38f"),
        (1.1e-38, "1.1e-38", "0.0f"),
        (-1.1e-38, "(-1.1e-38)", "0.0f"),
        (3.4e38, "3.4e+38", "3.4e+38f"),
        (3.5e38, "3.5e+38", None),
        (-3.5e38, "(-3.5e+38)", None),
        (float("inf"), None, None),
        (float("nan"), None, None),
    ],
)
def test_numbers_are_written_as_the_type_takes_them(
    value: float, as_double: str | None, as_float: str | None
) -> None:
    for dialect, expected in ((DOUBLE, as_double), (FLOAT, as_float)):
        if expected is None:
            kind = "'double'" if as_double is None else "'float': use --real double"
            with pytest.raises(OverflowError) as refused:
                literal(value, dialect)
            assert str(refused.value) == f"{value!r} is too large for {kind}"
        else:
            assert literal(value, dialect) == expected
