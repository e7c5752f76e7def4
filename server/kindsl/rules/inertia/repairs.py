"""What the rules KD306, KD307 and KD308 say, and the fix that they offer."""

from collections.abc import Iterator

from kindsl.rules.base import Finding, Fix, Severity
from kindsl.rules.context import Context
from kindsl.rules.inertia.causes import Cause, Slip, cause_of
from kindsl.rules.inertia.judgements import Judgement, Verdict, judgements, keyword
from kindsl.rules.number_writing import rescaled, rewritten
from kindsl.semantics.declarations import MOMENTS, Declarations

_KEY = "inertia causes"
_POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹"
_TITLES = {
    Slip.REFERENCE: "Shift the moments to the frame's origin",
    Slip.SIGNS: "Negate the products",
    Slip.SCALE: "Convert the moments to kg·m²",
}


def explained(declared: Declarations, context: Context, slip: Slip) -> Iterator[Finding]:
    """Yield a finding for each inertia that a mistake explains whose first part is `slip`."""
    for found in judgements(declared, context):
        if found.is_impossible or found.verdict is Verdict.IMPLAUSIBLE:
            cause = _known_cause(found)
            if cause is not None and cause.slips[0] is slip:
                yield Finding(
                    keyword(found.inertia),
                    f"inertia of '{found.link.name}' is that of a possible body if {_told(cause)}",
                    fix=_fix(found, cause),
                    severity=Severity.INFORMATION,
                )


def _known_cause(found: Judgement) -> Cause | None:
    """Return the cause, computed once for a body as long as its numbers stay."""
    facts, key = found.inertia.island.facts, (_KEY, found.inertia.start)
    known = facts.get(key)
    if not isinstance(known, tuple) or known[0] != found.body:
        known = facts[key] = (found.body, _plausible_cause(found))
    return known[1]  # type: ignore[no-any-return]


def _plausible_cause(found: Judgement) -> Cause | None:
    """Return the cause; signs and reference point say nothing about a wrong density."""
    cause = cause_of(found)
    if cause is not None and found.verdict is Verdict.IMPLAUSIBLE and not cause.power:
        return None
    return cause


def _told(cause: Cause) -> str:
    return " and ".join(_slip_told(slip, cause) for slip in cause.slips)


def _slip_told(slip: Slip, cause: Cause) -> str:
    if slip is Slip.REFERENCE:
        return "its moments are given about the CoM instead of the frame's origin"
    if slip is Slip.SIGNS:
        what = "the sign of" if len(cause.negated) == 1 else "the signs of"
        verb = "is" if len(cause.negated) == 1 else "are"
        return f"{what} {', '.join(cause.negated)} {verb} wrong"
    if cause.unit:
        return f"its moments are given in {cause.unit}"
    sign = "⁻" if cause.power < 0 else ""
    digits = "".join(_POWERS[int(digit)] for digit in str(abs(cause.power)))
    return f"its moments are to be multiplied by 10{sign}{digits}"


def _fix(found: Judgement, cause: Cause) -> Fix | None:
    group = [found.inertia.moments[name] for name in MOMENTS]
    rewrite = rescaled if cause.power else rewritten
    changes = rewrite(group, cause.body.moments)
    return Fix(_TITLES[cause.slips[0]], tuple(changes)) if changes else None
