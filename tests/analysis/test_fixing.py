"""Whatever is fixed: no number and no comment is lost, no error is added, a second run is idle."""

import random
from collections import Counter
from collections.abc import Callable, Sequence
from decimal import Decimal
from pathlib import Path
from re import compile as pattern

import pytest
from tests.support import robots
from tests.support.kept import errors
from tests.support.models import Style, random_model
from tests.support.mutants import mutants

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.fixing import fixed, is_fixable, is_safe
from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.judgement.rules.base import Severity
from kindsl.language.syntax.document import parse
from kindsl.language.syntax.scanner import comments
from kindsl.language.text.edits import TextEdit

OBSOLETE = robots.STUB.replace(
    "Ix=0.3 Iy=0.3 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0",
    "\n        // of the drawing\n        moments = 0.3, 0.31, .1, 0.0, -0.01, 0.0",
)
DOCUMENTS = {
    "stub": robots.STUB,
    "obsolete": OBSOLETE,
    "model": random_model(3, 4, Style(layout="allman")),
    "broken": (Path(__file__).parents[2] / "examples" / "broken_arm.kindsl").read_text(),
}
NUMBER = pattern(r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
Wanted = Callable[[Diagnostic], bool]
CAUSES = ("KD306", "KD307", "KD308")


def numbers(text: str) -> Counter[Decimal]:
    return Counter(Decimal(match[0]) for match in NUMBER.finditer(text))


def remarks(text: str) -> Counter[str]:
    return Counter(text[start:end].strip() for start, end in comments(text))


def called_wrong(analysis: Analysis) -> Counter[Decimal]:
    """Return the numbers in findings; causes of an impossible inertia call all of it wrong."""
    found: Counter[Decimal] = Counter()
    for finding in analysis.findings:
        if finding.fix is not None:
            end = finding.end
            if finding.code in CAUSES:
                end = analysis.text.index("}", end)
            found += numbers(analysis.text[finding.start : end])
    return found


def assert_nothing_is_lost(text: str, is_wanted: Wanted) -> None:
    analysis = before = analyse(text)
    result = fixed(analysis, is_wanted)
    wrong: Counter[Decimal] = Counter()
    for edits in result.rounds:
        wrong += called_wrong(analysis)
        analysis = analysis.edited(edits)
    assert not numbers(text) - numbers(analysis.text) - wrong
    assert not remarks(text) - remarks(analysis.text)
    assert errors(analysis).total() <= errors(before).total()
    assert fixed(result.analysis, is_wanted).rounds == ()


@pytest.mark.parametrize("is_wanted", [is_fixable, is_safe])
@pytest.mark.parametrize("name", DOCUMENTS)
def test_fixes_of_a_mistake_lose_nothing(name: str, is_wanted: Wanted) -> None:
    found = list(mutants(DOCUMENTS[name], 17, 100))
    for mutant in random.Random(name).sample(found, 12):
        assert_nothing_is_lost(mutant.text, is_wanted)


@pytest.mark.parametrize("stray", ["}", "    }", "        }", "            }", "{", "    1.0"])
def test_fixes_of_a_stray_line_lose_nothing(stray: str) -> None:
    lines = DOCUMENTS["model"].splitlines(keepends=True)
    for count in random.Random(stray).sample(range(1, len(lines)), 12):
        text = "".join((*lines[:count], stray, "\n", *lines[count:]))
        assert_nothing_is_lost(text, is_fixable)


def test_a_brace_too_far_right_is_removed_once() -> None:
    good = random_model(3, 4)
    pair = "        segment_3 via joint_3\n"
    text = good.replace(pair, pair + "        }\n", 1)
    (finding,) = [f for f in analyse(text).findings if f.severity is Severity.ERROR]
    assert finding.message == "unexpected '}'"
    assert_nothing_is_lost(text, is_fixable)
    assert fixed(analyse(text), is_fixable).analysis.text.split() == good.split()


class Pendulum(Analysis):
    """A document whose id wants to be 1 where it is 2, and 2 where it is 1."""

    @property
    def findings(self) -> tuple[Diagnostic, ...]:
        at = self.text.index("id =") + 4
        end = self.text.index("\n", at)
        other = "  2" if "1" in self.text[at:end] else "  1"
        fix = TextFix("Swing", False, (TextEdit(end - 1, end, other),))
        return (Diagnostic("KD000", "swing", Severity.ERROR, "swing", at, end, fix=fix),)

    def edited(self, edits: Sequence[TextEdit]) -> "Pendulum":
        return Pendulum(self.syntax.edited(edits))


def test_rounds_that_undo_each_other_are_not_made() -> None:
    assert fixed(Pendulum(parse(robots.STUB)), is_fixable).rounds == ()


def test_six_moments_in_one_line_are_one_mistake() -> None:
    (finding,) = [f for f in analyse(OBSOLETE).findings if f.severity is Severity.ERROR]
    assert (finding.code, finding.message) == (
        "KD010",
        "obsolete 'moments': write 'Ix', 'Iy', 'Iz', 'Ixy', 'Ixz', 'Iyz'",
    )
    text = fixed(analyse(OBSOLETE), is_safe).analysis.text
    assert "// of the drawing\n        Ix = 0.3\n        Iy = 0.31\n        Iz = .1\n" in text
    assert "Ixy = 0.0\n        Ixz = -0.01\n        Iyz = 0.0" in text
    assert not errors(analyse(text))
