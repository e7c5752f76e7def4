"""Give a link, joint, frame, parameter, constant or the robot another name, everywhere."""

import re
from typing import NamedTuple

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.symbol_at import (
    Entity,
    EntityKind,
    Role,
    Symbol,
    occurrences,
    symbol_at,
)
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.syntax.tables import KEYWORDS
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.span import Span

_NAME = re.compile(r"[^\W\d]\w*")
_VALUES = frozenset((EntityKind.PARAMETER, EntityKind.CONSTANT))


class Renaming(NamedTuple):
    """The edits of a renaming.

    Attributes:
        bound_parameter: The old name of a parameter that has a value in `kindsl.toml` or in the
            settings, which must take the new name there too; None otherwise.
    """

    edits: tuple[TextEdit, ...]
    bound_parameter: str | None


def rename_range(analysis: Analysis, offset: int) -> Span | None:
    """Return the name at an offset that can be renamed, None where there is none."""
    symbol = symbol_at(analysis, offset)
    return None if symbol is None else Span(symbol.start, symbol.end)


def rename(analysis: Analysis, offset: int, new_name: str) -> Renaming | Refusal | None:
    """Return the edits that give a thing a new name, or why that cannot be.

    None where no name is at the offset.
    """
    symbol = symbol_at(analysis, offset)
    if symbol is None:
        return None
    entity = symbol.entity
    new_name = new_name.strip().removeprefix("^")
    if new_name == entity.name:
        return Renaming((), None)
    problem = objection(new_name, entity.kind, analysis.settings.targets)
    problem = problem or _clash(analysis, entity, new_name)
    if problem is not None:
        return Refusal(problem)
    edits = tuple(TextEdit(p.start, p.end, new_name) for p in _renamed_places(analysis, symbol))
    is_bound = entity.kind is EntityKind.PARAMETER and entity.name in analysis.settings.bindings
    return Renaming(edits, entity.name if is_bound else None)


def _renamed_places(analysis: Analysis, symbol: Symbol) -> tuple[Symbol, ...]:
    """Return all places; of things declared twice under one name only the one at hand.

    The first declaration keeps the references, as they are resolved to it.
    """
    places = occurrences(analysis, symbol.entity)
    declared = [place for place in places if place.role is Role.DECLARATION]
    if symbol in declared[1:]:
        return (symbol,)
    return tuple(place for place in places if place not in declared[1:])


def _clash(analysis: Analysis, entity: Entity, new_name: str) -> str | None:
    """Return what already has the name, as far as that is in the way."""
    if entity.kind is EntityKind.PARAMETER:
        if new_name in analysis.settings.bindings:
            origin = analysis.settings.bindings[new_name].origin or "the settings"
            return f"'{new_name}' already has a value in {origin}"
        taken = any(str(p.name) == new_name for p in analysis.model.parameters)
        return f"a parameter named '{new_name}' exists already" if taken else None
    if entity.kind is EntityKind.CONSTANT:
        taken = any(str(c.name) == new_name for c in analysis.model.constants)
        return f"a constant named '{new_name}' exists already" if taken else None
    return _clash_of_things(analysis, new_name)


def _clash_of_things(analysis: Analysis, new_name: str) -> str | None:
    """Links, joints, frames and the robot become names of one program: all must differ."""
    model = analysis.model
    if new_name in model.body_named:
        kind = "base" if model.body_named[new_name].is_base else "link"
        return f"a {kind} named '{new_name}' exists already"
    if new_name in model.joint_named:
        return f"a joint named '{new_name}' exists already"
    frame = next((f for f in model.frames if str(f.name) == new_name), None)
    if frame is not None:
        return f"a frame named '{new_name}' exists already, on link '{frame.link}'"
    return f"the robot is named '{new_name}'" if model.name == new_name else None


def objection(word: str, kind: EntityKind, targets: frozenset[str]) -> str | None:
    """Return why a word cannot name such a thing for some generators, or None if it can."""
    if not _NAME.fullmatch(word):
        return (
            f"'{word}' is not a valid name: use letters, digits and '_', not starting with a digit"
        )
    if word.lower() == "pi":
        return f"'{word}' means the number pi"
    if word in KEYWORDS:
        return f"'{word}' is a keyword"
    if not word.isascii() and "robcogen" in targets:
        return f"'{word}' has letters that robcogen does not take in a name"
    if kind in _VALUES and word.lower().startswith("pi") and "robcogen2" in targets:
        return f"'{word}' begins with 'pi', where robcogen2 stops reading"
    return None
