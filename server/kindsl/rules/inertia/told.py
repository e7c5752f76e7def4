"""Sentences about mistakes in an inertia."""

from collections.abc import Sequence

from kindsl.rules.inertia.causes import Cause
from kindsl.rules.inertia.likelihood import density, vanishing_products
from kindsl.rules.inertia.slips import Hypothesis, Slip
from kindsl.text.phrases import listed
from kindsl.text.quantities import with_unit

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_GRAMS = -3


def likely_cause(name: str, cause: Cause, at: str = "") -> str:
    """Return what a single explanation of a link's inertia says."""
    return (
        f"inertia of '{name}' would be consistent if {clause(cause.hypothesis)}{at} ({_why(cause)})"
    )


def several_causes(name: str, causes: Sequence[Cause], at: str = "") -> str:
    """Return what several explanations say, the most likely first."""
    common = set.intersection(*(set(cause.reasons) for cause in causes))
    own = [c._replace(reasons=tuple(r for r in c.reasons if r not in common)) for c in causes]
    told = "; or if ".join(f"{clause(c.hypothesis)} ({_why(c)})" for c in own)
    return f"inertia of '{name}' would be consistent{at} if {told}"


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
    if slip is Slip.REFERENCE:
        return "the moments were taken about the CoM rather than the frame origin"
    if slip in (Slip.SIGNS, Slip.COM_SIGN):
        return f"the {'sign' if len(h.names) == 1 else 'signs'} of {listed(h.names)} were changed"
    if slip is Slip.SWAP:
        return f"{listed(h.names)} were swapped"
    if slip is Slip.MASS:
        return "the mass were in g" if h.power == _GRAMS else f"the mass were {_times(h.power)}"
    return f"the moments were in {h.unit}" if h.unit else f"the moments were {_times(h.power)}"


def _step(slip: Slip, h: Hypothesis) -> str:
    if slip is Slip.REFERENCE:
        return "Shift the moments to the frame origin"
    if slip is Slip.SCALE:
        return "Convert the moments to kg·m²" if h.unit else f"Multiply the moments by {_ten(h)}"
    return f"Change sign of {', '.join(h.names)}"


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
