"""The bodies to draw for a document, and the sentence over them.

As long as there is a tree the document itself is drawn, whatever is wrong with its form or numbers.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum

from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import written_pose
from kindsl.language.text.phrases import counted
from kindsl.robots.mechanism.errors import ModelError
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.mechanism.reading import partial_linkage, reachable_linkage
from kindsl.robots.mechanism.total_mass import NO_MASS, Weight, total_mass, unknown_bodies
from kindsl.robots.scene.guesses import NO_GUESSES, Guesses, guesses


class PictureState(StrEnum):
    """The picture's relation to the document."""

    LIVE = "live"
    """It is the document."""
    BROKEN = "broken"
    """The document has no complete tree; it is the last one that had, or what there is."""
    GUESSED = "guessed"
    """It is the document, with guesses for values that it has not."""


@dataclass(frozen=True, slots=True)
class Picture:
    """The picture to draw.

    Attributes:
        skeleton: None if there has never been anything.
        state: See there.
        message: A sentence on the state, for people; empty if all is well.
        guesses: Values that stood in for unknown ones.
        weight: The mass of what is shown, as far as it is known.
        unknown: Why the mass distributions of some bodies are not known, by the bodies' names.
        is_former: Whether it is an earlier version.
    """

    skeleton: Linkage | None
    state: PictureState
    message: str = ""
    guesses: Guesses = NO_GUESSES
    weight: Weight = NO_MASS
    unknown: Mapping[str, str] = field(default_factory=dict)
    is_former: bool = False


def picture(model: Model, known: Mapping[str, float], last: Picture | None) -> Picture:
    """Choose what to draw of a document.

    Args:
        model: Its model, whole or broken.
        known: Values of parameters by name, and of constants by `<name>`.
        last: That of the last version that had a complete tree.
    """
    defect = _defect(model)
    guessed = guesses(model, known)
    values = guessed.beside(known)
    former = last.skeleton if last is not None else None
    earlier = dict(zip(former.joint_names, former.placements, strict=True)) if former else {}
    skeleton = partial_linkage(model, values, earlier)
    if not defect and skeleton is None:
        defect = _refusal(model, values)
    if defect and last is not None and former is not None:
        sentence = _sentence(defect, "the last complete version is shown")
        return replace(
            last, state=PictureState.BROKEN, message=sentence, guesses=guessed, is_former=True
        )
    if defect:
        state = PictureState.BROKEN
        message = _sentence(defect, "showing the rest" if skeleton else "nothing can be shown yet")
    else:
        is_guess = guessed.values or guessed.left_out
        state = PictureState.GUESSED if is_guess else PictureState.LIVE
        message = _message(guessed) or _incomplete(model, values)
    unknown = {name: why.plain for name, why in unknown_bodies(model, values).items()}
    return Picture(skeleton, state, message, guessed, total_mass(model, values), unknown)


def _defect(model: Model) -> str:
    """Return what keeps the document from having one complete tree, or an empty text."""
    if model.tree.loops:
        return "the links form a kinematic loop"
    for edge in model.tree.edges:
        link, joint = str(edge.child.link), str(edge.child.joint)
        if edge.link is None:
            return f"there is no link '{link}'" if link else f"joint '{joint}' has no link"
        if edge.joint is None:
            return f"there is no joint '{joint}'" if joint else f"link '{link}' has no joint"
    if any(link not in model.tree.reachable for link in model.links):
        lost = "the document has syntax errors"
        return lost if model.broken_islands else "some links are not connected to the base"
    return ""


def _refusal(model: Model, values: Mapping[str, float]) -> str:
    try:
        reachable_linkage(model, values)
    except ModelError as error:
        return str(error)
    return "there are no links"


def _sentence(problem: str, consequence: str) -> str:
    return f"{problem[:1].upper()}{problem[1:]}: {consequence}"


def _message(guessed: Guesses) -> str:
    count = len(guessed.values) + len(guessed.left_out)
    if not count:
        return ""
    has = "has" if count == 1 else "have"
    consequence = "drawn at a guess" if guessed.values else "left out of masses and inertia"
    return f"{counted(count, 'parameter')} {has} no value: {consequence}"


def _incomplete(model: Model, values: Mapping[str, float]) -> str:
    """Return which joint is drawn where it was, because its pose is not whole."""
    names = [str(j.name) for j in model.joints if written_pose(j.pose, values) is None]
    if not names:
        return ""
    more = f" and {len(names) - 1} more" if len(names) > 1 else ""
    return f"The pose of joint '{names[0]}'{more} is incomplete: drawn as far as known"
