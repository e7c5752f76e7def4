"""Inlay hints: values of expressions, degrees, units, the box equivalent to a body."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kindsl.frontends.features.wording import INERTIA, angle, moments_text, number
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Declarations, Link
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.syntax.tables import VALUES, ValueKind
from kindsl.language.syntax.tree import Node
from kindsl.language.syntax.vocabulary import of_kind
from kindsl.mechanics.rigid.body import equivalent_box, principal_moments_about_com
from kindsl.robots.mechanism.link_inertia import link_inertia

_WITH_UNIT = VALUES.keys() & of_kind("scalar", "vector")
_LONGEST = 43  # characters, of which VS Code shows no more


class InlayHint(NamedTuple):
    """A text to show at an offset; `kind` is `value`, `angle`, `unit` or `inertia`."""

    offset: int
    text: str
    kind: str
    tooltip: str = ""


class InlayHintOptions(NamedTuple):
    """The kinds of hints to show.

    Attributes:
        values: Values of expressions with a parameter, a constant or arithmetic.
        angles: Angles in degrees.
        units: The unit behind a vector and a mass.
        inertia: The uniform box with a body's mass and inertia, or its principal moments where
            none has them, behind an inertia section.
    """

    values: bool = True
    angles: bool = True
    units: bool = False
    inertia: bool = True


DEFAULT_HINTS = InlayHintOptions()


def inlay_hints(
    analysis: Analysis, start: int, end: int, options: InlayHintOptions = DEFAULT_HINTS
) -> tuple[InlayHint, ...]:
    """Return the hints in a range, in the order of the text."""
    syntax = analysis.syntax
    hints: list[InlayHint] = []
    for index in range(syntax.island_at(start).index, syntax.island_at(end).index + 1):
        place = syntax.island(index)
        found = _island_hints(analysis, declarations(place.island), options)
        hints += [hint._replace(offset=place.start + hint.offset) for hint in found]
    return tuple(sorted(hint for hint in hints if start <= hint.offset <= end))


def _island_hints(
    analysis: Analysis, declared: Declarations, options: InlayHintOptions
) -> Iterator[InlayHint]:
    for expression in declared.values():
        yield from _value_hints(analysis, expression, options)
    for body in declared.bodies():
        if options.inertia:
            yield from _inertia_hints(analysis, body)
    if options.units:
        for block in declared.blocks:
            yield from _units(block.node)


def _value_hints(
    analysis: Analysis, expression: Expression, options: InlayHintOptions
) -> Iterator[InlayHint]:
    value = expression.value(analysis.context.values)
    if expression.meaning.kind is ValueKind.ANGLE and options.angles:
        if value:
            yield InlayHint(expression.end, angle(value), "angle", f"{number(value)} rad")
    elif value is not None and options.values and not _is_number(expression):
        yield InlayHint(expression.end, f"= {number(value)}", "value")


def _is_number(expression: Expression) -> bool:
    """Return whether a value is a number with perhaps a sign before it."""
    return expression.literal is not None or (
        expression.node.kind == "negate"
        and all(child.kind in ("-", "number") for child in expression.node.children)
    )


def _inertia_hints(analysis: Analysis, body: Link) -> Iterator[InlayHint]:
    if body.inertia is None or (body.is_base and not body.is_floating):
        return
    inertia = link_inertia(body, analysis.context.values)
    if isinstance(inertia, Unknown):
        return
    opening = next(c for c in body.inertia.node.children if c.kind == "{")
    principal = principal_moments_about_com(inertia)
    tooltip = f"Principal moments about the centre of mass {moments_text(inertia)}"
    box = equivalent_box(inertia)
    text = _box_text(*box) if box is not None else ""
    if 0 < len(text) <= _LONGEST:
        tooltip = f"The uniform box with this mass and inertia. {tooltip}"
    else:
        rows = (", ".join(number(each, digits) for each in principal) for digits in (3, 2, 1))
        texts = (f"about CoM {row} {INERTIA}" for row in rows)
        text = next(text for text in texts if len(text) <= _LONGEST)
    yield InlayHint(opening.end, text, "inertia", tooltip)


def _box_text(sides: Sequence[float], density: float) -> str:
    """Return a box, as a rule in the 43 characters that VS Code shows."""
    if max(sides) < 1.0:
        lengths = " × ".join(f"{1e3 * side:.{0 if side >= 0.01 else 1}f}" for side in sides) + " mm"
    else:
        lengths = " × ".join(f"{side:.2g}" for side in sides) + " m"
    heavy = f"{density:.2g} kg/m³" if density < 1.0 else f"{density / 1e3:.2g} g/cm³"
    return f"as a {lengths} box of {heavy}"


def _units(node: Node) -> Iterator[InlayHint]:
    """Yield the units of the values of a block, moments excepted."""
    for child in node.children:
        if not isinstance(child, Node):
            continue
        if child.kind in _WITH_UNIT:
            yield InlayHint(child.end, VALUES[child.kind][1], "unit")
        elif child.kind not in VALUES:
            yield from _units(child)
