"""What every mistake that may have been made at some bodies weighs, so that no weight drifts.

The weights are in `recorded/causes.txt`; how they get there: `tests/support/recorded.py`.
"""

import random
from collections.abc import Callable, Iterator
from pathlib import Path

from tests.support.bodies import document_of_bodies, inertia_text, random_body, significant
from tests.support.recorded import assert_as_recorded

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.diagnosis.judge import Cause, candidates, diagnoses
from kindsl.judgement.diagnosis.slips import Hypothesis, hypotheses
from kindsl.judgement.diagnosis.surroundings import surroundings
from kindsl.judgement.diagnosis.suspects import suspects_of
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    eigensystem,
    second_moments_about_com,
    shifted,
)
from kindsl.mechanics.rigid.matter import density_of

RECORDED = Path(__file__).parent / "recorded" / "causes.txt"
# Twins on two sides, each with a joint and a frame ahead.
DOCUMENT = """Robot Walker {
RobotBase trunk { children { LF_leg via LF_hip RF_leg via RF_hip LH_leg via LH_hip } }
%s
link toe { id = 4 children { } }
r_joint LF_hip { ref_frame { translation = (0.1, 0.2, 0.0) rotation = (0.0, 0.0, 0.0) } }
r_joint RF_hip { ref_frame { translation = (0.1, -0.2, 0.0) rotation = (0.0, 0.0, 0.0) } }
r_joint LH_hip { ref_frame { translation = (-0.1, 0.2, 0.0) rotation = (0.0, 0.0, 0.0) } }
r_joint ankle { ref_frame { translation = (0.3, 0.05, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
"""
LINK = """link %s { id = %d %s children { %s }
    frames { sole { translation = (0.25, 0.0, -0.02) rotation = (0.0, 0.0, 0.0) } } }
"""


def slipped(change: Callable[[list[float]], list[float]]) -> Callable[..., MassDistribution]:
    """Return what changes the moments so."""
    return lambda body: body._replace(moments=tuple(change(list(body.moments))))


PLANTED: dict[str, Callable[[MassDistribution], MassDistribution]] = {
    "all signs": slipped(lambda m: [*m[:3], *(-x for x in m[3:])]),
    "one sign": slipped(lambda m: [*m[:3], -m[3], *m[4:]]),
    "about the CoM": lambda body: shifted(body, -1.0),
    "g·mm²": slipped(lambda m: [1e9 * x for x in m]),
    "kg·mm²": slipped(lambda m: [1e6 * x for x in m]),
    "g·cm²": slipped(lambda m: [1e7 * x for x in m]),
    "kg·cm²": slipped(lambda m: [1e4 * x for x in m]),
    "t·mm²": slipped(lambda m: [1e3 * x for x in m]),
    "a digit": slipped(lambda m: [10.0 * x for x in m]),
    "two digits": slipped(lambda m: [0.01 * x for x in m]),
    "two swapped": slipped(lambda m: [m[2], m[1], m[0], *m[3:]]),
    "CoM's sign": lambda body: body._replace(com=(-body.com[0], *body.com[1:])),
    "grams": lambda body: body._replace(mass=1000.0 * body.mass),
}


def of_light_metal(body: MassDistribution) -> MassDistribution:
    """Return a body of the same shape, of 2000 kg/m³."""
    pairs = eigensystem(second_moments_about_com(body))
    factor = 2000.0 / density_of(body.mass, pairs)
    moments = tuple(factor * moment for moment in body.moments)
    return body._replace(mass=factor * body.mass, moments=moments)


def mirrored(body: MassDistribution) -> MassDistribution:
    x, y, z = body.com
    ix, iy, iz, ixy, ixz, iyz = body.moments
    return MassDistribution(body.mass, (x, -y, z), (ix, iy, iz, -ixy, ixz, -iyz))


def documents() -> Iterator[tuple[str, str]]:
    """Yield documents in which one leg, or each, has a slip; the others are its twins."""
    generator = random.Random("walkers")
    for name, plant in PLANTED.items():
        for shape in ("block", "slender"):
            right = of_light_metal(random_body(generator, shape))
            for count in (1, 3) if shape == "block" else ():
                legs = [right, mirrored(right), right]
                legs = [plant(leg) if k < count else leg for k, leg in enumerate(legs)]
                yield f"{name}, {shape}, at {count}", document(legs)
            alone = inertia_text(plant(right), significant(4))
            yield f"{name}, {shape}, alone", document_of_bodies([alone])


def document(legs: list[MassDistribution]) -> str:
    names = zip(("LF_leg", "RF_leg", "LH_leg"), ("toe via ankle", "", ""), legs, strict=True)
    texts = [
        LINK % (name, number, inertia_text(body, significant(4)), children)
        for number, (name, children, body) in enumerate(names, 1)
    ]
    return DOCUMENT % "".join(texts)


def weights() -> Iterator[str]:
    body = of_light_metal(random_body(random.Random("slips"), "block"))
    half = MassDistribution(0.01, (0.001, 0.002, 0.003), (0.01, 0.02, 0.03, 0.04, 0.05, 0.06))
    yield "## every slip"
    without_products = body._replace(moments=(*body.moments[:3], 0.0, 0.0, 0.0))
    for h in (*hypotheses(body, half), *hypotheses(without_products, half)):
        told = f"{_slips(h)}: weight {h.weight:.4g}, {h.is_partial} {h.sort} {h.kinds}"
        yield told.replace("<Slip.", "").replace(">", "")
        numbers = (*h.body.com, *h.body.moments, h.half.mass, *h.half.moments)
        yield f"    {h.body.mass:.6g} {' '.join(f'{x:.6g}' for x in numbers)}"
    for title, text in documents():
        analysis = analyse(text)
        yield f"## {title}"
        model, context = analysis.model, analysis.context
        suspects = suspects_of(model, context.values)
        for found in suspects:
            yield f"{found.link.name}: {found.verdict.value}"
            for cause in candidates(found, surroundings(model, context.values, found)):
                h = cause.hypothesis
                yield f"    {_slips(h)}: weight {h.weight:.4g}, log {cause.log_likelihood:.5g}"
        for found, causes in diagnoses(suspects, model, context.values):
            told = (f"{_slips(c.hypothesis)} {c.probability:.3f}{_reasons(c)}" for c in causes)
            yield f"{found.link.name} of all: {'; '.join(told)}"
        for finding in analysis.findings:
            if finding.code.startswith("KD3"):
                title = f" [{finding.fix.title}]" if finding.fix is not None else ""
                yield f"{finding.code} {finding.message}{title}"


def _slips(h: Hypothesis) -> str:
    parts = [*(slip.value for slip in h.slips), *h.names, h.unit or f"10^{h.power}" * bool(h.power)]
    return " ".join(part for part in parts if part)


def _reasons(cause: Cause) -> str:
    return f" ({', '.join(cause.reasons)})" if cause.reasons else ""


def test_weights_are_as_recorded() -> None:
    assert_as_recorded(RECORDED, weights())
