"""Possible bodies, rounded as people round, are never called impossible."""

import random
from decimal import ROUND_DOWN, ROUND_HALF_EVEN

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.support.amount import usually
from tests.support.bodies import (
    SHAPES,
    Writer,
    decimals,
    document_of_bodies,
    inertia_text,
    mixed,
    plainly,
    random_body,
    short_decimals,
    significant,
)

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.diagnosis.judgements import Verdict, verdict_of
from kindsl.language.semantics.parameters import Binding
from kindsl.mechanics.rigid.body import (
    MassDistribution,
    eigensystem,
    principal_moments,
    second_moments_about_com,
    seen_from,
)
from kindsl.mechanics.rigid.pose import pose_from

WRITERS = [
    pytest.param(kind(digits), id=f"{kind.__name__}-{digits}")
    for kind in (decimals, short_decimals, significant)
    for digits in range(2, 7)
]
ONLY_INERTIA = Settings(select=("KD301", "KD302", "KD303"))
BODIES = usually(150, 670)
MIXED = usually(150, 3000)


@pytest.mark.parametrize("write", WRITERS)
def test_rounded_possible_body_is_no_error(write: Writer) -> None:
    generator = random.Random(f"honest {write(1 / 3)}")
    bodies = [random_body(generator, SHAPES[n % len(SHAPES)]) for n in range(BODIES)]
    text = document_of_bodies([inertia_text(body, write) for body in bodies])
    found = analyse(text, ONLY_INERTIA).findings
    wrong = [f for f in found if f.severity == "error" and "mass" not in f.message]
    assert [text[f.start : f.start + 200] for f in wrong] == []


@pytest.mark.parametrize("far", [0.0, 5.0], ids=["near", "far"])
@pytest.mark.parametrize("shorten", [ROUND_HALF_EVEN, ROUND_DOWN], ids=["rounded", "cut"])
@pytest.mark.parametrize("kind", ["decimals", "significant"])
def test_body_of_numbers_of_mixed_length_is_no_error(kind: str, shorten: str, far: float) -> None:
    generator = random.Random(f"mixed {kind} {shorten} {far}")
    write = mixed(generator, kind, shorten)
    texts = []
    for n in range(MIXED):
        body = random_body(generator, SHAPES[n % len(SHAPES)])
        place = pose_from(tuple(generator.uniform(-far, far) for _ in range(3)), (0.0,) * 3)
        texts.append(inertia_text(seen_from(body, place), write))
    text = document_of_bodies(texts)
    found = analyse(text, ONLY_INERTIA).findings
    wrong = [f for f in found if f.severity == "error" and "mass" not in f.message]
    assert [text[f.start : f.start + 200] for f in wrong] == []


def test_body_of_four_short_and_two_long_moments_is_no_error() -> None:
    """A thin plate, as a script and a person write it together."""
    generator = random.Random("four and two")
    texts = []
    for _ in range(MIXED):
        body = random_body(generator, "plate")
        digits = [6, 6, 6, 6, 12, 12]
        generator.shuffle(digits)
        moments = tuple(float(f"{m:.{d}f}") for m, d in zip(body.moments, digits, strict=True))
        texts.append(inertia_text(body._replace(moments=moments), plainly))
    text = document_of_bodies(texts)
    assert [f for f in analyse(text, ONLY_INERTIA).findings if f.severity == "error"] == []


@pytest.mark.parametrize("values", ["parameters", "constants", "defaults", "factors"])
def test_body_of_rounded_expressions_is_no_error(values: str) -> None:
    """A thin plate's numbers are rounded, wherever they stand."""
    generator = random.Random(f"expressions {values}")
    write = mixed(generator, "decimals", ROUND_HALF_EVEN)
    bindings: dict[str, Binding] = {}

    def expression(value: float) -> str:
        name = f"p{len(bindings)}"
        if values == "factors":
            factor = generator.choice(("2.0", "0.500", "4.00"))
            return f"{factor}*{write(value / float(factor))}"
        bindings[name] = Binding(float(write(value)))
        if values == "parameters":
            return name
        text = write(value)
        return f"<{name}={text}>" if values == "constants" else f"d{name}[{text}]"

    bodies = [random_body(generator, "plate") for _ in range(100)]
    text = document_of_bodies([inertia_text(body, expression) for body in bodies])
    used = ONLY_INERTIA._replace(bindings=bindings)
    found = analyse(text, used).findings
    assert any(f.severity in ("hint", "warning") for f in found)
    assert [f for f in found if f.severity == "error" and "mass" not in f.message] == []


@settings(deadline=None)
@given(seed=st.integers(0, 10**9), shape=st.sampled_from(SHAPES))
def test_exact_possible_body_is_no_error(seed: int, shape: str) -> None:
    body = random_body(random.Random(seed), shape)
    exact = MassDistribution(0.0, (0.0, 0.0, 0.0), (0.0,) * 6)
    verdict = verdict_of(body, exact, eigensystem(second_moments_about_com(body)))
    assert verdict not in (Verdict.TRIANGLE, Verdict.INDEFINITE)


@settings(max_examples=200, deadline=None)
@given(seed=st.integers(0, 10**9), factor=st.floats(1.02, 5.0), axis=st.integers(0, 2))
def test_body_flatter_than_a_plate_is_an_error(seed: int, factor: float, axis: int) -> None:
    body = random_body(random.Random(seed), "plate")
    pairs = eigensystem(second_moments_about_com(body))
    small, middle, large = principal_moments(pairs)
    moments = [small, middle, large * factor]
    moments[axis], moments[2] = moments[2], moments[axis]
    flat = MassDistribution(body.mass, (0.0, 0.0, 0.0), (*moments, 0.0, 0.0, 0.0))
    text = document_of_bodies([inertia_text(flat, significant(6))])
    assert [f.code for f in analyse(text, ONLY_INERTIA).findings] == ["KD302"]
