"""Things with a pose or a length, for the rules about geometry."""

from collections.abc import Iterator
from itertools import chain

from kindsl.judgement.diagnosis.body_verdicts import GREATEST_LENGTH
from kindsl.judgement.rules.base import Fix
from kindsl.judgement.rules.number_writing import rescaled
from kindsl.language.semantics.declarations import Declarations, Frame, Joint, Vector
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.model import Model
from kindsl.language.text.facts import kept

# Nobody places a joint as finely as the first, m; what would be below the last may be in metres.
_FINEST, _FINE = 5e-5, 1e-3


def posed_things(declared: Declarations) -> Iterator[Frame | Joint]:
    """Yield everything in an island that has a pose."""
    for body in declared.bodies():
        yield from body.frames
    yield from declared.joints


def rotations(declared: Declarations) -> Iterator[Vector]:
    """Yield the rotations in an island."""
    for thing in posed_things(declared):
        if thing.pose.rotation is not None:
            yield thing.pose.rotation


def lengths(declared: Declarations) -> Iterator[Vector]:
    """Yield the translations and centres of mass in an island."""
    for thing in posed_things(declared):
        if thing.pose.translation is not None:
            yield thing.pose.translation
    for body in declared.bodies():
        if body.inertia is not None and body.inertia.com is not None:
            yield body.inertia.com


def is_partly_in_metres(model: Model, vector: Vector) -> bool:
    """Return whether a number of a joint's place, which is too long, is one of plausible ones."""
    sizes = {abs(c.literal) for c in vector.components if c.literal}
    return not _plausible(model).isdisjoint(sizes - {max(sizes, default=0.0)})


@kept
def _plausible(model: Model) -> set[float]:
    """Return the sizes of the components of all plausible lengths, none where few are so."""
    islands = chain.from_iterable(chunk.islands for chunk in model.document.chunks)
    vectors = chain.from_iterable(lengths(declarations(island)) for island in islands)
    sizes = [{abs(c.literal) for c in vector.components if c.literal} for vector in vectors]
    known = [each for each in sizes if each]
    plausible = [each for each in known if max(each) <= GREATEST_LENGTH]
    return set().union(*plausible) if 2 * len(plausible) > len(known) else set()


def converted(vector: Vector, factor: float, *, is_com: bool) -> Fix | None:
    """Return the fix that gives a vector in metres, None where that is doubtful.

    Args:
        is_com: Whether it is a centre of mass, else it places a joint.
    """
    written = [component.literal or 0.0 for component in vector.components]
    made = [factor * x for x in written]
    small = [not is_com and 0.0 < abs(x) < _FINE for x in made]
    triples = list(zip(written, made, small, strict=True))
    if any(small) and any(
        abs(y) > _FINEST if is_small else 0.0 < abs(x) <= GREATEST_LENGTH
        for x, y, is_small in triples
    ):
        return None
    values = [x if is_small else y for x, y, is_small in triples]
    changes = rescaled(vector.components, values)
    return Fix("Convert to metres", tuple(changes)) if changes else None
