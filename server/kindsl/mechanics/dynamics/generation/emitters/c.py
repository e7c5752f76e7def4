"""Writes functions in C11 and C++: straight lines, or parts that share values on the stack.

Compilers take more than linear time for long functions; in parts of some hundred operations they
are two to three times as quick, and what they make runs no slower.
"""

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import groupby
from types import MappingProxyType
from typing import NamedTuple, TypeGuard

from kindsl.mechanics.dynamics.generation.emitters.straight_line import (
    Notation,
    Part,
    Parts,
    computed,
    cut,
    depth_first,
)
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar, Term, operand_nodes

OPERATIONS_PER_PART = 500
# Compilers take one template of this size well.
MOST_IN_TEMPLATE = 3500
# So many equal constants one after the other are written in a loop; a regressor has thousands.
SHORTEST_LOOP = 8
# Smaller numbers than this are zero as a float.
SMALLEST_FLOAT = 1.2e-38
LARGEST_FLOAT = 3.4e38

WORKSPACE = "w"
# Neither the suffix of a number, as in `0.5f`, nor a member, as in `m->c`.
_WORD = re.compile(r"(?<![\w.])(?<!->)[A-Za-z_]\w*")


@dataclass(frozen=True, slots=True)
class Dialect:
    """The notation of numbers and functions.

    Templates store results when all is computed, so an argument may be a result as well; their
    operations stand near their uses, depth first.

    Attributes:
        type: The type of all values.
        suffix: Of numbers and of the functions `sin` and `cos`.
        noinline: The prefix of a function that is to stay one.
        constant: How a number is written that is a result by itself.
        sign: How the sign of a value is computed, where that is no call.
        number: How a number is written.
        scope: What stands before the name of a called function.
        parameter: The template's parameter; nothing in C.
        scalar: The type of values in declarations of templates.
    """

    type: str
    suffix: str = ""
    noinline: str = ""
    constant: str = "{}"
    sign: str = "{0} > 0 ? 1 : {0} < 0 ? -1 : {0}"
    number: str = "{}"
    scope: str = ""
    parameter: str = ""
    scalar: str = ""

    @property
    def call(self) -> str:
        """The name of `sin` or `cos`."""
        return f"{self.scope}{{0}}{self.suffix}"

    @property
    def template(self) -> str:
        """What the definition of a template begins with; nothing in C."""
        return f"template <class {self.parameter}>\ninline " if self.parameter else ""

    @property
    def pointer(self) -> str:
        """How a parameter is declared that is filled, before its name."""
        return f"{self.scalar}* " if self.parameter else f"{self.type} *restrict "

    def declarations(self, body: "CBody") -> dict[str, str]:
        """Return the declarations of what a function takes and fills, by their names."""
        taken = {name: f"const {self.pointer}{name}" for name in body.takes}
        return taken | {name: f"{self.pointer}{name}" for name in body.gives} | {**body.declared}


class CBody(NamedTuple):
    """The body of a function.

    Attributes:
        name: The function's name.
        takes: The components of its arguments, by their names.
        gives: The entries of the arrays that it fills, None where it leaves the old one.
        known: Texts of nodes that are given otherwise, through `context`.
        context: Name and declaration of a parameter that `known` reads, if any.
        comments: What stands before the first operation on an argument, by its node.
        declared: Declarations other than the dialect's, by name.
    """

    name: str
    takes: Mapping[str, Sequence[Scalar]]
    gives: Mapping[str, Sequence[Scalar | None]]
    known: Mapping[int, str] = MappingProxyType({})
    context: tuple[str, str] | None = None
    comments: Mapping[int, str] = MappingProxyType({})
    declared: Mapping[str, str] = MappingProxyType({})


def c_definition(graph: Graph, body: CBody, dialect: Dialect, linkage: str = "") -> str:
    """Return the definition of a function, after those of its parts if it is long.

    Args:
        graph: Where its values are recorded.
        body: Its statements.
        dialect: How numbers are written.
        linkage: Its prefix in C: `"static "` or nothing.

    Raises:
        OverflowError: A number is not finite in that type.
    """
    writer = _Writer(graph, body, dialect)
    context = [body.context] if body.context else []
    arrays = [*context, *dialect.declarations(body).items()]
    parts = writer.parts()
    written = [writer.written(part) for part in parts.parts]
    rest = [*writer.copied(), *writer.rest()]
    template = dialect.template
    head = f"{template or linkage}void {body.name}"
    if len(written) == 1:
        return _function(head, arrays, [*written[0], *rest], dialect)
    if not template:
        written[-1] += rest
        rest = []
    sources, calls = [], []
    arrays_of_parts = [*arrays, (WORKSPACE, f"{dialect.pointer}{WORKSPACE}")]
    handed_on = f"<{dialect.parameter}>" if template else ""
    for number, lines in enumerate(written):
        words, name = _words(lines), f"{body.name}_part{number}"
        used = [(n, d) for n, d in arrays_of_parts if n in words]
        begin = f"{template or f'{dialect.noinline}static '}void {name}"
        sources.append(_function(begin, used, lines, dialect))
        calls.append(f"{name}{handed_on}({', '.join(n for n, _ in used)});")
    workspace = [f"{dialect.type} {WORKSPACE}[{parts.n_kept}];"] if parts.n_kept else []
    return "\n".join([*sources, _function(head, arrays, [*workspace, *calls, *rest], dialect)])


