"""Possible bodies, rounded as people round, are never called impossible."""

import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.support.bodies import (
    SHAPES,
    Writer,
    decimals,
    document_of_bodies,
    inertia_text,
    random_body,
    short_decimals,
    significant,
)

from kindsl.analysis.analysis import analyse
from kindsl.analysis.settings import Settings
from kindsl.rigid.body import (
    MassDistribution,
    eigensystem,
    principal_moments,
    second_moments_about_com,
)
from kindsl.rules.inertia.judgements import Verdict, verdict_of

WRITERS = [
    pytest.param(kind(digits), id=f"{kind.__name__}-{digits}")
    for kind in (decimals, short_decimals, significant)
    for digits in range(2, 7)
]
ONLY_INERTIA = Settings(select=("KD301", "KD302", "KD303"))
BODIES = 670


@pytest.mark.parametrize("write", WRITERS)
def test_rounded_possible_body_is_no_error(write: Writer) -> None:
    generator = random.Random(f"honest {write(1 / 3)}")
    bodies = [random_body(generator, SHAPES[n % len(SHAPES)]) for n in range(BODIES)]
    text = document_of_bodies([inertia_text(body, write) for body in bodies])
    found = analyse(text, ONLY_INERTIA).findings
    wrong = [f for f in found if f.severity == "error" and "mass" not in f.message]
    assert [text[f.start : f.start + 200] for f in wrong] == []


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
