"""Values to draw with for parameters that have none: a robot is shown before they are known."""

from collections.abc import Mapping
from math import hypot, isfinite
from statistics import median
from typing import NamedTuple

from kindsl.language.semantics.declarations import Frame, Joint, ValueKind
from kindsl.language.semantics.expressions import ParameterUse, Values, symbols
from kindsl.language.semantics.model import Model

USUAL_LENGTH = 0.3  # metres
_NEGLIGIBLE = 1e-6  # metres
_DIGITS = 2


class Guesses(NamedTuple):
    """The values drawn in place of missing ones.

    Attributes:
        values: A length or angle by the name of each parameter without a value.
        left_out: Parameters of masses and moments without a value: what they are in is not drawn.
        joints: Names of the joints whose place is a guess.
        frames: Names of the optional frames whose place is a guess.
    """

    values: Values
    left_out: tuple[str, ...]
    joints: frozenset[str]
    frames: frozenset[str]

    def beside(self, known: Values) -> dict[str, float]:
        """Return known values, and the guesses of those that lack."""
        return {**known, **self.values}


NO_GUESSES = Guesses({}, (), frozenset(), frozenset())


def guesses(model: Model, values: Values) -> Guesses:
    """Return what to draw with in place of missing values.

    Args:
        values: Of parameters by name, and of constants by `<name>`.
    """
    unbound = [p for p in model.parameters if str(p.name) not in values]
    if not unbound:
        return NO_GUESSES
    placing = [p for p in unbound if p.kind is not ValueKind.DYNAMICS]
    length = _typical_length(model, values) if placing else USUAL_LENGTH
    found = {str(p.name): length if p.kind is ValueKind.LENGTH else 0.0 for p in placing}
    left_out = tuple(str(p.name) for p in unbound if p.kind is ValueKind.DYNAMICS)
    joints = (str(joint.name) for joint in model.joints if _depends(joint, found))
    frames = (frame for frame in model.frames if _depends(frame, found))
    # A frame whose name is taken is drawn as `link.frame`.
    names = (name for f in frames for name in (str(f.name), f"{f.link}.{f.name}"))
    return Guesses(found, left_out, frozenset(joints), frozenset(names))


def _typical_length(model: Model, values: Values) -> float:
    """Return the median distance between a link's frame and its joints, metres."""
    lengths: list[float] = []
    for joint in model.joints:
        vector = joint.pose.translation
        numbers = [c.value(values) for c in vector.components] if vector is not None else []
        known = [number for number in numbers if number is not None and isfinite(number)]
        if len(known) == len(numbers) and hypot(*known) > _NEGLIGIBLE:
            lengths.append(hypot(*known))
    return float(f"{median(lengths):.{_DIGITS}g}") if lengths else USUAL_LENGTH


def _depends(thing: Joint | Frame, names: Mapping[str, float]) -> bool:
    return any(
        isinstance(symbol, ParameterUse) and str(symbol.name) in names
        for expression in thing.values()
        for symbol in symbols(expression)
    )
