"""What is found after edits is what is found in the same text from scratch."""

import random
import re

from hypothesis import given, settings
from hypothesis import strategies as st
from tests.support.amount import usually
from tests.support.models import Style, random_model
from tests.support.walkers import LEGS, walker

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.edits import TextEdit

MODEL = random_model(8, 9, Style(has_expressions=True))
SETTINGS = Settings(
    targets=frozenset({"robcogen"}),
    bindings={"offset": Binding(0.1), "load": Binding(2.0, 0.0, 9.0)},
)
PIECES = (
    "", "0", "1.0", "-", "x", "segment_1", "joint_2", "load", "offset[0.2]", "{", "}", "id = 3\n",
    "link segment_9 {\n", "/*", "*/", "// kindsl: ignore[KD3]\n", "segment_4 via joint_5\n",
)  # fmt: skip


@settings(max_examples=usually(15, thoroughly=40), deadline=None)
@given(seed=st.integers(0, 10**9))
def test_findings_after_edits_are_those_from_scratch(seed: int) -> None:
    generator = random.Random(seed)
    analysis = analyse(MODEL, SETTINGS)
    for _ in range(5):
        start = generator.randrange(len(analysis.text) + 1)
        end = min(len(analysis.text), start + generator.choice((0, 0, 1, 3, 12)))
        analysis = analysis.edited([TextEdit(start, end, generator.choice(PIECES))])
        assert analysis.findings == analyse(analysis.text, SETTINGS).findings


@settings(max_examples=10, deadline=None)
@given(st.lists(st.floats(-1.0, 5.0), min_size=2, max_size=4))
def test_findings_follow_the_values(masses: list[float]) -> None:
    text = MODEL.replace("mass = ", "mass = load // ", 1)
    analysis = analyse(text, SETTINGS)
    for mass in masses:
        settings = SETTINGS._replace(bindings={**SETTINGS.bindings, "load": Binding(mass)})
        analysis = analysis.with_settings(settings)
        assert analysis.findings == analyse(text, settings).findings


@settings(max_examples=40, deadline=None)
@given(first=st.integers(0, 12), last=st.integers(0, 12), at=st.integers(0, 12))
def test_blocks_pasted_beside_their_twins_are_blocks_of_their_own(
    first: int, last: int, at: int
) -> None:
    analysis = analyse(MODEL, SETTINGS)
    bounds = [*analysis.syntax.starts, len(MODEL)]
    piece = MODEL[bounds[min(first, last)] : bounds[max(first, last) + 1]]
    pasted = analysis.edited([TextEdit(bounds[at], bounds[at], piece)])
    assert pasted.findings == analyse(pasted.text, SETTINGS).findings


NUMBER = re.compile(r"(?<![\w.])-?\d+\.\d+")
SECTION = re.compile(r"inertia_params \{.*?\}", re.DOTALL)


def edit_of_a_body_or_its_neighbours(generator: random.Random, text: str) -> TextEdit:
    """Return a number changed, an inertia copied from another link, or a leg renamed somewhere."""
    kind = generator.random()
    if kind < 0.5:
        at = generator.choice(list(NUMBER.finditer(text)))
        value = float(at[0]) * generator.choice((-1.0, -1.0, 1.02, 2.0, 1e3, 1e-3, 0.0))
        return TextEdit(at.start(), at.end(), f"{value:.9f}")
    if kind < 0.8:
        source, at = generator.sample(list(SECTION.finditer(text)), 2)
        return TextEdit(at.start(), at.end(), source[0])
    at = generator.choice(list(re.finditer("|".join(LEGS), text)))
    return TextEdit(at.start(), at.end(), generator.choice(LEGS))


@settings(max_examples=usually(8, thoroughly=100), deadline=None)
@given(seed=st.integers(0, 10**9))
def test_causes_after_edits_of_neighbours_are_those_from_scratch(seed: int) -> None:
    generator = random.Random(seed)
    analysis = analyse(walker(generator), SETTINGS)
    for _ in range(10):
        if generator.random() < 0.2:
            targets = frozenset(generator.choice(((), ("robcogen",), ("robcogen2",))))
            load = {"load": Binding(generator.choice((1.0, 1.5, 1000.0)))}
            analysis = analysis.with_settings(Settings(targets, bindings=load))
        else:
            edit = edit_of_a_body_or_its_neighbours(generator, analysis.text)
            analysis = analysis.edited([edit])
        assert analysis.findings == analyse(analysis.text, analysis.settings).findings
