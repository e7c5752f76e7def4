"""Sentences about mistakes in an inertia."""

from collections.abc import Sequence

from kindsl.judgement.diagnosis.evidence import density, vanishing_products
from kindsl.judgement.diagnosis.judge import Cause
from kindsl.judgement.diagnosis.judgements import TEN, Verdict, can_be_of_matter, verdict_of
from kindsl.judgement.diagnosis.misfits import Misfit
from kindsl.judgement.diagnosis.slips import Hypothesis, Slip
from kindsl.language.text.decimals import significant_decimal
from kindsl.language.text.phrases import listed
from kindsl.language.text.quantities import with_unit

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
# From which probability on a cause is told without doubt, with its fix, and as more likely than
# not. Of 250 planted slips 119 fixes of 121 are right, with twice the doubt 126 of 130, with half
# of it 115 of 117.
SURE, LIKELY = 0.9, 0.5
# Of a number that counterparts have: all that people write.
MOST_DIGITS = 9
_LENGTHS = {"in": "inches"}
_WITHOUT_MEANING = (Slip.PLACEHOLDER, Slip.COPY)
_CLAUSES = {
    Slip.REFERENCE: "the moments were taken about the CoM rather than the frame origin",
    Slip.TWICE: "the moments were shifted to the frame origin once, not twice",
    Slip.ROWS: "the moments were in the order xx xy xz yy yz zz",
    Slip.AXES: "the moments were about the axes {}",
    Slip.COM_UNIT: "the CoM were in {unit}",
    Slip.PLACEHOLDER: "is a placeholder: Ix, Iy and Iz are all {}",
}
_STEPS = {
    Slip.REFERENCE: "Shift the moments to the frame origin",
    Slip.TWICE: "Shift the moments back once",
    Slip.ROWS: "Put the moments in order",
    Slip.AXES: "Turn the moments to the link's axes",
    Slip.SWAP: "Swap {} and {}",
    Slip.COM_ORDER: "Swap {} and {}",
    Slip.COM_UNIT: "Convert the CoM to m",
}


def likely_cause(found: str, causes: Sequence[Cause], at: str = "") -> str:
    """Return what the most likely explanation of a link's inertia says.

    Args:
        found: The words before, `inertia of 'x'`.
        causes: The explanations, the most likely first.
        at: The parameters' values.
    """
    first = _by_itself(causes)[0]
    if first.hypothesis.slips[0] in _WITHOUT_MEANING:
        return f"{found} {clause(first.hypothesis)}{at}"
    verb, said = _verb(first.probability), f"{clause(first.hypothesis)}{at}"
    if not is_plausible(causes[0]):
        verb, said = verb.replace("consistent", "possible"), f"{said}, though not plausible"
    return f"{found} {verb} if {said} ({_why(first)})"


def is_plausible(cause: Cause) -> bool:
    """Return whether the numbers that were meant are of some material, or else like others here.

    Points, and rods without width, have no density to go by.
    """
    h, pairs = cause.hypothesis, cause.shape.pairs
    if h.slips[0] in _WITHOUT_MEANING or cause.log_likelihood > cause.log_alone:
        return True
    is_body = verdict_of(h.body, h.half, pairs) is Verdict.POSSIBLE
    return not is_body or can_be_of_matter(h.body, h.half, pairs)


def _verb(probability: float) -> str:
    if probability >= SURE:
        return "would be consistent"
    return "would most likely be consistent" if probability >= LIKELY else "might be consistent"


def unlike_cause(first: Misfit) -> str:
    """Return what the most likely explanation says of a link that is not as its counterparts."""
    own, said = first.found.link.name, clause(first.cause.hypothesis)
    if first.cause.hypothesis.slips == (Slip.NUMBER,):
        # As it is said of limbs, of which the same may be known.
        what = first.cause.hypothesis.names[0]
        of_both = (each.numbers for each in (first.found.body, first.cause.hypothesis.body))
        written, meant = (significant_decimal(n[TEN.index(what)], MOST_DIGITS) for n in of_both)
        return f"{what} of '{own}' is {written}, by its twins {meant}"
    if first.cause.hypothesis.slips[0] in _WITHOUT_MEANING:
        return f"inertia of '{own}' {said}, unlike that of {_quoted(first.peers)}"
    verb = _verb(first.cause.probability).removesuffix(" consistent")
    if len(first.peers) == 1:
        return f"'{own}' is not the mirror image of '{first.peers[0]}': it {verb} if {said}"
    return f"inertia of '{own}' {verb} that of {_quoted(first.peers)} if {said}"


