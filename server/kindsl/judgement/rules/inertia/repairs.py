"""Findings of the rules that tell a cause of an inertia, and the fix that they offer."""

from collections import Counter
from collections.abc import Sequence
from math import sqrt

from kindsl.judgement.diagnosis.digits import (
    WrittenDigits,
    likely_half_widths,
    numbers_written,
    rewritten_number,
)
from kindsl.judgement.diagnosis.judge import Cause, Diagnosis, diagnosed_alone, diagnoses
from kindsl.judgement.diagnosis.judgements import (
    IMPOSSIBLE,
    Judgement,
    Verdict,
    at_values,
    can_be_of_matter,
    is_moving,
    keyword,
    verdict_of,
)
from kindsl.judgement.diagnosis.misfits import Misfit, misfits
from kindsl.judgement.diagnosis.slips import Slip
from kindsl.judgement.diagnosis.unlike import Unlike, unlike_links
from kindsl.judgement.rules.base import Finding, Fix, Related, Replacement, Severity
from kindsl.judgement.rules.context import ROBCOGEN, ROBCOGEN2, Context
from kindsl.judgement.rules.inertia.told import (
    LIKELY,
    MOST_DIGITS,
    SURE,
    is_plausible,
    likely_cause,
    rivals,
    shared_cause,
    title,
    unlike_cause,
    unlike_rivals,
)
from kindsl.judgement.rules.number_writing import rescaled, rewritten
from kindsl.judgement.rules.tiny_values import is_negligible, is_tiny
from kindsl.language.semantics.lowering import OtherIsland
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.unknown import inertia_expressions
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.decimals import significant_decimal
from kindsl.language.text.facts import Fact
from kindsl.language.text.quantities import with_unit
from kindsl.mechanics.rigid.body import MassDistribution, eigensystem, second_moments_about_com
from kindsl.mechanics.rigid.matter import GREATEST_DENSITY, density_of, is_dense_as_matter

# Of what is wrong for certain a cause is told from here on: at half of it one finding more in 122
# robots as they are, at twice 2 % of planted slips less.
_POSSIBLE = 0.2
_ALONE = 0.99
_MOST_RELATED = 20
_LEAST_SHARED = 3
_EVIDENCE = frozenset(("KD311",))
# The codes of a link that two counterparts or more outvote, and of one of a pair.
_OF_MANY, _OF_TWO = "KD509", "KD312"
# The code of the rule that tells it, and what it tells.
_Coded = tuple[str, Finding]
_TELLINGS = Fact[tuple[object, _Coded | None]]("told causes")


def findings(
    suspects: Sequence[Judgement], long: Sequence[Judgement], model: Model, context: Context
) -> list[_Coded]:
    """Return what is told of inertias, with the code of its rule.

    Args:
        suspects: Those that need an explanation.
        long: Possible ones, whose moments may have been shifted twice.
    """
    diagnosed = [*map(_of_matter, diagnoses(suspects, model, context.values))]
    told = [each for d in diagnosed if (each := _of_causes(d, context)) is not None]
    shared = _shared(diagnosed, told, model)
    if shared is not None:
        return [shared]
    # What is possible says nothing of other links.
    for found in long:
        diagnosis = diagnosed_alone(found, model, context.values)
        if diagnosis is not None and (of_long := _of_causes(diagnosis, context)) is not None:
            told.append(of_long)
    unlike = unlike_links(model)
    if told and unlike:
        places = {finding.at for _, finding in told}
        known = {b for b in model.bodies if b.inertia is not None and keyword(b.inertia) in places}
        unlike = [u for u in unlike if known.isdisjoint((u.link, *dict(u.peers)))]
    explained = [(u, misfits(u, model, context.values)) for u in unlike]
    ways = Counter(_way(m) for u, m in explained if u.is_usual)
    odd = (each for each in explained if not each[0].is_usual or _is_odd(each[1], ways))
    return told + [each for u, m in odd if (each := _of_unlike(u, m, model, context)) is not None]


def _is_odd(found: Sequence[Misfit], ways: Counter[tuple[Slip, ...]]) -> bool:
    """Return whether a pair differs in a way in which no other pair does."""
    return bool(found) and found[0].cause.probability >= LIKELY and ways[_way(found)] == 1


def _way(found: Sequence[Misfit]) -> tuple[Slip, ...]:
    return found[0].cause.hypothesis.slips if found else ()


