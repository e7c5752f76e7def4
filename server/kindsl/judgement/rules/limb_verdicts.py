"""Misfits in the limbs of a robot: found once for all rules that tell of them.

Who carries whom, where the joints are and how heavy the links are is looked at in this order, each
again only where it has changed. Numbers in broken text are not yet read, so they are told of by the
rules about syntax alone: two fixes of one number would contradict each other.
"""

from collections.abc import Sequence
from functools import lru_cache, partial
from itertools import chain
from typing import NamedTuple

from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.limb_places import is_broken
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link, ValueKind
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.text.facts import Fact
from kindsl.robots.limbs.attachments import Attachment, LimbNames
from kindsl.robots.limbs.limb import Limbs, limbs_of
from kindsl.robots.limbs.mirrored import PairOfLimbs, pairs_of, unmirrored
from kindsl.robots.limbs.verdicts import ComparedLimbs, agreed, verdicts
from kindsl.robots.limbs.weighing import LimbVerdict, Masses
from kindsl.robots.mechanism.link_inertia import link_inertia

_ASSIGNMENTS = range(3)
# Where arbitrary values of parameters begin and how far they go: what a robot may have.
_ARBITRARY: dict[object, tuple[float, float]] = {
    ValueKind.LENGTH: (0.1, 0.4),
    ValueKind.ANGLE: (0.2, 1.0),
}
_ANYTHING = (0.5, 1.0)

# A group of limbs, or what they hold, at each assignment of parameters.
_Compared = tuple[ComparedLimbs, ...]


class LimbSlips(NamedTuple):
    """The slips in the numbers of a robot's limbs.

    Attributes:
        verdicts: Numbers and kinds that do not fit, where all is attached as it should be.
        assignments: The values of parameters at which numbers were compared.
    """

    verdicts: list[LimbVerdict]
    assignments: tuple[Values, ...]


_SLIPS = Fact[tuple[object, LimbSlips]]("slips in limbs")
_NAMES = Fact[tuple[object, LimbNames]]("names of limbs")
_LIMBS = Fact[tuple[object, dict[str, list[_Compared]]]]("limbs by carrier")
_COMPARED = Fact[tuple[object, list[_Compared]]]("compared limbs")
_VERDICTS = Fact[tuple[object, list[LimbVerdict]]]("verdicts on limbs")


def limb_names(model: Model) -> LimbNames:
    """Return the names of links and joints, from which misplaced links are found."""
    if model.document.is_xml:
        from kindsl.judgement.rules.xml_limbs import xml_limb_names

        return xml_limb_names(model)
    structure = model.edition.facts(Aspect.STRUCTURE)
    return structure.made_of(_NAMES, (), partial(_names, model))


def _names(model: Model) -> LimbNames:
    edges = [e for e in model.tree.edges if e.link is not None and e.joint is not None]
    return LimbNames(
        [Attachment(str(e.child.link), str(e.predecessor.name), str(e.child.joint)) for e in edges],
        {
            str(e.child.link)
            for e in edges
            if e.link and 0 < (e.link.id or 0) < (e.predecessor.id or 0)
        },
    )


def limb_slips(model: Model, context: Context) -> LimbSlips:
    """Return what does not fit in the limbs of a robot, at whatever values its parameters have."""
    return model.facts.made_of(_SLIPS, context, partial(_slips, model, context))


def _slips(model: Model, context: Context) -> LimbSlips:
    assignments = _assignments(model, context)
    names = limb_names(model)
    if names.elsewhere or names.crossed:
        return LimbSlips([], assignments)
    if model.document.is_xml:
        from kindsl.judgement.rules.xml_limbs import xml_limb_verdicts

        return LimbSlips(xml_limb_verdicts(model), assignments)
    places = model.edition.facts(Aspect.STRUCTURE | Aspect.PLACES)
    given = context.targets, assignments
    limbs = places.made_of(_LIMBS, given, partial(_compared_limbs, model, assignments))
    found: list[LimbVerdict] = []
    for name, groups in limbs.items():
        carrier = model.body_named[name]
        links = [[model.body_named[link] for link in at_any.links] for at_any, *_ in groups]
        judge = partial(_judged, groups, links, assignments)
        judged = carrier.facts.made_of(_VERDICTS, (assignments, groups, links), judge)
        found += judged
    read = [v for v in found if not any(is_broken(model, place) for place in v.places)]
    return LimbSlips(read, assignments)


