"""All findings in full: messages, places, related places, fixes as the text that they write.

Of every rule's bad examples, of the documents with marks, of a document with each of its tokens
lost. The findings are in `recorded/`; how they get there: `tests/support/recorded.py`.
"""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.features.samples import BROKEN, PARAMETRIC, TANGLED
from tests.support.example_documents import bindings_of, document_of, examples_of
from tests.support.markers import marked_files
from tests.support.recorded import Teller, assert_as_recorded
from tests.support.robots import STUB

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.judgement.rules.registry import all_rules
from kindsl.language.syntax.document import parse

FOLDER = Path(__file__).parent / "recorded"
FIXTURES = sorted((Path(__file__).parents[1] / "fixtures" / "rules").glob("*.kindsl"))


def told(analysis: Analysis, prefix: str = "KD") -> Iterator[str]:
    """Yield the lines about the findings whose codes begin so."""
    teller = Teller(analysis.text)
    for finding in analysis.findings:
        if finding.code.startswith(prefix):
            yield from _told(finding, teller)


def _told(finding: Diagnostic, teller: Teller) -> Iterator[str]:
    place = teller.span(finding.start, finding.end)
    tag = f" ({finding.tag})" if finding.tag else ""
    yield f"{finding.severity}[{finding.code}]{tag} {place}: {finding.message}"
    for related in finding.related:
        yield f"    see {teller.span(related.start, related.end)}: {related.message}"
    fixes = [(finding.fix, "fix")] if finding.fix else []
    for fix, kind in [*fixes, *((choice, "choice") for choice in finding.choices)]:
        yield from _fix(fix, kind, teller)


def _fix(fix: TextFix, kind: str, teller: Teller) -> Iterator[str]:
    yield f"    {'safe' if fix.is_safe else 'unsafe'} {kind}: {fix.title}"
    for edit in fix.edits:
        yield f"        {teller.span(edit.start, edit.end)} -> {edit.text!r}"


def of_examples() -> Iterator[str]:
    for rule in all_rules():
        for number, example in enumerate(examples_of(rule).bad, 1):
            yield f"## {rule.code} {number}"
            targets = () if isinstance(example, str) else example.targets
            settings = Settings(frozenset(targets), ("KD",), bindings=bindings_of(example))
            yield from told(analyse(document_of(example), settings), rule.code)


def of_documents() -> Iterator[str]:
    files = [(path.stem, path.read_text(encoding="utf-8")) for path in FIXTURES]
    named = [(f"{stem}: {d.name}", d.text) for stem, text in files for d in marked_files(text)]
    named += [("gripper", PARAMETRIC), ("half", BROKEN), ("tangled", TANGLED)]
    for name, text in named:
        for targets in ((), ("robcogen",), ("robcogen2",)):
            yield f"## {name} {' '.join(targets)}".rstrip()
            yield from told(analyse(text, Settings(frozenset(targets), ("KD",))))


def without_a_token(text: str) -> Iterator[tuple[str, str]]:
    """Yield each token with the text that lacks it."""
    document = parse(text)
    for start, island in zip(document.starts, document.islands, strict=True):
        for token in island.tokens:
            at = start + token.start
            yield token.text, text[:at] + text[start + token.end :]


def of_losses() -> Iterator[str]:
    for number, (lost, text) in enumerate(without_a_token(STUB)):
        yield f"## token {number}: {lost}"
        yield from told(analyse(text))


POSE = "{ translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }"
PAIRS = (
    "a via", "via j", "a via ,", "a via j b via", "a b via j", "a via j via k", "a via 5",
    "a via j.", "a² via j", "a via j²", "x via y", "j via a", "c via j", "c via k c via k",
    "c via k c via", "b via k",
)  # fmt: skip
FRAMES = (
    "", "frames {}", "frames { %s }", "frames { f %s }", "frames { f %s f %s }", "frames { g %s }",
    "frames { f { } g %s", "frames { translation = (0.0, 0.0, 0.0) }", "frames { fr_a %s }",
)  # fmt: skip


def of_broken_text() -> Iterator[str]:
    """Yield what is concluded from pairs and frames that are there in part."""
    inertia = "inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix=0.01 Iy=0.01 Iz=0.01"
    inertia += " Ixy=0.0 Ixz=0.0 Iyz=0.0 ref_frame = f }"
    joint = f"r_joint %s {{ ref_frame {POSE} }}"
    for pair in PAIRS:
        for names in ("aj", "ck"):
            link = f"link {names[0]} {{ id = 1 children {{}} }}"
            text = f"RobotBase b {{ children {{ {pair} }} }}\n{link}\n{joint % names[1]}"
            yield f"## {pair} of {names}"
            yield from told(analyse(f"Robot R {{\n{text}\n}}\n", Settings(ignore=("KD7", "KD3"))))
    for frames in FRAMES:
        section = frames.replace("%s", POSE)
        link = f"link a {{ id = 1 {inertia} children {{}} {section} }}"
        text = f"RobotBase b {{ children {{ a via j }} }}\n{link}\n{joint % 'j'}"
        yield f"## {frames}"
        yield from told(analyse(f"Robot R {{\n{text}\n}}\n", Settings(ignore=("KD506",))))


@pytest.mark.parametrize("of", [of_examples, of_documents, of_losses, of_broken_text])
def test_findings_are_as_recorded(of: Callable[[], Iterator[str]]) -> None:
    assert_as_recorded(FOLDER / f"{of.__name__}.txt", of())
