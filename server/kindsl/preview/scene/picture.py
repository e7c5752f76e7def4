"""Which bodies to draw for a document, and what to say over them."""

from dataclasses import dataclass
from enum import StrEnum

from kindsl.mechanism.drawable import drawable_skeleton
from kindsl.mechanism.errors import ModelError
from kindsl.mechanism.fragments import skeleton_as_far_as_known
from kindsl.mechanism.skeleton import Skeleton
from kindsl.semantics.declarations import ValueKind
from kindsl.semantics.model import Model
from kindsl.semantics.parameters import values_of

MOST_NAMED = 3


class State(StrEnum):
    """How what is drawn stands to the document."""

    LIVE = "live"
    """It is the document."""
    BROKEN = "broken"
    """The document has no complete tree; it is the last one that had, or what there is."""
    UNBOUND = "unbound"
    """A length or angle has no value."""


@dataclass(frozen=True, slots=True)
class Picture:
    """What to draw.

    Attributes:
        skeleton: None if there has never been anything.
        state: See there.
        message: What is the matter, for people; empty if nothing.
    """

    skeleton: Skeleton | None
    state: State
    message: str = ""


def picture(model: Model, given: dict[str, float], last_good: Skeleton | None) -> Picture:
    """Choose what to draw of a document.

    Args:
        model: Its model, whole or broken.
        given: Values of parameters.
        last_good: The bodies of the last version that had a complete tree.
    """
    values = values_of(model.parameters, model.constants, given)
    unbound = [p for p in model.parameters if str(p.name) not in values]
    stand_ins = {str(p.name): 0.0 for p in unbound}
    skeleton: Skeleton | None
    try:
        skeleton = drawable_skeleton(model, {**stand_ins, **values})
        defect = _defect(model)
    except ModelError as error:
        skeleton = skeleton_as_far_as_known(model, {**stand_ins, **values})
        defect = str(error)
    if defect:
        shown = last_good or skeleton
        return Picture(shown, State.BROKEN, _sentence(defect, last_good, shown))
    if any(p.kind is not ValueKind.DYNAMICS for p in unbound):
        return Picture(last_good or skeleton, State.UNBOUND, _unbound_message(list(stand_ins)))
    return Picture(skeleton, State.LIVE, _unbound_message(list(stand_ins)) if unbound else "")


def _defect(model: Model) -> str:
    """Return what keeps the document from having one complete tree, or an empty text."""
    if any(problem for island in model.broken_islands for problem in island.problems):
        return "The document has syntax errors"
    if model.tree.loops:
        return "The links form a kinematic loop"
    for edge in model.tree.edges:
        if edge.link is None:
            return f"There is no link '{edge.child.link}'"
        if edge.joint is None:
            return f"There is no joint '{edge.child.joint}'"
    if any(link not in model.tree.reachable for link in model.links):
        return "Not all links hang on the base"
    return ""


def _sentence(problem: str, last_good: Skeleton | None, shown: Skeleton | None) -> str:
    if last_good is not None:
        consequence = "the last complete version is shown"
    else:
        consequence = "what there is of it is shown" if shown else "nothing can be shown yet"
    return f"{problem[:1].upper()}{problem[1:]}: {consequence}"


def _unbound_message(names: list[str]) -> str:
    if len(names) == 1:
        return f"The parameter '{names[0]}' has no value: it counts as zero until you type one"
    listed = ", ".join(f"'{name}'" for name in names[:MOST_NAMED])
    if len(names) > MOST_NAMED:
        listed += f" and {len(names) - MOST_NAMED} more"
    return f"The parameters {listed} have no value: they count as zero until you type one"