def _compared_limbs(model: Model, assignments: Sequence[Values]) -> dict[str, list[_Compared]]:
    """Return the limbs that each body carries, compared again where they are not the same."""
    at_each = [limbs_of(model, values) for values in assignments]
    found: dict[str, list[_Compared]] = {}
    for carrier in at_each[0]:
        limbs = list(zip(*(each.get(carrier, ()) for each in at_each), strict=False))
        compared = carrier.facts.made_of(_COMPARED, limbs, partial(_compared, limbs))
        found[str(carrier.name)] = compared
    return found


def _compared(groups: Sequence[tuple[Limbs, ...]]) -> list[_Compared]:
    found = []
    for limbs in groups:
        known = {each: ComparedLimbs(each) for each in dict.fromkeys(limbs)}
        whole = [known[each] for each in limbs]
        found += [tuple(whole), *zip(*(each.held for each in whole), strict=False)]
    return found


def _judged(
    groups: Sequence[_Compared], links: Sequence[Sequence[Link]], assignments: Sequence[Values]
) -> list[LimbVerdict]:
    at_each = zip(zip(*groups, strict=True), assignments, strict=True)
    found = [verdicts(limbs, _masses([*chain(*links)], values)) for limbs, values in at_each]
    by_group = map(agreed, zip(*found, strict=True))
    return [each for each in chain.from_iterable(by_group) if not each.may_be_zero]


def _masses(links: Sequence[Link], values: Values) -> Masses:
    known = ((str(link.name), link_inertia(link, values)) for link in links)
    return {name: inertia for name, inertia in known if not isinstance(inertia, Unknown)}


def _assignments(model: Model, context: Context) -> tuple[Values, ...]:
    """Return the values that are known, and with parameters of more than the base arbitrary ones.

    Who compares at several values compares names: equal ones by chance are not equal at all.
    """
    here = model.base.island if model.base is not None else None
    if all(use.name.island is here for parameter in model.parameters for use in parameter.uses):
        return (context.values,)
    named = [(str(p.name), p.kind) for p in model.parameters]
    arbitrary = [{name: _value(name, kind, n) for name, kind in named} for n in _ASSIGNMENTS]
    known = context.values
    return {**arbitrary[0], **known}, *({**known, **values} for values in arbitrary[1:])


@lru_cache(maxsize=1024)
def _value(name: str, kind: object, n: int) -> float:
    # Imported for parameters only, since it delays the linter's start.
    from zlib import crc32

    low, width = _ARBITRARY.get(kind, _ANYTHING)
    return low + width * (crc32(f"{name} {n}".encode()) % 9973) / 9973.0


_COPIED = Fact[tuple[object, list[PairOfLimbs]]]("copied limbs")
_MIRRORED = Fact[tuple[object, list[list[Limbs]]]]("limbs by carrier, where some are mirrored")


def copied_limbs(model: Model, context: Context) -> list[PairOfLimbs]:
    """Return the pair of limbs that is copied where all others are mirrored, if there is one."""

    def found() -> list[PairOfLimbs]:
        if model.document.is_xml:
            from kindsl.judgement.rules.xml_limbs import xml_copied_limbs

            told = chain.from_iterable(v.places for v in limb_slips(model, context).verdicts)
            return xml_copied_limbs(model, {place.link for place in told})
        places = model.edition.facts(Aspect.STRUCTURE | Aspect.PLACES)
        mirrored = partial(_limbs_with_sides, model, context.values)
        carried = places.made_of(_MIRRORED, context.values, mirrored)
        if not carried:
            return []
        pairs = pairs_of(carried, _masses(model.bodies, context.values))
        return list(unmirrored(pairs))

    return model.facts.made_of(_COPIED, context, found)


def _limbs_with_sides(model: Model, values: Values) -> list[list[Limbs]]:
    """Return the limbs of each body that carries some, none where no two are left and right."""
    names = limb_names(model)
    carried = list(limbs_of(model, values).values())
    pairs = (pair for groups in carried for limbs in groups for pair in limbs.pairs())
    is_whole = not names.elsewhere and not names.crossed
    return carried if is_whole and any(how == "LR" for *_, how in pairs) else []
