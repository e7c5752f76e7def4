"""Writes functions as loops over bodies, in C or C++: constant tables of the tree, and one text."""

import re
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import chain
from pathlib import Path

from kindsl.mechanics.dynamics.generation.emitters.c import Dialect, literal
from kindsl.mechanics.dynamics.generation.function import Function
from kindsl.mechanics.dynamics.generation.loops import table
from kindsl.mechanics.dynamics.generation.terms import Term
from kindsl.mechanics.dynamics.generation.tree import Tree

_TEXT = Path(__file__).with_name("loops.c").read_text(encoding="utf-8")
_KERNEL = re.compile(r"@P@(\w+)\(const @S@ \*t, ([^)]*)\)")
_PARAMETERS = {
    name: re.findall(r"\*(\w+)", declared.replace("@S@", "")) for name, declared in
    _KERNEL.findall(_TEXT)
}  # fmt: skip
PREFIX = "loops_"
# A row may have columns of several branches, of which all but one wait.
WIDEST_ROW = 4


def loops_text(
    tree: Tree, dialect: Dialect, prefix: str, model: str, place: Callable[[Term], str]
) -> str:  # fmt: skip
    """Return the functions of a tree, and the one that fills their table.

    Args:
        tree: The mechanism.
        dialect: How numbers are written.
        prefix: Of all names, those of lanes too.
        model: The declaration of what parameters decide, and a blank; or nothing.
        place: Returns the text of a value that parameters decide.
    """
    p, first, head = prefix + PREFIX, 6 if tree.is_floating else 0, _head(dialect)
    sign = dialect.sign or f"{dialect.call.format('sign')}({{0}})"
    n = len(tree.links())
    base = range(-1, first - 1)
    before = [*base, *(first + tree.parents[i] - 1 for i in tree.links())]
    order, ends = _depth_first(before)
    has_friction = tree.drives is not None and any(tree.drives.friction)
    values = {
        "P": p, "S": dialect.type, "FN": head, "NB": n + 1, "K": first, "NV": first + n,
        "PARENTS": _listed(tree.parents),
        "TURNS": _listed([int(kind == "revolute") for kind in tree.kinds]),
        "BEFORE": _listed(before), "ORDER": _listed(order), "ENDS": _listed(ends),
        "COLUMNS": _listed([order.index(coordinate) for coordinate in range(first + n)]),
        "SIN": dialect.call.format("sin"), "COS": dialect.call.format("cos"),
        "ROW": dialect.type if dialect.template else f"{p}row",
        "ROWS": _rows(dialect, prefix),
        "SIGN": sign.format("qd[i - 1]") if has_friction else f"({dialect.type})0",
    }  # fmt: skip
    text = re.sub(r"@(\w+)@", lambda match: str(values[match[1]]), _TEXT)
    return f"{text}\n{_filled(tree, dialect, p, model, place)}"


def loop_call(
    function: Function,
    dialect: Dialect,
    prefix: str,
    model: str,
    texts: Mapping[str, str] | None = None,
) -> str:
    """Return the statements that compute a function.

    Args:
        function: The function; with external forces if it has results under these.
        dialect: As for `loops_text`.
        prefix: As for `loops_text`.
        model: What parameters decide, or nothing.
        texts: Of arguments and results, by their names; None for the names.
    """
    if texts is None:
        names = [a.name for a in function.arguments] + [r.name for r in function.results]
        texts = {name: name for name in (*names, *["fext"] * (function.loaded is not None))}
    p, kernel = prefix + PREFIX, function.name.removesuffix("_loaded")
    none = f"({dialect.type} *)0"
    given = ", ".join(["t", *(texts.get(name, none) for name in _PARAMETERS[kernel])])
    S, table_of = dialect.type, f"{p}table({f'{model}, ' if model else ''}room)"
    room = f"{S} room[{p}table_size];"
    return f"    {room}\n    const {S} *t = {table_of};\n    {p}{kernel}({given});\n"


def _head(dialect: Dialect) -> str:
    return dialect.template.strip() or "static inline"


def _rows(dialect: Dialect, prefix: str) -> str:
    """Return the type of some numbers of a matrix's row, and how many these are."""
    p, macro = prefix + PREFIX, f"{prefix}lanes".upper()
    one = f"enum {{ {p}width = 1 }};"
    if dialect.template:
        return one
    return (
        f"#if defined({macro})\n"
        f"enum {{ {p}width = {macro} < {WIDEST_ROW} ? {macro} : {WIDEST_ROW} }};\n"
        f"typedef {dialect.type} {p}row __attribute__((vector_size({p}width * 8)));\n"
        f"#else\ntypedef {dialect.type} {p}row;\n{one}\n#endif"
    )


def _filled(
    tree: Tree, dialect: Dialect, p: str, model: str, place: Callable[[Term], str]
) -> str:  # fmt: skip
    """Return the function that finds the table, in the room given where it is no constant."""
    rows, S = table(tree), dialect.type
    entries = [x for row in rows for x in row]
    # Automatic derivatives' numbers cannot be constants of a table.
    is_template = bool(dialect.template)
    constant = "double" if is_template else dialect.type
    number = repr if is_template else partial(literal, dialect=dialect)
    numbers = "".join(
        f"        {', '.join(number(0.0 if isinstance(x, Term) else x) for x in row)},\n"
        for row in rows
    )
    later = [f"t[{i}] = {place(x)};" for i, x in enumerate(entries) if isinstance(x, Term)]
    is_constant = not later and not is_template
    names = [model.rstrip(", ").split(" ")[-1].lstrip("*")] * (bool(model) and not later)
    lines = [f"(void){name};" for name in [*names, *["t"] * is_constant]]
    if not is_constant:
        copied = [f"for (int k = 0; k < {p}table_size; k++) {{", f"    t[k] = ({S})given[k];", "}"]
        lines += [*copied, *later]
    lines.append(f"return {'given' if is_constant else 't'};")
    text = "".join(f"    {line}\n" for line in lines)
    return (
        f"enum {{ {p}table_size = {len(entries)} }};\n\n"
        f"{_head(dialect)} const {S} *{p}table({model}{S} *t)\n{{\n"
        f"    static const {constant} given[] = {{\n{numbers}    }};\n{text}}}\n"
    )


def _depth_first(before: Sequence[int]) -> tuple[list[int], list[int]]:
    """Return coordinates, each right before all that it carries, and where that ends, of each."""
    paths = list[tuple[int, ...]]()
    for coordinate, carrier in enumerate(before):
        paths.append((*(paths[carrier] if carrier >= 0 else ()), coordinate))
    order, sizes = sorted(range(len(before)), key=paths.__getitem__), Counter(chain(*paths))
    return order, [order.index(coordinate) + sizes[coordinate] for coordinate in range(len(before))]


def _listed(numbers: Sequence[int]) -> str:
    return ", ".join(map(str, numbers))
