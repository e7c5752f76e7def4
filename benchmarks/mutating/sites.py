"""Where code can be changed so that a test should notice, and the changed code.

A change is one of a comparison, an operator, a condition, a returned value, a number or a truth
value. Left alone is what no test can notice by what it says: texts, annotations and what is for
type checkers alone, decorators, slots, assertions (`strict` of `zip` is one), and the rules' own
examples.
"""

import ast
import random
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

_COMPARISONS: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.GtE),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
}
_OPERATORS: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.FloorDiv: ast.Mult,
    ast.Mod: ast.Mult,
    ast.Pow: ast.Mult,
}
_EXAMPLES = ("good", "bad")
# Generated, or what examples and pages are written with.
_SKIPPED = {"examples.py", "pages.py"}


class Site(NamedTuple):
    """One change.

    Attributes:
        path: The file, relative to the package `kindsl`.
        index: The node's place in `ast.walk`.
        variant: Which of the changes of that node.
        kind: `comparison`, `operator`, `condition`, `return` or `constant`.
        line: Line number of the node.
        change: The code before and after, for people.
    """

    path: Path
    index: int
    variant: int
    kind: str
    line: int
    change: str


def sample(kindsl: Path, package: str, count: int, seed: int) -> list[Site]:
    """Return that many changes in a package, all kinds alike as far as there are enough.

    Args:
        kindsl: The folder of the package `kindsl`.
        package: A folder or module in it, whatever is around that: `rules`, `lsp/session`.
        count: How many.
        seed: Equal seeds give equal samples of equal code.
    """
    generator = random.Random(seed)
    by_kind: dict[str, list[Site]] = {}
    modules = [*kindsl.glob(f"**/{package}/**/*.py")] or [*kindsl.glob(f"**/{package}.py")]
    for path in sorted(modules):
        if path.name not in _SKIPPED:
            for site in _sites(path.relative_to(kindsl), path.read_text(encoding="utf-8")):
                by_kind.setdefault(site.kind, []).append(site)
    for sites in by_kind.values():
        generator.shuffle(sites)
    chosen: list[Site] = []
    while len(chosen) < count and any(by_kind.values()):
        chosen += [sites.pop() for sites in by_kind.values() if sites]
    return chosen[:count]


def mutated(source: str, site: Site) -> str:
    """Return the source of a module with one change."""
    tree = _parsed(source)
    node = list(ast.walk(tree))[site.index]
    _, new = list(_changes(node))[site.variant]
    return ast.unparse(ast.fix_missing_locations(_Replacing(node, new).visit(tree)))


def instrumented(source: str, numbers_by_index: dict[int, list[int]]) -> tuple[str, list[int]]:
    """Return a module that notes in `kindsl._reached` which changes it comes past.

    Args:
        source: The module.
        numbers_by_index: Numbers to note, by the place in `ast.walk` of the changed node.

    Returns:
        The module, and the numbers of what is changed outside of all functions.
    """
    tree = ast.parse(source)
    nodes = list(ast.walk(tree))
    places = {index: _innermost(tree, nodes[index]) for index in numbers_by_index}
    at_import: list[int] = []
    for index, numbers in numbers_by_index.items():
        place = places[index]
        if place is None:
            at_import += numbers
        else:
            block, statement = place
            text = f"__import__('kindsl._reached')._reached.note({numbers})"
            at = next(k for k, other in enumerate(block) if other is statement)
            block[at:at] = ast.parse(text).body
    return ast.unparse(ast.fix_missing_locations(tree)), at_import


def _innermost(tree: ast.Module, node: ast.AST) -> tuple[list[ast.stmt], ast.stmt] | None:
    """Return the innermost statement of a function around a node, and the block that it is in."""
    found = None
    for function in ast.walk(tree):
        if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
            for around in ast.walk(function):
                for name in ("body", "orelse", "finalbody"):
                    block = getattr(around, name, None)
                    for statement in block if isinstance(block, list) else ():
                        if any(other is node for other in ast.walk(statement)):
                            found = block, statement
    return found


def _parsed(source: str) -> ast.Module:
    """Return the tree of a module, each `return` with the type that its function declares."""
    tree = ast.parse(source)
    for function in ast.walk(tree):
        if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
            declared = ast.unparse(function.returns) if function.returns else ""
            for node in ast.walk(function):
                if isinstance(node, ast.Return):
                    vars(node)["declared"] = declared
    return tree


