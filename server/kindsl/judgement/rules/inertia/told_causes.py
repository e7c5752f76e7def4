"""What is told of mistakes in the inertias of a document, found once for all rules that tell it."""

from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from kindsl.judgement.diagnosis.judgements import keyword
from kindsl.judgement.diagnosis.suspects import long_suspects_of, suspects_of
from kindsl.judgement.diagnosis.unlike import unlike_links
from kindsl.judgement.rules.base import Finding, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Link, Vector
from kindsl.language.semantics.model import Model
from kindsl.language.text.facts import Fact

_CAUSES = Fact[tuple[object, list[tuple[str, Finding]]]]("inertia causes")


def rule_of_causes(module: str) -> Rule:
    """Return the rule of a module that does nothing but tell the mistakes that belong to it."""
    rule = Rule(module, Severity.INFORMATION, reads=Aspect.NUMBERS)
    return rule._replace(check_document=partial(explained, code=rule.code))


def explained(model: Model, context: Context, code: str) -> Iterator[Finding]:
    """Yield a finding for each inertia whose most likely mistake belongs to a rule."""
    yield from (finding for own, finding in told_causes(model, context) if own == code)


def told_causes(model: Model, context: Context) -> list[tuple[str, Finding]]:
    """Return all that is told of mistakes in inertias, with the code of its rule."""
    return model.facts.made_of(_CAUSES, context, partial(_findings, model, context))


def has_cause(model: Model, context: Context, link: Link, *codes: str) -> bool:
    """Return whether a rule, of some or any, tells a mistake of a link's inertia, or its pair's."""
    at = keyword(link.inertia) if link.inertia is not None else None
    return at is not None and any(
        (not codes or code in codes) and at in (told.at, *(each.at for each in told.related))
        for code, told in told_causes(model, context)
    )


class SuspectCom(NamedTuple):
    """The CoM of an impossible inertia.

    Attributes:
        unit: The likeliest that it may be in.
        is_sure: Whether a fix may rely on it.
    """

    unit: str
    is_sure: bool


def suspect_coms(model: Model, context: Context) -> dict[Vector, SuspectCom]:
    """Return the CoMs of impossible inertias."""
    suspects = suspects_of(model, context.values)
    if not any(found.is_impossible for found in suspects):
        return {}
    # Imported for suspects only, since it delays the linter's start.
    from kindsl.judgement.diagnosis.judge import diagnoses
    from kindsl.judgement.rules.inertia.repairs import length_unit

    return {
        found.inertia.com: SuspectCom(*length_unit(causes))
        for found, causes in diagnoses(suspects, model, context.values)
        if found.is_impossible and found.inertia.com is not None
    }


def _findings(model: Model, context: Context) -> list[tuple[str, Finding]]:
    suspects = suspects_of(model, context.values)
    long = long_suspects_of(model, context.values)
    if not suspects and not long and not unlike_links(model):
        return []
    # Imported for suspects only, since it delays the linter's start.
    from kindsl.judgement.rules.inertia.repairs import findings

    return findings(suspects, long, model, context)