def length_unit(causes: Sequence[Cause]) -> tuple[str, bool]:
    """Return the likeliest unit of a CoM, millimetres if none is, and whether that is sure."""
    units = (c for c in causes if Slip.COM_UNIT in c.hypothesis.slips)
    cause = next(units, None)
    if cause is None:
        return "mm", False
    return cause.hypothesis.unit, cause.probability >= SURE


def _of_matter(diagnosis: Diagnosis) -> Diagnosis:
    """Return a diagnosis without what leaves of no matter a body whose only fault is that."""
    if diagnosis.found.is_impossible or all(map(is_plausible, diagnosis.causes)):
        return diagnosis
    return diagnosis._replace(causes=[*filter(is_plausible, diagnosis.causes)])


def _of_causes(diagnosis: Diagnosis, context: Context) -> _Coded | None:
    """Return what is told of one inertia; made again only where its likely causes have changed."""
    found, causes = diagnosis
    at = at_values(found.inertia, context.values)

    def find() -> _Coded | None:
        if not causes or not _is_told(found, causes):
            return None
        return causes[0].hypothesis.code, _finding(diagnosis, at, context)

    return found.link.facts.made_of(_TELLINGS, (causes, at, context.targets), find)


def _of_unlike(
    unlike: Unlike, found: Sequence[Misfit], model: Model, context: Context
) -> _Coded | None:
    """Return what is told of a link that is not as its counterparts, None if all may be meant."""
    if sum(each.cause.probability for each in found) < LIKELY:
        return None
    first, *others = found
    at, sides = keyword(first.found.inertia), [keyword(m.found.inertia) for m in others]
    related = list(map(Related, sides, unlike_rivals(found)))
    peers = [model.body_named[name] for name in first.peers[:_MOST_RELATED]]
    related += [Related(keyword(t.inertia), f"inertia of '{t.name}'") for t in peers if t.inertia]
    fix = _fix(first.found, first.cause, context)
    code = _OF_MANY if unlike.is_outvoted else _OF_TWO
    probability = first.cause.probability
    return code, Finding(at, unlike_cause(first), tuple(related), fix, probability=probability)


def _is_told(found: Judgement, causes: Sequence[Cause]) -> bool:
    """Return whether numbers are likely to be wrong in a way that is known."""
    first = causes[0]
    if found.verdict is Verdict.POSSIBLE:
        return first.hypothesis.slips == (Slip.TWICE,) and first.probability >= LIKELY
    if not is_plausible(first):
        # Robots have placeholders that are too light; hardly any is denser than all matter. One
        # moment of a body that is wrong as a whole makes it possible too often.
        is_light = density_of(first.hypothesis.body.mass, first.shape.pairs) < GREATEST_DENSITY
        least = _ALONE if first.hypothesis.slips == (Slip.MOMENT,) else LIKELY if is_light else SURE
        return first.probability >= least
    if found.is_impossible or not is_dense_as_matter(found.body.mass, found.second_moments):
        return first.probability >= _POSSIBLE
    return sum(cause.probability for cause in causes) >= LIKELY


def _shared(explained: Sequence[Diagnosis], told: Sequence[_Coded], model: Model) -> _Coded | None:
    """Return the one finding of a document in which every body shows the same slip."""
    fixes = [finding.fix for _, finding in told if finding.fix is not None]
    if not _LEAST_SHARED <= len(fixes) == len(explained):
        return None
    kinds = {causes[0].hypothesis.kind for _, causes in explained}
    moving = [body for body in model.bodies if is_moving(body) and body.inertia is not None]
    if len(kinds) != 1 or len(moving) != len(fixes):
        return None
    (first, (cause, *_)), *others = explained
    changes = tuple(change for fix in fixes for change in fix.changes)
    related = [
        Related(keyword(e.found.inertia), f"inertia of '{e.found.link.name}'") for e in others
    ]
    is_impossible = any(each.found.is_impossible for each in explained)
    finding = Finding(
        keyword(first.inertia),
        shared_cause(len(explained), cause),
        tuple(related[:_MOST_RELATED]),
        Fix(f"{title(cause.hypothesis)} in all links", changes),
        Severity.INFORMATION if is_impossible else Severity.WARNING,
        explains=_EVIDENCE,
        probability=max(each.causes[0].probability for each in explained),
        also=tuple(keyword(each.found.inertia) for each in others),
    )
    return cause.hypothesis.code, finding


