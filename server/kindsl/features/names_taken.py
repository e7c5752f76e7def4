"""Names that something new cannot have."""

from collections.abc import Collection
from itertools import chain, count

from kindsl.semantics.model import Model
from kindsl.text.facts import kept


@kept
def names_taken(model: Model) -> Collection[str]:
    """Return every name that something in a document has, or is called by."""
    taken = {str(model.name), *map(str, model.body_named), *map(str, model.joint_named)}
    taken.update(str(frame.name) for frame in model.frames)
    taken.update(str(use.name) for part in model.parts for use in part.parameters)
    for body in model.bodies:
        taken.update(map(str, chain.from_iterable(body.children)))
    return taken


def free_name(wanted: str, taken: Collection[str]) -> str:
    """Return the name that is wanted, with a number from 2 on where it is taken."""
    names = chain((wanted,), (f"{wanted}_{number}" for number in count(2)))
    return next(name for name in names if name not in taken)
