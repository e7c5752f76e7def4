"""Names that something new cannot have."""

from collections.abc import Collection
from itertools import chain

from kindsl.language.semantics.model import Model
from kindsl.language.text.facts import kept


@kept
def names_taken(model: Model) -> Collection[str]:
    """Return every name that something in a document has, or is called by."""
    taken = {str(model.name), *map(str, model.body_named), *map(str, model.joint_named)}
    taken.update(str(frame.name) for frame in model.frames)
    taken.update(str(use.name) for part in model.parts for use in part.parameters)
    for body in model.bodies:
        taken.update(map(str, chain.from_iterable(body.children)))
    return taken