def _finding(diagnosis: Diagnosis, at: str, context: Context) -> Finding:
    found, causes = diagnosis
    section = keyword(found.inertia)
    told = f"inertia of '{found.link.name}'"
    if found.verdict is Verdict.POSSIBLE:
        length = sqrt(12.0 * found.second_moments[2].value / found.body.mass)
        told += f" describes a body about {with_unit(length, 'm')} long and"
    elif not found.is_impossible:
        density = density_of(found.body.mass, found.second_moments)
        told += f" implies a density of {with_unit(density, 'kg/m³')} and"
    fix = _fix(found, causes[0], context) if len(causes) == 1 else None
    is_doubt = found.verdict is Verdict.POSSIBLE and causes[0].probability < SURE
    severity = Severity.HINT if is_doubt else Severity.WARNING
    return Finding(
        section,
        likely_cause(told, causes, at),
        tuple(Related(section, rival) for rival in rivals(causes)),
        fix,
        Severity.INFORMATION if found.is_impossible else severity,
        explains=_EVIDENCE,
        probability=causes[0].probability,
    )


def _fix(found: Judgement, cause: Cause, context: Context) -> Fix | None:
    if cause.probability < SURE or not title(cause.hypothesis):
        return None
    changes = _changes(found, cause)
    if not changes or not _holds(found, changes, context):
        return None
    told = title(cause.hypothesis)
    if Slip.NUMBER in cause.hypothesis.slips:
        told = told.replace(cause.hypothesis.names[1], changes[0].text)
    return Fix(told, tuple(changes))


def _changes(found: Judgement, cause: Cause) -> list[Replacement] | None:
    """Return the changes that write the numbers as they were meant."""
    h, (mass, *others) = cause.hypothesis, inertia_expressions(found.inertia)
    if h.body.mass != found.body.mass:
        if Slip.NUMBER in h.slips and mass.literal is not None:
            return [Replacement(mass, significant_decimal(h.body.mass, MOST_DIGITS))]
        return rescaled([mass], [h.body.mass])
    if h.body.com != found.body.com:
        return (rescaled if h.unit else rewritten)(others[:3], h.body.com)
    if Slip.MOMENT in h.slips:
        i = MOMENTS.index(h.names[0])
        return rescaled([others[3 + i]], [h.body.moments[i]])
    if Slip.NUMBER in h.slips:
        typed = others[3 + MOMENTS.index(h.names[0])]
        return [c for c in rescaled(others[3:], h.body.moments) or () if c.at is typed]
    return (rescaled if h.power else rewritten)(others[3:], h.body.moments)


def _holds(found: Judgement, changes: Sequence[Replacement], context: Context) -> bool:
    """Return whether no rule finds anything in the numbers as they would stand there."""
    texts = {change.at.start: change.text for change in changes}
    written = numbers_written(found.inertia, context.values)
    numbers = [
        rewritten_number(texts[value.start]) if value.start in texts else number
        for value, number in zip(inertia_expressions(found.inertia), written, strict=True)
    ]
    plain = _literals(numbers)
    if len(plain) < len(numbers):
        return False
    moments = plain[4:]
    is_document = not isinstance(found.link.island, OtherIsland)
    is_for_robcogen2 = is_document and context.targets != {ROBCOGEN}
    if is_for_robcogen2 and all(map(is_tiny, filter(None, moments[:3]))):
        return False
    is_lost = _has_tiny(moments) and not _has_tiny(_literals(written)[4:])
    if ROBCOGEN2 in context.targets and is_lost:
        return False
    body = MassDistribution.of(plain)
    pairs = eigensystem(second_moments_about_com(body))
    half = likely_half_widths(numbers)
    if verdict_of(body, half, pairs) in IMPOSSIBLE:
        return False
    return can_be_of_matter(body, half, pairs)


def _literals(numbers: Sequence[WrittenDigits]) -> list[float]:
    return [number.literal for number in numbers if number.literal is not None]


def _has_tiny(moments: Sequence[float]) -> bool:
    """Return whether KD507 would find one of six moments too small for robcogen2."""
    plain, products = moments[:3], moments[3:]
    lost = (p for p in products if is_tiny(p) and not is_negligible(p, plain))
    return any(map(is_tiny, plain)) or any(lost)
