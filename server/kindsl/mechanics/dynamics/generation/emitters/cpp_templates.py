"""Writes functions in C++ that are templates of the type of numbers, automatic derivatives' too.

Results are stored when all is computed, so an argument may be a result as well. Operations stand
near their uses, depth first, and a long function is cut into parts for the compiler's sake.
"""

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.emitters.straight_line import Notation, cut
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar, Term, operand_nodes

# Compilers take one function of this size well; longer ones cost more than linear time.
MOST_OPERATIONS = 3500
OPERATIONS_PER_PART = 500

_WORKSPACE = "w"

Place = tuple[str, int]


class TemplateDialect(NamedTuple):
    """The notation of numbers and functions.

    Attributes:
        template: The template's parameter: `class TRAIT`.
        number: The type of numbers, from that parameter.
        argument: The parameter's name, to hand it on.
        call: How `sin` and `cos` are called, by their name and argument.
    """

    template: str
    number: str
    argument: str
    call: str


class Template(NamedTuple):
    """The body of a function.

    Attributes:
        name: Its name.
        takes: Its arguments by their names; what is no `Term` is not read.
        gives: Its results by their names.
        is_update: Whether the constants among the results are there already.
        comments: What stands before the first operation on an argument, by its node.
    """

    name: str
    takes: Mapping[str, Sequence[Scalar]]
    gives: Mapping[str, Sequence[Scalar]]
    is_update: bool = False
    comments: Mapping[int, str] = MappingProxyType({})


def template_function(graph: Graph, function: Template, dialect: TemplateDialect) -> str:
    """Return a function's definition, after those of its parts if it is long."""
    known = {
        entry.index: f"{name}[{place}]"
        for name, entries in function.takes.items()
        for place, entry in enumerate(entries)
        if isinstance(entry, Term)
    }
    stored = {
        (name, place): entry
        for name, entries in function.gives.items()
        for place, entry in enumerate(entries)
        if isinstance(entry, Term) or not function.is_update
    }
    order = depth_first(graph, stored.values(), known)
    comments = _commented(graph, order, function.comments)
    takes = [f"const S* {name}" for name in function.takes]
    declared = [*takes, *(f"S* {name}" for name in function.gives)]
    if len(order) <= MOST_OPERATIONS:
        lines = _operations(graph, order, known, dialect, comments)
        lines += _copies(stored, known)
        lines += [f"{name}[{place}] = {_stored(v)};" for (name, place), v in stored.items()]
        return _definition(function.name, declared, lines, dialect)
    return _in_parts(graph, function, order, known, stored, dialect, comments)


def depth_first(
    graph: Graph, values: Iterable[Scalar], known: Mapping[int, str]
) -> list[int]:  # fmt: skip
    """Return the nodes to compute, each shortly before it is used first."""
    order: list[int] = []
    seen = set(known)
    for value in values:
        waiting = [(value.index, False)] if isinstance(value, Term) else []
        while waiting:
            node, is_ready = waiting.pop()
            if is_ready:
                order.append(node)
            elif node not in seen:
                seen.add(node)
                waiting.append((node, True))
                waiting += [(o, False) for o in reversed(operand_nodes(graph, node))]
    return [node for node in order if graph.nodes[node][0] != "input"]


def literal(value: float) -> str:
    """Return a number.

    Raises:
        OverflowError: It is not finite.
    """
    if not math.isfinite(value):
        raise OverflowError(f"{value!r} is too large for 'double'")
    return f"S({value!r})"


def _commented(
    graph: Graph, order: Iterable[int], comments: Mapping[int, str]
) -> dict[int, str]:  # fmt: skip
    """Return the comments by the operations that they stand before."""
    found: dict[int, str] = {}
    waiting = dict(comments)
    for node in order:
        for operand in operand_nodes(graph, node):
            if operand in waiting:
                found.setdefault(node, waiting.pop(operand))
    return found


def _operations(
    graph: Graph,
    order: Iterable[int],
    known: Mapping[int, str],
    dialect: TemplateDialect,
    comments: Mapping[int, str],
) -> list[str]:
    lines, notation = [], Notation(literal, dialect.call)
    for node in order:
        if node in comments:
            lines.append(f"// {comments[node]}")
        text = notation.operation(graph, node, lambda o: known.get(o) or f"x{o}")
        lines.append(f"const S x{node} = {text};")
    return lines


def _copies(stored: Mapping[Place, Scalar], known: Mapping[int, str]) -> list[str]:
    """Return the statements that read arguments which are results before any is overwritten."""
    copied = dict.fromkeys(v.index for v in stored.values() if isinstance(v, Term))
    return [f"const S x{node} = {known[node]};" for node in copied if node in known]


def _stored(value: Scalar) -> str:
    return f"x{value.index}" if isinstance(value, Term) else literal(value)


def _in_parts(
    graph: Graph,
    function: Template,
    order: Sequence[int],
    known: Mapping[int, str],
    stored: Mapping[Place, Scalar],
    dialect: TemplateDialect,
    comments: Mapping[int, str],
) -> str:
    parts = cut(graph, order, OPERATIONS_PER_PART)
    results = [f"{name}_of_parts" for name in function.gives]
    given = [*function.takes, *results, _WORKSPACE]
    declared = [f"{'const ' * (name in function.takes)}S* {name}" for name in given]
    texts, sources, calls, written = dict(known), [], [], set[Place]()
    for number, part in enumerate(parts.parts):
        here = {node: text for node, text in texts.items() if node not in set(part.nodes)}
        lines = _operations(graph, part.nodes, here, dialect, comments)
        lines += [f"{_WORKSPACE}[{place}] = x{node};" for node, place in part.kept.items()]
        there = set(part.nodes)
        for (name, place), value in stored.items():
            if isinstance(value, Term) and value.index in there:
                lines.append(f"{name}_of_parts[{place}] = x{value.index};")
                written.add((name, place))
        texts |= {node: f"{_WORKSPACE}[{place}]" for node, place in part.kept.items()}
        sources.append(_definition(f"{function.name}_part{number}", declared, lines, dialect))
        calls.append(f"{function.name}_part{number}<{dialect.argument}>({', '.join(given)});")
    sizes = {name: len(entries) for name, entries in function.gives.items()}
    lines = [f"S {name}_of_parts[{size}];" for name, size in sizes.items()]
    lines += [f"S {_WORKSPACE}[{max(1, parts.n_kept)}];", *calls, *_copies(stored, known)]
    for (name, place), value in stored.items():
        text = f"{name}_of_parts[{place}]" if (name, place) in written else _stored(value)
        lines.append(f"{name}[{place}] = {text};")
    declared = [f"const S* {name}" for name in function.takes]
    declared += [f"S* {name}" for name in function.gives]
    return "\n".join([*sources, _definition(function.name, declared, lines, dialect)])


def _definition(
    name: str, declared: Sequence[str], lines: Sequence[str], dialect: TemplateDialect
) -> str:
    number = f"typename {dialect.number}" if "::" in dialect.number else dialect.number
    arguments = ", ".join(d.replace("S*", f"{number}*") for d in declared)
    alias = [] if dialect.number == "S" else [f"typedef {number} S;"]
    text = " ".join(line for line in lines if not line.startswith("//"))
    words = set(re.findall(r"[a-zA-Z_]\w*", text))
    unused = [f"(void){n};" for n in (d.split()[-1] for d in declared) if n not in words]
    if not lines or "S" not in words:
        alias = []
    body = "".join(f"    {line}\n" for line in [*alias, *unused, *lines])
    return f"template <{dialect.template}>\ninline void {name}({arguments})\n{{\n{body}}}\n"
