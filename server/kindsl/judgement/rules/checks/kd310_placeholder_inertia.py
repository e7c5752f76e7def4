"""An inertia is a placeholder.

## What it does
Reports a mass of 1.0 with three moments of 1.0, and the same mass and moments in three or more
moving links of different parts. Parts are recognised by names without sides and numbers: `LF_hip`
and `RH_hip` are one part, and so are `segment1` and `segment2`. Links of which none carries another
may be one part that is mounted several times, as wheels are, where their moments have many digits,
or, not all equal, where they carry equally many links, as knuckles do. What hangs on links that are
one part is one part as well, as fingertips are. So are `index_knuckle` and `ring_knuckle`, and
`wheel_x` and `wheel_y`.

Of two links with the same mass, centre of mass and moments of many digits, of which no third link
has them, it reports the one that such a body fits less: its numbers were copied. They are two parts
on one chain, or it fits one of them far less: a module that is used twice fits both places alike.

Says of an impossible inertia (KD301, KD302) or one of implausible density (KD311) that it is a
placeholder where its three moments are one round number, or below 1 kg·m² within 5 %, and the
products zero, and which link of
another part has the same moments, or the same centre of mass. KD306 tells how causes are weighed.

## Why is this bad?
A placeholder looks like data. Simulations run, and are wrong.

## Example
```kindsl
inertia_params {
    mass = 1.0
    CoM = (0.0, 0.0, 0.0)
    Ix=1.0 Iy=1.0 Iz=1.0 Ixy=0.0 Ixz=0.0 Iyz=0.0
}
```
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, starmap
from operator import itemgetter

from kindsl.judgement.diagnosis.counterparts import (
    TellingNumbers,
    bodies_with,
    is_same_body,
    telling_numbers,
)
from kindsl.judgement.diagnosis.judgements import is_moving, judgement_of, keyword
from kindsl.judgement.diagnosis.unlike import EXACTLY
from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.inertia.told_causes import explained
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Inertia, Link
from kindsl.language.semantics.model import Model, model_part
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.syntax.document import Chunk
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.facts import kept
from kindsl.language.text.groups import grouped
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.limbs.names import LimbLabel, are_named_alike, label_of

# As many parts as one inertia cannot be of.
_FEWEST_PARTS = 3
_MOST_RELATED = 20
# Of logarithms of likelihoods. 53 pairs of links that share a body in published robots are 0.2
# apart at most; of 47 planted copies 28 are more than this, 29 than half of it, 23 than twice.
_APART = 1.0
# They number parts; `r`, `p` and `y` are of joints.
_LETTERS = frozenset("abcd")
Numbers = tuple[float | None, ...]


def check_document(model: Model, context: Context) -> Iterator[Finding]:
    told = list(explained(model, context, "KD310"))
    yield from told
    found: list[Finding] = []
    groups: dict[Numbers, list[tuple[Link, Inertia]]] = {}
    for chunk in model.document.chunks:
        for numbers, group in _moving(chunk).items():
            groups.setdefault(numbers, []).extend(group)
    for numbers, group in groups.items():
        if numbers[:4] == (1.0, 1.0, 1.0, 1.0):
            yield from starmap(_placeholder, group)
        elif numbers[0] and None not in numbers and any(numbers[1:]):
            bodies = [body for body, _ in group]
            n_parts = len({_label(body).part for body in bodies})
            if n_parts >= _FEWEST_PARTS and not _is_one_part(model, bodies):
                found.append(_shared(group))
    found += filter(None, (_copied(model, pair, context.values) for pair in _pairs(model)))
    places = {(id(each.at.island), each.at.start) for each in told}
    yield from (each for each in found if (id(each.at.island), each.at.start) not in places)


@kept
def _moving(chunk: Chunk) -> dict[Numbers, list[tuple[Link, Inertia]]]:
    part = model_part(chunk)
    moving = [body for body in (*part.bases, *part.links) if is_moving(body)]
    return grouped((_numbers(b), (b, b.inertia)) for b in moving if b.inertia is not None)


def _is_one_part(model: Model, bodies: Sequence[Link]) -> bool:
    """Return whether none carries another, and they share more than a placeholder by chance."""
    carried = [model.tree.in_topological_order(body) for body in bodies]
    if not set(chain.from_iterable(carried)).isdisjoint(bodies):
        return False
    if _telling_moments(bodies[0]) or are_named_alike([str(body.name) for body in bodies]):
        return True
    inertia, n_carried = bodies[0].inertia, {len(links) for links in carried}
    moments = [inertia.moments[name].literal for name in MOMENTS[:3]] if inertia else []
    if n_carried == {0}:
        return _are_ends_of_one_part(model, bodies)
    return len(n_carried) == 1 and len(set(moments)) > 1


def _are_ends_of_one_part(model: Model, bodies: Sequence[Link]) -> bool:
    edges = filter(None, map(model.tree.supporting_edge, bodies))
    carriers = dict.fromkeys(edge.predecessor for edge in edges)
    is_repeated = len(carriers) == len(bodies) and len(set(map(_numbers, carriers))) == 1
    return is_repeated and _is_one_part(model, [*carriers])


def _telling_moments(body: Link) -> list[TellingNumbers]:
    return [telling for telling in telling_numbers(body) if telling.what == "moments"]


def _pairs(model: Model) -> Iterator[list[Link]]:
    """Yield two links, not those of two sides, which alone have the same moments."""
    for chunk in model.document.chunks:
        for link, _ in chain.from_iterable(_moving(chunk).values()):
            pair = [body for each in _telling_moments(link) for body in bodies_with(model, each)]
            if pair[:1] == [link] and len(pair) == len({_label(body).words for body in pair}) == 2:
                yield pair


def _label(body: Link) -> LimbLabel:
    return label_of(str(body.name))


def _are_on_a_chain(model: Model, pair: Sequence[Link]) -> bool:
    carried = chain.from_iterable(map(model.tree.in_topological_order, pair))
    return not set(pair).isdisjoint(carried)


def _are_numbered(pair: Sequence[Link]) -> bool:
    """Return whether names differ by a number, or a letter, alone."""
    return len({tuple(w for w in _label(body).part if w not in _LETTERS) for body in pair}) == 1


def _copied(model: Model, pair: Sequence[Link], values: Mapping[str, float]) -> Finding | None:
    """Return what is said of two links, None where they are not alike or of no body."""
    # Imported for copies only, since it delays the linter's start.
    from kindsl.judgement.diagnosis.judge import weighed_as_written
    from kindsl.judgement.diagnosis.surroundings import surroundings

    weighed: list[tuple[float, Link, Inertia]] = []
    bodies: list[MassDistribution] = []
    have_ends: set[bool] = set()
    for link in pair:
        body = mass_distribution(link.inertia, values) if link.inertia is not None else None
        if link.inertia is None or body is None or body.mass <= 0.0:
            return None
        found = judgement_of(link, link.inertia, body, values)
        around = surroundings(model, values, found)
        cause = weighed_as_written(found, around)
        if cause is None:
            return None
        bodies.append(body)
        have_ends.add(around.end is not None)
        weighed.append((cause.log_alone, link, link.inertia))
    one, other = bodies
    if not is_same_body(one, other, EXACTLY):
        return None
    (less, copy, inertia), (more, meant, own) = sorted(weighed, key=itemgetter(0))
    # Where one link's end is not known, less is known of whether the body fits it.
    is_misplaced = len(have_ends) == 1 and more - less > _APART
    if not _are_on_a_chain(model, pair):
        is_misplaced = is_misplaced and not are_named_alike([str(body.name) for body in pair])
    elif not _are_numbered(pair):
        is_misplaced = True
    if not is_misplaced:
        return None
    message = f"'{copy.name}' has the mass, CoM and moments of '{meant.name}', another part"
    return Finding(
        keyword(inertia), message, (Related(keyword(own), f"inertia of '{meant.name}'"),)
    )


def _placeholder(body: Link, inertia: Inertia) -> Finding:
    message = f"inertia of '{body.name}' is a placeholder: mass and moments are 1.0"
    return Finding(keyword(inertia), message)


@kept
def _numbers(body: Link) -> Numbers:
    inertia = body.inertia
    if inertia is None:
        return ()
    mass = inertia.mass.literal if inertia.mass is not None else None
    moments = (inertia.moments.get(name) for name in MOMENTS)
    return mass, *(moment.literal if moment is not None else None for moment in moments)


def _shared(group: list[tuple[Link, Inertia]]) -> Finding:
    first, inertia = group[0]
    others = group[1:]
    message = f"'{first.name}' and {len(others)} differently shaped links "
    message += "share the same mass and moments"
    related = [Related(keyword(i), f"inertia of '{b.name}'") for b, i in others[:_MOST_RELATED]]
    return Finding(keyword(inertia), message, tuple(related))


RULE = Rule(__name__, Severity.WARNING, check_document=check_document, reads=Aspect.NUMBERS)
