"""Lines above blocks: open the preview, what a link carries, how often a joint is used."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kindsl.frontends.features.subtree import Subtree, subtree_of
from kindsl.frontends.features.wording import KILOGRAMS, number
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.places import Name
from kindsl.language.text.phrases import counted
from kindsl.language.text.span import Span
from kindsl.robots.mechanism.total_mass import UNKNOWN


class CodeLens(NamedTuple):
    """A line above the block of a name; `kind` is `preview`, `subtree` or `references`.

    References have the places to show.
    """

    start: int
    end: int
    title: str
    kind: str
    places: tuple[Span, ...] = ()


def code_lenses(analysis: Analysis) -> tuple[CodeLens, ...]:
    """Return the lenses in the order of the text."""
    return tuple(sorted(_lenses(analysis)))


def _lenses(analysis: Analysis) -> Iterator[CodeLens]:
    model, tree = analysis.model, analysis.model.tree
    for declared in model.declared:
        if declared.robot:
            yield CodeLens(*analysis.resolver.span(declared.robot), "▶ Preview", "preview")
    for body in model.bodies:
        title = _subtree_title(subtree_of(analysis, body), body)
        if title:
            yield CodeLens(*analysis.resolver.span(body.name), title, "subtree")
        if not body.is_base:
            yield _references(
                analysis, body.name, [edge.child.link for edge in tree.above.get(body, ())]
            )
    for joint in model.joints:
        uses = [edge.child.joint for edge in tree.joint_uses.get(joint, ())]
        yield _references(analysis, joint.name, uses)


def _subtree_title(subtree: Subtree, body: Link) -> str:
    if not subtree.dof:
        return ""
    joints, weight = counted(subtree.dof, "joint"), subtree.weight
    mass = weight.in_words(f"{number(weight.known)} {KILOGRAMS}")
    if mass == UNKNOWN:
        return f"carries {joints}, mass unknown"
    counts = body.is_floating or not body.is_base
    return f"carries {joints}, {mass}" + (" with itself" if counts else "")


def _references(analysis: Analysis, name: Name, uses: Sequence[Name]) -> CodeLens:
    places = tuple(map(analysis.resolver.span, uses))
    title = counted(len(places), "reference")
    return CodeLens(*analysis.resolver.span(name), title, "references", places)
