"""The slip, or the other link, that explains a possible inertia which is not that of its peers."""

from collections.abc import Container

from kindsl.judgement.diagnosis.counterparts import may_be_image
from kindsl.judgement.diagnosis.slips import Hypothesis, Slip, hypotheses
from kindsl.judgement.diagnosis.surroundings import same_moments
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.limbs.comparison import Tolerance
from kindsl.robots.limbs.weighing import differing

# Of numbers that are equal but for the arithmetic that brought them into one frame.
_EXACTLY = Tolerance(1e-9, 1e-9, 1e-9)


def copied_from(model: Model, link: Link, peers: Container[str]) -> str:
    """Return of which link that is no peer the moments are, empty where they are of none."""
    other = next((name for name in same_moments(model, link) if name not in peers), None)
    return f"its moments are those of '{other}', which is another part" if other else ""


def slip_of(own: MassDistribution, meant: MassDistribution) -> Hypothesis | None:
    """Return the commonest slip without which a body is the one that is meant, None if none is.

    A unit beside a shift would leave nothing of the moments as they are written. Where some slips
    leave exactly what is meant, others that come near it are none.
    """
    is_likely = meant.mass * own.mass > 0.0 and may_be_image(own, meant)
    fitting = [
        h
        for h in (hypotheses(own, own) if is_likely else ())
        if (Slip.SCALE not in h.slips or (h.unit and len(h.slips) == 1))
        and not differing(h.body, meant)
    ]
    exact = [h for h in fitting if not differing(h.body, meant, _EXACTLY)]
    return max(exact or fitting, key=lambda h: h.weight, default=None)