def unlike_rivals(misfits: Sequence[Misfit]) -> list[str]:
    """Return a sentence for each explanation but the first."""
    said = ((m.found.link.name, m.cause.hypothesis) for m in misfits[1:])
    return [
        f"or '{own}' {clause(h)}"
        if h.slips[0] in _WITHOUT_MEANING
        else f"or '{own}' would be if {clause(h)}"
        for own, h in said
    ]


def _quoted(names: Sequence[str]) -> str:
    return listed([f"'{name}'" for name in names])


def rivals(causes: Sequence[Cause]) -> list[str]:
    """Return a sentence for each explanation but the first."""
    return [
        f"or it {clause(cause.hypothesis)}"
        if cause.hypothesis.slips[0] in _WITHOUT_MEANING
        else f"or if {clause(cause.hypothesis)} ({_why(cause)})"
        for cause in _by_itself(causes)[1:]
    ]


def _by_itself(causes: Sequence[Cause]) -> list[Cause]:
    """Return explanations without the reasons that all of them have."""
    common = set.intersection(*(set(c.reasons) for c in causes)) if len(causes) > 1 else set()
    return [c._replace(reasons=tuple(r for r in c.reasons if r not in common)) for c in causes]


def shared_cause(n_links: int, cause: Cause) -> str:
    """Return what one explanation of all links' inertias says."""
    h = cause.hypothesis
    told = " and ".join(
        "the signs of the products were changed"
        if slip is Slip.SIGNS and not h.is_partial
        else _slip(slip, h)
        for slip in h.slips
    )
    return f"inertias of all {n_links} moving links would be consistent if {told}"


def title(hypothesis: Hypothesis) -> str:
    """Return what the fix does, in the imperative."""
    first, *others = (_step(slip, hypothesis) for slip in hypothesis.slips)
    others = [step[0].lower() + step[1:] for step in others]
    return listed([first, *others])


def clause(hypothesis: Hypothesis) -> str:
    """Return what was done wrong, to stand behind `if`."""
    return " and ".join(_slip(slip, hypothesis) for slip in hypothesis.slips)


def _slip(slip: Slip, h: Hypothesis) -> str:
    if slip in (Slip.SIGNS, Slip.COM_SIGN, Slip.MINUS):
        return f"the {'sign' if len(h.names) == 1 else 'signs'} of {listed(h.names)} were changed"
    if slip is Slip.SIGNS_THERE:
        return f"the signs of {listed(h.names)} were changed about the CoM"
    if slip in (Slip.SWAP, Slip.COM_ORDER):
        return f"{listed(h.names)} were swapped"
    if slip is Slip.MOMENT:
        return f"{h.names[0]} were {_times(h.power)}"
    if slip is Slip.NUMBER:
        return f"{'the ' if h.names[0] == 'mass' else ''}{h.names[0]} were {h.names[1]}"
    if slip in (Slip.MASS, Slip.SCALE):
        what = "the mass were" if slip is Slip.MASS else "the moments were"
        return f"{what} in {h.unit}" if h.unit else f"{what} {_times(h.power)}"
    if slip is Slip.COPY:
        return f"has the {h.names[1]} of '{h.names[0]}', which is another part"
    return _CLAUSES[slip].format(*h.names, unit=_LENGTHS.get(h.unit, h.unit))


def _step(slip: Slip, h: Hypothesis) -> str:
    if slip in (Slip.SCALE, Slip.MASS):
        what, unit = ("mass", "kg") if slip is Slip.MASS else ("moments", "kg·m²")
        return f"Convert the {what} to {unit}" if h.unit else f"Multiply the {what} by {_ten(h)}"
    if slip is Slip.MOMENT:
        return f"Multiply {h.names[0]} by {_ten(h)}"
    if slip is Slip.NUMBER:
        return f"Set {h.names[0]} to {h.names[1]}"
    if slip in (Slip.SIGNS, Slip.COM_SIGN, Slip.MINUS):
        return f"Change sign of {', '.join(h.names)}"
    if slip is Slip.SIGNS_THERE:
        return f"Change sign of {', '.join(h.names)} about the CoM"
    return _STEPS.get(slip, "").format(*h.names)


def _times(power: int) -> str:
    return f"multiplied by {10**power}" if power > 0 else f"divided by {10**-power}"


def _ten(h: Hypothesis) -> str:
    return f"10{str(h.power).translate(_RAISED)}"


def _why(cause: Cause) -> str:
    """Return what speaks for a mistake."""
    said = [f"density {with_unit(density(cause.hypothesis.body.mass, cause.shape), 'kg/m³')}"]
    x, y, z = cause.hypothesis.body.com
    is_telling = any((x * y, x * z, y * z))
    if is_telling and all(vanishing_products(cause.shape)):
        said.append("principal axes along the link's")
    return ", ".join((*said, *cause.reasons))