def _sites(path: Path, source: str) -> Iterator[Site]:
    tree = _parsed(source)
    left_alone = {id(node) for root in _left_alone(tree) for node in ast.walk(root)}
    for index, node in enumerate(ast.walk(tree)):
        if id(node) in left_alone:
            continue
        for variant, (kind, new) in enumerate(_changes(node)):
            line = getattr(node, "lineno", 0)
            yield Site(path, index, variant, kind, line, f"{_shown(node)} -> {_shown(new)}")


def _left_alone(tree: ast.Module) -> Iterator[ast.AST]:
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield from node.decorator_list
        if isinstance(node, ast.FunctionDef) and node.returns:
            yield node.returns
        if isinstance(node, ast.arg | ast.AnnAssign) and node.annotation:
            yield node.annotation
        if isinstance(node, ast.Assert) or _is_for_type_checkers(node) or _is_slots(node):
            yield node
        if isinstance(node, ast.keyword) and ast.unparse(node) == "strict=True":
            yield node
    yield from _examples(tree)


def _is_for_type_checkers(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"


def _is_slots(node: ast.AST) -> bool:
    return isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__slots__"


def _examples(tree: ast.Module) -> Iterator[ast.AST]:
    """Yield a rule's examples and whatever else of its module only these use."""
    roots: list[ast.AST] = [
        keyword.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        for keyword in node.keywords
        if keyword.arg in _EXAMPLES
    ]
    for root in roots:
        names = {node.id for node in ast.walk(root) if isinstance(node, ast.Name)}
        for statement in tree.body:
            own = _defined(statement)
            if own & names and statement not in roots:
                roots.append(statement)
    yield from roots


def _defined(statement: ast.stmt) -> set[str]:
    if isinstance(statement, ast.FunctionDef):
        return {statement.name}
    if isinstance(statement, ast.Assign):
        return {target.id for target in statement.targets if isinstance(target, ast.Name)}
    return set()


def _changes(node: ast.AST) -> Iterator[tuple[str, ast.AST]]:
    """Yield the kind of each change of a node and the node that takes its place."""
    match node:
        case ast.Compare(left, [operator], comparators):
            for other in _COMPARISONS[type(operator)]:
                yield "comparison", ast.Compare(left, [other()], comparators)
        case ast.BinOp(left, operator, right) if type(operator) in _OPERATORS:
            if not (_is_text(left) or _is_text(right)):
                yield "operator", ast.BinOp(left, _OPERATORS[type(operator)](), right)
        case ast.BoolOp(operator, values):
            other = ast.Or if isinstance(operator, ast.And) else ast.And
            yield "operator", ast.BoolOp(other(), values)
        case ast.UnaryOp(ast.Not() | ast.USub(), operand):
            yield "operator", operand
        case ast.If(_, body, orelse):
            yield "condition", ast.If(ast.Constant(value=True), body, orelse)
            yield "condition", ast.If(ast.Constant(value=False), body, orelse)
        case ast.IfExp(_, body, orelse):
            yield "condition", body
            yield "condition", orelse
        case ast.comprehension(target, iterated, [_, *_], is_async):
            yield "condition", ast.comprehension(target, iterated, [], is_async)
        case ast.Return(value) if value is not None and not _is_constant(value, None):
            yield "return", ast.Return(_other_value(value, vars(node)["declared"]))
        case ast.Constant(bool(value)):
            yield "constant", ast.Constant(not value)
        case ast.Constant(int(value) | float(value)):
            yield "constant", ast.Constant(value + 1 if isinstance(value, int) else 2 * value + 1)


def _other_value(value: ast.expr, declared: str) -> ast.expr:
    """Return another value of a simple type, since another type is noticed by mypy; else None."""
    if declared == "bool":
        return ast.UnaryOp(ast.Not(), value)
    if declared in ("int", "float"):
        return ast.BinOp(value, ast.Add(), ast.Constant(value=1))
    if declared == "str":
        return ast.Constant(value="?" if _is_constant(value, "") else "")
    return ast.Constant(value=None)


def _is_text(node: ast.expr) -> bool:
    return isinstance(node, ast.JoinedStr) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str)
    )


def _is_constant(node: ast.expr, value: object) -> bool:
    return isinstance(node, ast.Constant) and node.value == value


def _shown(node: ast.AST) -> str:
    if isinstance(node, ast.If):
        return f"if {ast.unparse(node.test)}"
    if isinstance(node, ast.comprehension):
        return ast.unparse(node).strip()
    return ast.unparse(node)


class _Replacing(ast.NodeTransformer):
    def __init__(self, old: ast.AST, new: ast.AST) -> None:
        self._old, self._new = old, new

    def visit(self, node: ast.AST) -> ast.AST:
        return self._new if node is self._old else super().visit(node)