def literal(value: float, dialect: Dialect) -> str:
    """Return a number as the language takes it, without loss.

    Raises:
        OverflowError: It is not finite in that type.
    """
    if dialect.suffix and abs(value) < SMALLEST_FLOAT:
        value = 0.0
    if not math.isfinite(value):
        raise OverflowError(f"{value!r} is too large for 'double'")
    if dialect.suffix and abs(value) > LARGEST_FLOAT:
        raise OverflowError(f"{value!r} is too large for 'float': use --real double")
    text = dialect.number.format(f"{value!r}{dialect.suffix}")
    return f"({text})" if text.startswith("-") else text


class _Writer:
    """Writes the parts of one function in order."""

    def __init__(self, graph: Graph, body: CBody, dialect: Dialect) -> None:
        self._graph = graph
        self._dialect = dialect
        self._notation = Notation(
            partial(literal, dialect=dialect), f"{dialect.call}({{1}})", dialect.sign
        )
        self._values = [entry for entries in body.gives.values() for entry in entries]
        self._comments = dict(body.comments)
        self._texts = dict(body.known)
        for name, components in body.takes.items():
            for number, component in enumerate(components):
                if isinstance(component, Term):
                    self._texts[component.index] = f"{name}[{number}]"
        self._given = frozenset(self._texts)
        self._places: dict[int, list[str]] = {}
        self._rest: list[tuple[str, int, Scalar]] = []
        for name, entries in body.gives.items():
            for number, entry in enumerate(entries):
                if self._is_stored_at_once(entry):
                    self._places.setdefault(entry.index, []).append(f"{name}[{number}]")
                elif entry is not None:
                    self._rest.append((name, number, entry))

    def _is_stored_at_once(self, entry: Scalar | None) -> TypeGuard[Term]:
        is_computed = isinstance(entry, Term) and entry.index not in self._given
        return is_computed and not self._dialect.parameter

    def parts(self) -> Parts:
        """Return the operations, cut into parts."""
        if not self._dialect.parameter:
            order = computed(self._graph, self._values, self._given)
            return cut(self._graph, order, OPERATIONS_PER_PART)
        order = depth_first(self._graph, self._values, self._given)
        if len(order) <= MOST_IN_TEMPLATE:
            return Parts([Part(order, {})], 0)
        results = {value.index for value in self._values if isinstance(value, Term)}
        return cut(self._graph, order, OPERATIONS_PER_PART, results)

    def written(self, part: Part) -> list[str]:
        """Return the statements of a part."""
        lines, texts = list[str](), self._texts
        for node in part.nodes:
            for operand in operand_nodes(self._graph, node) if self._comments else ():
                if operand in self._comments:
                    lines.append(f"// {self._comments.pop(operand)}")
            text = self._notation.operation(self._graph, node, texts.__getitem__)
            texts[node] = f"x{node}"
            lines.append(f"const {self._dialect.type} x{node} = {text};")
            if node in part.kept:
                lines.append(f"{WORKSPACE}[{part.kept[node]}] = x{node};")
            lines += [f"{place} = x{node};" for place in self._places.get(node, ())]
        texts.update((node, f"{WORKSPACE}[{place}]") for node, place in part.kept.items())
        return lines

    def copied(self) -> list[str]:
        """Return the statements that read what a template overwrites with its results."""
        if not self._dialect.parameter:
            return []
        nodes = dict.fromkeys(x.index for *_, x in self._rest if isinstance(x, Term))
        copied = [node for node in nodes if node in self._given]
        lines = [f"const {self._dialect.type} x{n} = {self._texts[n]};" for n in copied]
        self._texts.update((node, f"x{node}") for node in copied)
        return lines

    def rest(self) -> list[str]:
        """Return the statements that store what was not stored when it was computed."""
        lines = []
        for array, numbers, text in self._runs():
            if len(numbers) < SHORTEST_LOOP:
                lines += [f"{array}[{number}] = {text};" for number in numbers]
            else:
                head = f"for (int i = {numbers[0]}; i < {numbers[-1] + 1}; i++) {{"
                lines += [head, f"    {array}[i] = {text};", "}"]
        return lines

    def _runs(self) -> Iterator[tuple[str, list[int], str]]:
        """Yield arrays, places that follow one another there, and the text of what all hold."""
        rest = []
        for array, number, entry in self._rest:
            text = self._notation.word(entry, self._texts.__getitem__)
            if not isinstance(entry, Term):
                text = self._dialect.constant.format(text)
            rest.append((array, number, text))
        runs = groupby(enumerate(rest), lambda pair: (pair[1][0], pair[1][2], pair[1][1] - pair[0]))
        for (array, text, _), run in runs:
            yield array, [number for _, (_, number, _) in run], text


def _function(
    head: str, arrays: Sequence[tuple[str, str]], lines: Sequence[str], dialect: Dialect
) -> str:
    """Return a definition in which a compiler warns of nothing that is not used."""
    words, declared = _words(lines), ", ".join(declaration for _, declaration in arrays)
    first = [f"(void){name};" for name, _ in arrays if name not in words]
    if dialect.parameter and dialect.scalar != dialect.type and dialect.type in words:
        first.insert(0, f"typedef {dialect.scalar} {dialect.type};")
    body = "".join(f"    {line}\n" for line in (*first, *lines))
    return f"{head}({declared or 'void'})\n{{\n{body}}}\n"


def _words(lines: Sequence[str]) -> frozenset[str]:
    """Return the names in statements."""
    code = "\n".join(line for line in lines if not line.startswith("//"))
    return frozenset(_WORD.findall(code))
