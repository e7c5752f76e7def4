"""Edit after edit of a document: what is found is what a fresh analysis finds, every time.

Where all cases are tried, these are ten thousand edits of long documents. A fresh analysis takes
ten times as long as the edit, so what is found is compared after a part of the edits.
"""

import random
import re

import pytest
from tests.support.amount import usually
from tests.support.models import Style, random_model
from tests.support.walkers import LEGS, walker

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.edits import TextEdit

LONG, SHORT = 300, 30
N_STEPS = usually(15, thoroughly=120)
COMPARED = usually(0.5, thoroughly=0.25)
SESSIONS = [
    *((LONG, seed) for seed in range(usually(1, thoroughly=100))),
    *((SHORT, seed) for seed in range(usually(1, thoroughly=30))),
]
BINDINGS = {"offset": Binding(0.1), "load": Binding(2.0, 0.0, 9.0)}
CHOICES = [
    Settings(frozenset(t), bindings=BINDINGS) for t in ((), (), ("robcogen",), ("robcogen2",))
]
NUMBER = re.compile(r"(?<![\w.])-?\d+\.\d+")
NAME = re.compile(r"\b(?:segment|joint|frame|LF|RF|LH|RH|left|right|trunk)\w*")
BLOCK = re.compile(r"(?:link|[rp]_joint) \w+ \{.*?\n\}\n", re.DOTALL)
SECTION = re.compile(r"(?:inertia_params|children|ref_frame|frames) \{[^{}]*\}")
LINE = re.compile(r"[^\n]*\n")
PIECES = (
    "", "0", "-", "x", "load", "offset[0.2]", "2.0 load", "pi", "1.0e3", "{", "}", "id = 3\n",
    "link segment_9 {\n", "/*", "*/", "// kindsl: ignore[KD3]\n", "segment_4 via joint_5\n", "^",
)  # fmt: skip


def document(generator: random.Random, n_links: int) -> str:
    """Return a tree of links whose base carries four legs besides, with mistakes in them."""
    plain = random_model(n_links, generator.randrange(99), Style(tree="tree", has_expressions=True))
    legs = "".join(match[0] for match in BLOCK.finditer(walker(generator)))
    legs = re.sub(r"\bid = (\d+)", lambda match: f"id = {n_links + int(match[1])}", legs)
    pairs = "".join(f" {leg}_hip via {leg}_top" for leg in LEGS)
    tree = plain.replace("children {", f"children {{{pairs}", 1).rstrip().removesuffix("}")
    first_joint = re.search(r"^[rp]_joint", tree, re.MULTILINE)
    assert first_joint is not None
    legs, joints = legs[: legs.index("r_joint")], legs[legs.index("r_joint") :]
    return f"{tree[: first_joint.start()]}{legs}{tree[first_joint.start() :]}{joints}}}\n"


def edit(generator: random.Random, text: str) -> TextEdit:
    """Return what somebody may do: type, change a number, rename, copy or remove a part."""

    def one_of(pattern: re.Pattern[str]) -> re.Match[str]:
        return generator.choice(list(pattern.finditer(text)) or [re.search("", text)])  # type: ignore[list-item]

    kind = generator.random()
    if kind < 0.35:
        at = one_of(NUMBER)
        value = float(at[0] or 0) * generator.choice((-1.0, 1.02, 2.0, 1e3, 1e-3, 0.0))
        return TextEdit(at.start(), at.end(), f"{value:.6f}")
    if kind < 0.5:
        return TextEdit(*one_of(NAME).span(), one_of(NAME)[0])
    if kind < 0.75:
        pattern = generator.choice((BLOCK, SECTION, LINE))
        place, source = one_of(pattern), one_of(pattern)
        return TextEdit(place.start(), place.end(), generator.choice(("", source[0], 2 * place[0])))
    start = generator.randrange(len(text) + 1)
    end = min(len(text), start + generator.choice((0, 0, 1, 3, 12)))
    return TextEdit(start, end, generator.choice(PIECES))


def assert_as_fresh(analysis: Analysis) -> None:
    """Check that nothing is told otherwise than of the same text alone, and no rule fails."""
    fresh = analyse(analysis.text, analysis.settings)
    assert analysis.findings == fresh.findings
    assert analysis.faults == fresh.faults == ()


@pytest.mark.parametrize(("n_links", "seed"), SESSIONS)
def test_every_edit_of_a_session_finds_what_a_fresh_analysis_does(n_links: int, seed: int) -> None:
    generator = random.Random(seed)
    versions = [analyse(document(generator, n_links), CHOICES[0])]
    for step in range(1, N_STEPS + 1):
        last = versions[-1]
        kind = generator.random()
        if kind < 0.6 or len(versions) == 1:
            versions.append(last.edited([edit(generator, last.text)]))
        elif kind < 0.65:
            versions.append(last.with_settings(generator.choice(CHOICES)))
        elif kind < 0.7:
            # Somebody types on before the answer is there.
            versions[-1] = last.edited([edit(generator, last.text)])
            versions[-1] = versions[-1].edited([edit(generator, versions[-1].text)])
        elif kind < 0.85:
            back = TextEdit(0, len(last.text), versions.pop(-2).text)
            versions.append(last.edited([back]))
        else:
            versions.pop()
        if step == N_STEPS or generator.random() < COMPARED:
            assert_as_fresh(versions[-1])
        assert versions[-1].faults == ()


def test_a_block_that_becomes_as_a_later_one_is_not_taken_for_that() -> None:
    """Both have the same name, and the later one is told to be out of order."""

    def text(mass: str) -> str:
        twins = [f"link twin {{ id = 1 inertia_params {{ mass = {m} }} }}\n" for m in (mass, "2.0")]
        return f"Robot R {{ RobotBase b {{}}\n{twins[0]}link other {{ id = 2 }}\n{twins[1]}"

    last = analyse(text("1.0"))
    assert "KD701" in {finding.code for finding in last.findings}
    assert_as_fresh(last.edited([TextEdit(0, len(last.text), text("2.0"))]))
