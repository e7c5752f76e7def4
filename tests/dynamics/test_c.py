"""Functions in C: what parts take, what they share, and that each entry is written once."""

import re

import pytest

from kindsl.mechanics.dynamics.generation.emitters import c
from kindsl.mechanics.dynamics.generation.emitters.c import (
    SHORTEST_LOOP,
    CBody,
    Dialect,
    c_definition,
)
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar

DOUBLE = Dialect("double", "")
FUNCTION = re.compile(r"void (\w+)\((.*)\)\n\{\n((?: {4}.*\n)*)\}")
ASSIGNED = re.compile(r"(\w+)\[(\d+|i)\] = (.*);")
LOOP = re.compile(r"for \(int i = (\d+); i < (\d+); i\+\+\) \{")


def _functions(text: str) -> dict[str, tuple[list[str], str]]:
    """Return parameter names and body of each function, in order."""
    return {
        name: ([] if given == "void" else re.findall(r"(\w+)(?:\[\])?(?:, |$)", given), body)
        for name, given, body in FUNCTION.findall(text)
    }


def _written(body: str) -> dict[tuple[str, int], str]:
    """Return what a body leaves in each entry of its arrays."""
    found: dict[tuple[str, int], str] = {}
    places = range(0)
    for line in body.splitlines():
        if loop := LOOP.search(line):
            places = range(int(loop[1]), int(loop[2]))
        elif assigned := ASSIGNED.search(line):
            array, place, value = assigned.groups()
            for at in places if place == "i" else [int(place)]:
                assert (array, at) not in found
                found[array, at] = value
    return found


def _definition(outputs: list[Scalar | None], takes: dict[str, list[Scalar]], graph: Graph) -> str:
    return c_definition(graph, CBody("f", takes, {"o": outputs}), DOUBLE)


@pytest.mark.parametrize("length", [1, SHORTEST_LOOP - 1, SHORTEST_LOOP, SHORTEST_LOOP + 3])
@pytest.mark.parametrize("first", [0, 2])
def test_runs_of_one_constant_are_loops(length: int, first: int) -> None:
    """And every entry has its value, those around the run and those left alone too."""
    entries: list[Scalar | None] = [1.5] * first + [7.0] * length + [None, 7.0, -2.0]
    text = _definition(entries, {}, Graph())
    (body,) = (body for _, body in _functions(text).values())
    assert len(LOOP.findall(body)) == (length >= SHORTEST_LOOP)
    expected = {
        ("o", at): f"({value!r})" if value < 0.0 else repr(value)
        for at, value in enumerate(entries)
        if isinstance(value, float)
    }
    assert _written(body) == expected


def test_a_part_takes_what_it_uses(monkeypatch: pytest.MonkeyPatch) -> None:
    """A compiler that is told to warns of all else."""
    monkeypatch.setattr(c, "OPERATIONS_PER_PART", 2)
    graph = Graph()
    x, y, z = graph.vector(3)
    shared = x * y
    alone: list[Scalar | None] = [x + 1.0, x - 2.0, z + 3.0, z * 4.0]
    for outputs in (alone, [*alone, shared, y + 3.0, shared + 5.0, y * 6.0, shared * z]):
        takes: dict[str, list[Scalar]] = {"a": [2.5, x, y], "b": [z]}
        functions = _functions(_definition(outputs, takes, graph))
        *parts, (name, (arguments, whole)) = functions.items()
        assert name == "f" and arguments == ["a", "b", "o"]
        calls = [line.strip() for line in whole.splitlines() if "_part" in line]
        assert calls == [f"{part}({', '.join(given)});" for part, (given, _) in parts]
        for _, (given, body) in parts:
            assert {*given} == {*re.findall(r"\b([a-w])\[", body)}
        assert ("double w[" in whole) == any("w" in given for _, (given, _) in parts)


@pytest.mark.parametrize("size", [2, 500])
def test_what_is_known_is_read_from_its_context(size: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(c, "OPERATIONS_PER_PART", size)
    graph = Graph()
    x, mass = graph.vector(2)
    outputs: list[Scalar | None] = [x + 1.0, x * 2.0, x * mass, mass + 3.0]
    known, context = {mass.index: "m->mass"}, ("m", "const model *m")
    body = CBody("f", {"a": [x]}, {"o": outputs}, known, context)
    text = c_definition(graph, body, DOUBLE)
    assert "(void)" not in text
    for given, inside in _functions(text).values():
        assert ("m" in given) == ("m->mass" in inside or "(m, " in inside)


def test_a_member_of_the_context_is_no_argument(monkeypatch: pytest.MonkeyPatch) -> None:
    """The centre of mass is `c`, and what parameters decide `m->c`."""
    monkeypatch.setattr(c, "OPERATIONS_PER_PART", 1)
    graph = Graph()
    x, length = graph.vector(2)
    known, context = {length.index: "m->c[0]"}, ("m", "const model *m")
    body = CBody("f", {"a": [x]}, {"c": [x * length + 1.0]}, known, context)
    taken = [given for given, _ in _functions(c_definition(graph, body, DOUBLE)).values()]
    assert taken == [["m", "a", "w"], ["c", "w"], ["m", "a", "c"]]


@pytest.mark.parametrize("size", [2, 500])
def test_a_template_reads_all_before_it_stores(size: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """So the array that it fills may be the one that it takes."""
    monkeypatch.setattr(c, "OPERATIONS_PER_PART", size)
    monkeypatch.setattr(c, "MOST_IN_TEMPLATE", size)
    graph = Graph()
    x, y, z = graph.vector(3)
    outputs: list[Scalar | None] = [y, x + y, None, x * y - z, 2.0, x]
    dialect = Dialect("S", sign="", number="S({})", parameter="S", scalar="S")
    body = CBody("f", {"a": [x, y, z]}, {"o": outputs})
    functions = _functions(c_definition(graph, body, dialect))
    assert (len(functions) > 1) == (size == 2)
    *parts, (_, whole) = functions.values()
    assert not any("o[" in inside for _, inside in parts)
    assert "a[" not in whole[whole.index("o[") :] and "_part" not in whole[whole.index("o[") :]
    assert {place for _, place in _written(whole[whole.index("    o[") :])} == {0, 1, 3, 4, 5}
