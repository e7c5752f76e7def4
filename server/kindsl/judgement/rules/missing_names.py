"""Messages and fixes for references to something that does not exist."""

from collections.abc import Callable, Iterable, Iterator, Sequence

from kindsl.judgement.rules.base import Finding, Fix, renaming
from kindsl.judgement.rules.reference_defects import MOST_SUGGESTIONS
from kindsl.language.semantics.declarations import Joint, Link
from kindsl.language.semantics.places import Name
from kindsl.language.text.nearest import hint, nearest_names


def missing_names(
    names: Iterable[Name],
    kind: str,
    idle: Iterable[Link | Joint],
    declared: Sequence[Link | Joint],
    new_block: Callable[[str], Fix | None],
) -> Iterator[Finding]:
    """Yield a finding for each name that nothing has.

    Several names that may be meant are to be chosen from; a single one is the fix unless an
    earlier reference takes it; else a new block is.

    Args:
        idle: Names that nothing refers to; these are meant first.
    """
    idle_names = [str(thing.name) for thing in idle]
    all_names = [str(thing.name) for thing in declared]
    free = set(idle_names)
    for number, name in enumerate(names):
        meant: tuple[str, ...] = ()
        if number < MOST_SUGGESTIONS:
            meant = nearest_names(name, idle_names) or nearest_names(name, all_names)
        message = f"{kind} '{name}' does not exist{hint(meant)}"
        choices = tuple(renaming(name, name, each) for each in meant)
        if len(choices) > 1:
            yield Finding(name, message, choices=choices)
        else:
            is_free = bool(meant) and meant[0] in free
            free.discard(meant[0] if meant else "")
            yield Finding(name, message, fix=choices[0] if is_free else new_block(name))
