"""Other uses of a parameter or constant, so that a card can say what moves along."""

from kindsl.frontends.features.tree_path import path_at
from kindsl.frontends.features.value_place import value_place
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.expressions import ConstantUse, Expression, ParameterUse
from kindsl.language.semantics.places import Name


def places_moved_by(
    analysis: Analysis, use: ParameterUse | ConstantUse, but: Expression
) -> tuple[str, ...]:
    """Return the values that a symbol stands in but one: `joint 'knee' translation x`."""
    model = analysis.model
    if isinstance(use, ParameterUse):
        parameter = next(p for p in model.parameters if p.name == use.name)
        names = [each.name for each in parameter.uses]
    else:
        constant = next(c for c in model.constants if c.name == use.name)
        names = [each.name for each in constant.uses]
    elsewhere = [name for name in names if not _is_within(name, but)]
    return tuple(dict.fromkeys(_place_of(name) for name in elsewhere))


def _is_within(name: Name, value: Expression) -> bool:
    return name.island is value.island and value.start <= name.start < value.end


def _place_of(name: Name) -> str:
    path = path_at(name.island, name.start)
    place = value_place(path, name.start)
    assert place is not None
    return f"{place.owner} '{place.owner_name}' {place.label}"
