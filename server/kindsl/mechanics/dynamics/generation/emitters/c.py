"""Writes functions in C11: straight lines, or parts that share values on the caller's stack.

Compilers take more than linear time for long functions; in parts of some hundred operations they
are two to three times as quick, and what they make runs no slower.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import groupby
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.emitters.straight_line import (
    Notation,
    Part,
    computed,
    cut,
)
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar, Term

OPERATIONS_PER_PART = 500
# So many equal constants one after the other are written in a loop; a regressor has thousands.
SHORTEST_LOOP = 8
# Smaller numbers than this are zero as a float.
SMALLEST_FLOAT = 1.2e-38
LARGEST_FLOAT = 3.4e38

WORKSPACE = "w"


@dataclass(frozen=True, slots=True)
class Dialect:
    """The notation of numbers.

    Attributes:
        type: The type of all values.
        suffix: Of numbers and of the functions `sin` and `cos`.
        noinline: The prefix of a function that is to stay one.
        constant: How a number is written that is a result by itself.
        sign: How the sign of a value is computed.
    """

    type: str
    suffix: str
    noinline: str = ""
    constant: str = "{}"
    sign: str = "{0} > 0 ? 1 : {0} < 0 ? -1 : {0}"


class CArray(NamedTuple):
    """An array that a function takes or fills.

    Attributes:
        name: Its name.
        declaration: Of the parameter.
        entries: Its values; None where a function leaves the old one.
    """

    name: str
    declaration: str
    entries: Sequence[Scalar | None]


class CBody(NamedTuple):
    """The body of a function in C.

    Attributes:
        name: The function's name.
        takes: Arguments.
        gives: Results that it fills.
        known: Texts of nodes that are given otherwise, through `context`.
        context: Name and declaration of a parameter that `known` reads, if any.
    """

    name: str
    takes: Sequence[CArray]
    gives: Sequence[CArray]
    known: Mapping[int, str]
    context: tuple[str, str] | None = None


def c_definition(graph: Graph, body: CBody, dialect: Dialect, linkage: str = "") -> str:
    """Return the definition of a function, after those of its parts if it is long.

    Args:
        graph: Where its values are recorded.
        body: Its statements.
        dialect: How numbers are written.
        linkage: Its prefix: `"static "` or nothing.
    """
    writer = _Writer(graph, body, dialect)
    order = computed(graph, [e for a in body.gives for e in a.entries], writer.given)
    parts = cut(graph, order, OPERATIONS_PER_PART)
    written = [writer.written(part) for part in parts.parts]
    written[-1] = writer.with_the_rest(written[-1])
    arrays = _arrays(body)
    head = f"{linkage}void {body.name}({_declared(arrays)})\n"
    if len(written) == 1:
        unused = [f"(void){name};" for name, _ in arrays if name not in written[0].uses]
        return head + _block([*unused, *written[0].lines])
    sources, calls = [], []
    for number, part in enumerate(written):
        name = f"{body.name}_part{number}"
        used = [(n, d) for n, d in arrays if n in part.uses]
        if WORKSPACE in part.uses:
            used.append((WORKSPACE, f"{dialect.type} *restrict {WORKSPACE}"))
        sources.append(
            f"{dialect.noinline}static void {name}({_declared(used)})\n{_block(part.lines)}"
        )
        calls.append(f"{name}({', '.join(n for n, _ in used)});")
    uses = frozenset[str]().union(*(part.uses for part in written))
    unused = [f"(void){name};" for name, _ in arrays if name not in uses]
    workspace = [f"{dialect.type} {WORKSPACE}[{parts.n_kept}];"] if parts.n_kept else []
    return "\n".join([*sources, head + _block([*workspace, *unused, *calls])])


def literal(value: float, dialect: Dialect) -> str:
    """Return a number as C takes it, without loss.

    Raises:
        OverflowError: It is not finite in that type.
    """
    if dialect.suffix and abs(value) < SMALLEST_FLOAT:
        value = 0.0
    if not math.isfinite(value):
        raise OverflowError(f"{value!r} is too large for 'double'")
    if dialect.suffix and abs(value) > LARGEST_FLOAT:
        raise OverflowError(f"{value!r} is too large for 'float': use --real double")
    text = f"{value!r}{dialect.suffix}"
    return f"({text})" if text.startswith("-") else text


class _Written(NamedTuple):
    """Statements, and the names of the arrays in them."""

    lines: list[str]
    uses: frozenset[str]


class _Writer:
    """Writes the parts of one function in order.

    Attributes:
        given: Array and text of each node that is not computed.
    """

    def __init__(self, graph: Graph, body: CBody, dialect: Dialect) -> None:
        self._graph = graph
        self._dialect = dialect
        self._notation = Notation(
            partial(literal, dialect=dialect), f"{{0}}{dialect.suffix}({{1}})", dialect.sign
        )
        context = body.context[0] if body.context else ""
        self.given = {node: (context, text) for node, text in body.known.items()}
        for array in body.takes:
            for number, entry in enumerate(array.entries):
                if isinstance(entry, Term):
                    self.given[entry.index] = (array.name, f"{array.name}[{number}]")
        self._kept: dict[int, str] = {}
        self._computed: dict[int, list[tuple[str, str]]] = {}
        self._rest: list[tuple[str, int, Scalar]] = []
        for array in body.gives:
            for number, entry in enumerate(array.entries):
                if isinstance(entry, Term) and entry.index not in self.given:
                    place = f"{array.name}[{number}]"
                    self._computed.setdefault(entry.index, []).append((array.name, place))
                elif entry is not None:
                    self._rest.append((array.name, number, entry))

    def written(self, part: Part) -> _Written:
        """Return the statements of a part."""
        lines, uses, local = list[str](), set[str](), set[int]()
        for node in part.nodes:
            text = self._notation.operation(self._graph, node, partial(self._text, local, uses))
            local.add(node)
            lines.append(f"const {self._dialect.type} x{node} = {text};")
            if node in part.kept:
                uses.add(WORKSPACE)
                lines.append(f"{WORKSPACE}[{part.kept[node]}] = x{node};")
            for array, place in self._computed.get(node, ()):
                uses.add(array)
                lines.append(f"{place} = x{node};")
        self._kept.update((node, f"{WORKSPACE}[{place}]") for node, place in part.kept.items())
        return _Written(lines, frozenset(uses))

    def with_the_rest(self, last: _Written) -> _Written:
        """Return the last part with what is not computed: constants and copies of arguments."""
        lines, uses = list(last.lines), set(last.uses)
        for array, numbers, text in self._runs(uses):
            uses.add(array)
            if len(numbers) < SHORTEST_LOOP:
                lines += [f"{array}[{number}] = {text};" for number in numbers]
            else:
                head = f"for (int i = {numbers[0]}; i < {numbers[-1] + 1}; i++) {{"
                lines += [head, f"    {array}[i] = {text};", "}"]
        return _Written(lines, frozenset(uses))

    def _runs(self, uses: set[str]) -> Iterator[tuple[str, list[int], str]]:
        """Yield arrays, places that follow one another there, and the text of what all hold."""
        rest = []
        for array, number, entry in self._rest:
            text = self._notation.word(entry, partial(self._text, set(), uses))
            if not isinstance(entry, Term):
                text = self._dialect.constant.format(text)
            rest.append((array, number, text))
        runs = groupby(enumerate(rest), lambda pair: (pair[1][0], pair[1][2], pair[1][1] - pair[0]))
        for (array, text, _), run in runs:
            yield array, [number for _, (_, number, _) in run], text

    def _text(self, local: set[int], uses: set[str], node: int) -> str:
        if node in local:
            return f"x{node}"
        array, text = self.given.get(node) or (WORKSPACE, self._kept[node])
        uses.add(array)
        return text


def _arrays(body: CBody) -> list[tuple[str, str]]:
    context = [body.context] if body.context else []
    return [*context, *((a.name, a.declaration) for a in (*body.takes, *body.gives))]


def _declared(arrays: Sequence[tuple[str, str]]) -> str:
    return ", ".join(declaration for _, declaration in arrays) or "void"


def _block(lines: Sequence[str]) -> str:
    return "{\n" + "".join(f"    {line}\n" for line in lines) + "}\n"
