"""Misfits in the limbs of a robot: found once for all rules that tell of them.

Limbs that are alike are compared again only where something in them has changed.
"""

from collections.abc import Mapping, Sequence
from functools import lru_cache, partial
from typing import NamedTuple
from zlib import crc32

from kindsl.limbs.attachments import Attachment, LimbNames, Misplaced
from kindsl.limbs.limb import MOST_BODIES, Limbs, limbs_of
from kindsl.limbs.verdicts import LimbVerdict, agreed, verdicts
from kindsl.rules.context import Context
from kindsl.semantics.aspects import Aspect
from kindsl.semantics.declarations import Link, ValueKind
from kindsl.semantics.model import Model
from kindsl.semantics.parameters import Parameter
from kindsl.text.facts import Fact

_ASSIGNMENTS = range(3)
_MOST_KNOWN = 1 << 10
# Where arbitrary values of parameters begin and how far they go: what a robot may have.
_ARBITRARY = {ValueKind.LENGTH: (0.1, 0.4), ValueKind.ANGLE: (0.2, 1.0)}
_ANYTHING = (0.5, 1.0)

Values = Mapping[str, float]


class LimbSlips(NamedTuple):
    """The slips of a robot's limbs.

    Attributes:
        elsewhere: Links that another body carries than their twins let expect.
        crossed: Links that move by another joint than their twins let expect.
        verdicts: Numbers and kinds that do not fit, where all is attached as it should be.
        assignments: The values of parameters at which numbers were compared.
    """

    elsewhere: list[Misplaced]
    crossed: list[Misplaced]
    verdicts: list[LimbVerdict]
    assignments: tuple[Values, ...]


_SLIPS = Fact[tuple[object, LimbSlips]]("slips in limbs")
_MISPLACED = Fact[tuple[object, tuple[list[Misplaced], list[Misplaced]]]]("misplaced links")
_WRITTEN = Fact[dict[str, list[object]]]("limbs as written, by carrier")
_GROUPS = Fact[tuple[object, list[tuple[Limbs, ...]]]]("limbs in numbers")


def limb_slips(model: Model, context: Context) -> LimbSlips:
    """Return what does not fit in the limbs of a robot, at whatever values its parameters have."""
    return model.facts.made_of(_SLIPS, context, partial(_slips, model, context))


def _slips(model: Model, context: Context) -> LimbSlips:
    assignments = _assignments(model, context)
    if model.base is None:
        return LimbSlips([], [], [], assignments)
    names = model.edition.facts(Aspect.STRUCTURE)
    elsewhere, crossed = names.made_of(_MISPLACED, (), partial(_misplaced, model))
    found: list[LimbVerdict] = []
    if not elsewhere + crossed:
        given = context.targets, assignments
        for carrier, written in _limbs_as_written(model).items():
            limbs = partial(_limbs_at_each, carrier, model, assignments)
            for groups in carrier.facts.made_of(_GROUPS, (given, written), limbs):
                found += _compared(groups)
    return LimbSlips(elsewhere, crossed, found, assignments)


def _misplaced(model: Model) -> tuple[list[Misplaced], list[Misplaced]]:
    edges = [e for e in model.tree.edges if e.link is not None and e.joint is not None]
    names = LimbNames(
        [Attachment(str(e.child.link), str(e.predecessor.name), str(e.child.joint)) for e in edges]
    )
    return names.elsewhere(), names.crossed()


def _limbs_as_written(model: Model) -> dict[Link, list[object]]:
    """Return all that is written of each limb of the bodies that carry several.

    Of a limb with very many bodies it is nothing: such are not compared.
    """
    tree = model.tree
    roots = [body for body in model.bodies if body not in tree.above]
    bodies = [*roots, *(link for root in roots for link in tree.in_topological_order(root))]
    versions = model.document.versions
    before, now = versions.get(_WRITTEN) or {}, versions.keep(_WRITTEN, {})
    limbs: dict[Link, list[object]] = {}
    sizes: dict[Link, int] = {}
    for body in reversed(bodies):
        written: list[object] = []
        sizes[body] = 1
        for edge in tree.successor_edges(body):
            _, _, link, joint = edge
            if link in limbs and link is not None and joint is not None:
                sizes[body] += sizes[link]
                if sizes[link] <= MOST_BODIES:
                    is_only = tree.above[link][0] is edge
                    texts = link.island.text, joint.island.text
                    written.append((link.name.start, *texts, limbs[link], is_only))
        # The same list as for the version before, for equal lists are slow to compare.
        name = str(body.name)
        limbs[body] = now[name] = before[name] if before.get(name) == written else written
    return {body: limbs[body] for body in bodies if len(tree.successor_edges(body)) > 1}


def _limbs_at_each(
    carrier: Link, model: Model, assignments: Sequence[Values]
) -> list[tuple[Limbs, ...]]:
    """Return the limbs of one body in numbers, each at all assignments."""
    return list(zip(*(limbs_of(carrier, model, values) for values in assignments), strict=False))


@lru_cache(maxsize=_MOST_KNOWN)
def _compared(groups: tuple[Limbs, ...]) -> list[LimbVerdict]:
    """Return the verdicts on limbs that are given at each assignment."""
    found = {limbs: verdicts(limbs) for limbs in dict.fromkeys(groups)}
    return agreed([found[limbs] for limbs in groups])


def _assignments(model: Model, context: Context) -> tuple[Values, ...]:
    """Return the values that are known, and with parameters of more than the base arbitrary ones.

    Who compares at several values compares names: equal ones by chance are not equal at all.
    """
    here = model.base.island if model.base is not None else None
    if all(use.name.island is here for parameter in model.parameters for use in parameter.uses):
        return (context.values,)
    arbitrary = [{str(p.name): _value(p, n) for p in model.parameters} for n in _ASSIGNMENTS]
    known = context.values
    return {**arbitrary[0], **known}, *({**known, **values} for values in arbitrary[1:])


def _value(parameter: Parameter, n: int) -> float:
    low, width = _ARBITRARY.get(parameter.kind, _ANYTHING)
    return low + width * (crc32(f"{parameter.name} {n}".encode()) % 9973) / 9973.0
