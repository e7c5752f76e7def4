"""Give a number a name, `0.5` becoming `elbow_x[0.5]`, or replace a name by its value."""

import re
from collections.abc import Iterator

from kindsl.frontends.features.actions.action import CodeAction
from kindsl.frontends.features.names_taken import names_taken
from kindsl.frontends.features.symbol_at import parameter_at
from kindsl.frontends.features.tree_path import TokenAt, path_at, token_at
from kindsl.frontends.features.value_place import ValuePlace, expression_at, value_place
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.rules.context import ROBCOGEN
from kindsl.language.semantics.expressions import symbols
from kindsl.language.semantics.parameters import Use
from kindsl.language.syntax.tables import ValueKind
from kindsl.language.syntax.vocabulary import NUMBERS, OPERANDS
from kindsl.language.text.decimals import exact_decimal
from kindsl.language.text.distinct import free_name
from kindsl.language.text.edits import TextEdit

_NUMBERS = NUMBERS & OPERANDS - {"INT"}
_NO_NAME = re.compile(r"\W+")


def extract_parameter(analysis: Analysis, start: int, end: int) -> Iterator[CodeAction]:
    """Offer to make a parameter of the number at a range, if it is a whole value.

    Its value stays in the document as the default; for robcogen, which knows no defaults, it goes
    to `kindsl.toml`.
    """
    found = token_at(analysis.syntax, start)
    if found is None or found.token.kind not in _NUMBERS or end > found.end:
        return
    expression = expression_at(found.island, found.path)
    place = value_place(found.path, found.token.start)
    if expression is None or expression.literal is None or place is None:
        return
    name = _new_name(analysis, place)
    if ROBCOGEN in analysis.settings.targets:
        title = f"Extract to a parameter '{name}', bound in kindsl.toml"
        yield _action(title, found, name, ((name, expression.literal),))
    else:
        text = f"{name}[{found.token.text.removeprefix('+')}]"
        yield _action(f"Extract to a parameter '{name}' with default", found, text, ())


def _action(
    title: str, found: TokenAt, text: str, bindings: tuple[tuple[str, float], ...]
) -> CodeAction:
    edit = TextEdit(found.start, found.end, text)
    return CodeAction(title, "refactor.extract", (edit,), bindings=bindings)


def _new_name(analysis: Analysis, place: ValuePlace) -> str:
    """Return a new name made of the owner and the component."""
    section, component, kind, _ = place.meaning
    axis = "" if component is None else "xyz"[component]
    short = {ValueKind.LENGTH: axis, ValueKind.ANGLE: f"r{axis}"}
    words = f"{place.owner_name}_{short.get(kind, f'{section}_{axis}')}"
    wanted = _NO_NAME.sub("_", words.lower()).strip("_")
    if wanted.startswith("pi"):
        wanted = f"p_{wanted}"
    return free_name(wanted, {*names_taken(analysis.model), *analysis.settings.bindings})


def inline_parameter(analysis: Analysis, start: int, end: int) -> Iterator[CodeAction]:
    """Offer to replace the parameter at a range by its value, where that is known.

    A value such as `-x/2.0` is replaced as a whole by what it comes to, since no generator takes
    arithmetic of numbers everywhere.
    """
    parameter = parameter_at(analysis, start, end)
    if parameter is None:
        return
    edits = [_edit(analysis, use) for use in parameter.uses]
    known = tuple(dict.fromkeys(edit for edit in edits if edit is not None))
    if len(known) == len(dict.fromkeys(edits)):
        yield CodeAction(f"Inline the parameter '{parameter.name}'", "refactor.inline", known)


def _edit(analysis: Analysis, use: Use) -> TextEdit | None:
    """Return the replacement of the value that a use stands in, None if it has other names."""
    island = use.name.island
    expression = expression_at(island, path_at(island, use.name.start))
    assert expression is not None
    value = expression.value(analysis.context.values)
    if value is None or any(symbol.name != use.name for symbol in symbols(expression)):
        return None
    return analysis.resolver.edit(expression, exact_decimal(value))
