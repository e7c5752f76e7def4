"""Inertias of a left and a right part that are nearly mirror images."""

from collections.abc import Callable, Iterator
from functools import partial
from math import isclose

from kindsl.judgement.diagnosis.counterparts import images, is_turned_image
from kindsl.judgement.diagnosis.judgements import TEN, judgements, keyword
from kindsl.judgement.rules.base import Finding, Related
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.model import Model, model_part
from kindsl.language.syntax.document import Chunk
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.facts import Fact, kept
from kindsl.language.text.phrases import alternatives
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.limbs.names import label_of, other_sides

_DIFFERENCES = Fact[tuple[object, tuple[str, bool]]]("differences of pairs")
_SIGNIFICANT = 0.05
_MOST_DIFFERENCES = 2
# A CoM in another unit differs in all three, where mass and moments are the same to the digit.
_OF_COM = [1, 2, 3]
_ROUNDED = 1e-3

_BodyOf = Callable[[Link, Values], object]


def unlike_pairs(
    model: Model, values: Values, body_of: _BodyOf, is_told: Callable[[Link], bool]
) -> Iterator[Finding]:
    """Yield a finding for each mirrored pair in which one part has a slip.

    Args:
        values: Of its parameters.
        body_of: Returns the mass distribution of a part as it is written, anything else if it
            is not known.
        is_told: Returns whether something else is told of a part's inertia.
    """
    for left, right in sided_pairs(model):
        compare = partial(_difference, left, right, values, body_of)
        numbers, are_images = left.facts.made_of(_DIFFERENCES, (right, values), compare)
        if are_images or is_told(left) or is_told(right):
            continue
        # Imported for peers that are unlike only, since it delays the linter's start.
        from kindsl.judgement.rules.inertia.unlike_peers import copied_from

        pair = (left, right), (right, left)
        found = [
            (own, peer, copy)
            for own, peer in pair
            if not _is_odd(peer, values) and (copy := copied_from(model, own, ()))
        ]
        if len(found) == 1:
            own, peer, copy = found[0]
            message = f"'{own.name}' is not the mirror image of '{peer.name}': {copy}"
            yield _finding(own, peer, message)
        elif numbers:
            yield _finding(right, left, numbers)


def _is_odd(body: Link, values: Values) -> bool:
    """Return whether a part's own numbers are impossible, or of no material."""
    odd = judgements(declarations(body.island), values)
    return any(found.link is body for found in odd)


def _difference(left: Link, right: Link, values: Values, body_of: _BodyOf) -> tuple[str, bool]:
    """Return the numbers that differ, in words, and whether all is alike or not known."""
    here, there = (body_of(body, values) for body in (left, right))
    if not isinstance(here, MassDistribution) or not isinstance(there, MassDistribution):
        return "", True
    numbers = mirror_difference((str(left.name), str(right.name)), here, there)
    return numbers, not numbers and is_turned_image(here, there, _SIGNIFICANT)


def _finding(own: Link, peer: Link, message: str) -> Finding:
    assert own.inertia is not None and peer.inertia is not None
    related = Related(keyword(peer.inertia), f"inertia of '{peer.name}'")
    return Finding(keyword(own.inertia), message, (related,))


def sided_pairs(model: Model) -> Iterator[tuple[Link, Link]]:
    """Yield the parts of the left side with those of the right one, where both have an inertia."""
    for left, name in (pair for chunk in model.document.chunks for pair in _peers(chunk)):
        right = model.body_named.get(name)
        if right is not None and left.inertia is not None and right.inertia is not None:
            yield left, right


@kept
def _peers(chunk: Chunk) -> list[tuple[Link, str]]:
    """Return the left parts of a chunk with the names that their peers would have."""
    part = model_part(chunk)
    named = ((body, str(body.name)) for body in (*part.bases, *part.links))
    left = ((body, name) for body, name in named if label_of(name).side == "L")
    return [(body, peer) for body, name in left for peer in other_sides(name)]


def mirror_difference(names: tuple[str, str], *both: MassDistribution) -> str:
    """Return how a right inertia is not the image of a left one, nothing if it is, or unlike."""
    left, right = names
    here, there = (body.numbers for body in both)
    pairs = list(zip(map(abs, here), map(abs, there), strict=True))
    kinds = [max(map(max, pairs[part])) for part in (slice(1), slice(1, 4), slice(4, 10))]
    sizes = [_SIGNIFICANT * kinds[(i > 0) + (i > 3)] for i in range(len(TEN))]
    differing = [i for i, (a, b) in enumerate(pairs) if abs(a - b) > sizes[i]]
    exact = sum(a == b for a, b in pairs)
    is_told = 0 < len(differing) <= _MOST_DIFFERENCES or differing == _OF_COM
    if is_told and exact + len(differing) == len(TEN):
        if len(differing) == 2 and _are_swapped(*(pairs[i] for i in differing)):
            swapped = " and ".join(TEN[i] for i in differing)
            return f"'{right}' is not the mirror image of '{left}': {swapped} were swapped"
        told = (f"{TEN[i]} is {there[i]:g} against {here[i]:g}" for i in differing)
        return f"'{right}' is not the mirror image of '{left}': {', '.join(told)}"
    if exact != len(TEN):
        return ""
    seen = (image.numbers for image in images(both[0]))
    as_images = (zip(TEN, numbers, there, sizes, strict=True) for numbers in seen)
    unlike = [[name for name, a, b, size in each if abs(a - b) > size] for each in as_images]
    if [] in unlike:
        return ""
    odd = {names[0] for names in unlike if len(names) == 1}
    # A CoM that alone does not fit may be right, and the products those of the other side.
    if not odd or not odd.issubset(MOMENTS):
        return f"signs of '{right}' do not match a mirror image of '{left}'"
    products = alternatives(sorted(odd))
    return f"sign of {products} of '{right}' does not match a mirror image of '{left}'"


def _are_swapped(one: tuple[float, float], other: tuple[float, float]) -> bool:
    """Return whether two numbers of one part are those of the other in reverse order."""
    return all(isclose(a, b, rel_tol=_ROUNDED) for a, b in zip(one, other[::-1], strict=True))
