"""Characters that look alike are read as what they mean, and fixed to the same value."""

import random

import pytest
from tests.support import robots
from tests.support.amount import usually
from tests.support.lookalikes import alike, number_spans
from tests.support.models import LAYOUTS, Style, random_model
from tests.support.syntax_checks import assert_lossless, assert_same

from kindsl.frontends.cli.documents.sources import is_decodable
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.fixing import fixed, is_safe
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.analysis.verdicts import verdicts
from kindsl.language.semantics.declarations import Declarations
from kindsl.language.semantics.expressions import Expression, symbols
from kindsl.language.semantics.lowering import declarations
from kindsl.language.syntax.document import parse
from kindsl.language.syntax.scanner import comments
from kindsl.language.text.edits import TextEdit, apply_edits

BOTH = Settings(targets=frozenset({"robcogen", "robcogen2"}))


def values(analysis: Analysis) -> list[float | None]:
    """Return all numbers of a document in its order, with parameters at some value."""
    found: list[float | None] = []
    for island in analysis.syntax.islands:
        for expression in expressions(declarations(island)):
            bindings = {str(symbol.name): 0.7 for symbol in symbols(expression)}
            found.append(expression.value(bindings))
        found += [link.id for link in declarations(island).links]
    return found


def expressions(declared: Declarations) -> list[Expression]:
    found: list[Expression] = []
    for link in (*declared.bases, *declared.links):
        if link.inertia is not None:
            found += [link.inertia.mass] if link.inertia.mass else []
            found += link.inertia.com.components if link.inertia.com else ()
            found += link.inertia.moments.values()
        for frame in link.frames:
            found += [c for vector in frame.pose if vector for c in vector.components]
    for joint in declared.joints:
        found += [c for vector in joint.pose if vector for c in vector.components]
    return found


def syntax_codes(analysis: Analysis) -> list[str]:
    return [finding.code for finding in analysis.findings if finding.code.startswith("KD0")]


def refused(text: str) -> list[str]:
    """Return what one of the generators refuses."""
    return [f.message for f in analyse(text, BOTH).findings if f.code.startswith("KD60")]


def remarks(text: str) -> list[str]:
    return [text[start:end] for start, end in comments(text)]


def disguised(text: str, generator: random.Random) -> tuple[str, list[TextEdit]]:
    spans = number_spans(text)
    chosen = generator.sample(spans, generator.randint(1, min(12, len(spans))))
    edits = [TextEdit(start, end, alike(text[start:end], generator)) for start, end in chosen]
    return apply_edits(text, edits), edits


def sound(seed: int) -> str:
    text = random_model(1 + seed % 5, seed, Style(layout=LAYOUTS[seed % 3]))
    return text.replace("\n", "\r\n") if seed % 7 == 0 else text


@pytest.mark.parametrize("seed", range(usually(60, 1500)))
def test_lookalikes_are_read_as_what_they_mean(seed: int) -> None:
    generator = random.Random(seed)
    text = sound(seed)
    good = analyse(text)
    assert syntax_codes(good) == []
    other, edits = disguised(text, generator)
    analysis = analyse(other)
    assert values(analysis) == values(good)
    assert len(syntax_codes(analysis)) == len(edits)
    assert remarks(other) == remarks(text)
    repaired = fixed(analysis, is_safe).analysis
    assert values(repaired) == values(good)
    assert syntax_codes(repaired) == []
    assert remarks(repaired.text) == remarks(text)
    assert refused(repaired.text) == refused(text)
    edited = parse(text)
    for edit in sorted(edits, reverse=True):
        edited = edited.edited([edit])
    assert_same(edited, parse(other))
    assert_lossless(edited, other)


MASS = "mass = {} CoM = (0.0, 0.0, 0.1)"
CERTAIN = {
    "−1.0": (-1.0, "-1.0"),
    "– 1.0": (-1.0, "-1.0"),
    "－１．０": (-1.0, "-1.0"),
    "−1": (-1.0, "-1.0"),
    "−PI/2.0": (-1.5707963267948966, "-PI/2.0"),
    "2.0·3.0": (6.0, "2.0*3.0"),
    "2.0 × 3.0": (6.0, "2.0 * 3.0"),
    "1·5": (1.5, "1.5"),
    "١٫٥": (1.5, "1.5"),
    "१.५": (1.5, "1.5"),
    "𝟏.𝟓": (1.5, "1.5"),
    "1.0×10⁻³": (0.001, "0.001"),
    "1.25·10^-3": (0.00125, "0.00125"),
    "2·10^-3": (0.002, "0.002"),
    "2·10⁻³": (0.002, "0.002"),
    "2 · 10**-3": (0.002, "0.002"),
    "1.0 x 10-3": (0.001, "0.001"),
    "1.0 × 10−3": (0.001, "0.001"),
    "12.5*10**2": (1250.0, "1250.0"),
    "1.0e−3": (0.001, "0.001"),
    "10⁻³": (0.001, "0.001"),
    "\u200e−1.0": (-1.0, "-1.0"),
    "-\u20601.0": (-1.0, "-1.0"),
    "1.0\xa0/\xa02.0": (0.5, "1.0 / 2.0"),
    "PI∕２.０": (1.5707963267948966, "PI/2.0"),
}  # fmt: skip


@pytest.mark.parametrize("written", CERTAIN)
def test_one_meaning_is_read_and_written(written: str) -> None:
    value, new = CERTAIN[written]
    text = robots.STUB.replace("mass = 1.0 CoM = (0.0, 0.0, 0.1)", MASS.format(written), 1)
    analysis = analyse(text)
    assert values(analysis)[0] == value
    assert len(syntax_codes(analysis)) == 1
    repaired = fixed(analysis, is_safe).analysis
    assert MASS.format(new) in repaired.text
    assert values(repaired)[0] == value


UNCERTAIN = {
    "1 234.5": ["1234.5"],
    "1\xa0234.5": ["1234.5"],
    "1\u202f234\u202f567.8": ["1234567.8"],
    "0.123\u2009456": ["0.123456"],
    "1'000.0": ["1000.0"],
    "1’000.0": ["1000.0"],
    "1,234": ["1.234", "1234.0"],
    "1,5": ["1.5"],
    "1,234.5": ["1234.5"],
    "1.234,5": ["1234.5"],
    "1٬234.5": ["1234.5"],
    "1\u200b0.5": ["10.5"],
    "1\xad0.5": ["10.5"],
    "\xad1.0": [],
    "\udc961.0": [],
    "\x961.0": [],
    "1\udca0000.0": [],
    "1§0.0": [],
    "⁻1.0": [],
    "1.0§": [],
    "1.0×103": [],
    "2,0×10⁻³": [],
    "2,5 x 10-3": [],
}


@pytest.mark.parametrize("written", UNCERTAIN)
def test_what_is_uncertain_has_no_value_and_no_safe_fix(written: str) -> None:
    text = robots.STUB.replace("mass = 1.0 CoM = (0.0, 0.0, 0.1)", MASS.format(written), 1)
    analysis = analyse(text)
    assert values(analysis)[0] is None
    (finding,) = [f for f in analysis.findings if f.code.startswith("KD0")]
    assert finding.code == ("KD005" if is_decodable(written) else "KD004")
    fixes = [finding.fix] if finding.fix else finding.choices
    assert [edit.text for fix in fixes for edit in fix.edits] == UNCERTAIN[written]
    assert not any(fix.is_safe for fix in fixes)
    assert fixed(analysis, is_safe).analysis.text == text


@pytest.mark.parametrize(
    ("written", "read", "is_certain"),
    [
        ("ﬁnger", "finger", True),
        ("up\xadper", "upper", True),
        ("up\u200bper", "upper", True),
        ("cafe\u0301", "café", True),
        ("upper–arm", "upper_arm", False),
        ("größe", "größe", None),
        ("ａ", "ａ", None),
        ("モーター", "モーター", None),
    ],
)
def test_names(written: str, read: str, is_certain: bool | None) -> None:
    analysis = analyse(robots.STUB.replace("upper", written))
    assert [link.name for link in analysis.model.links] == [read]
    found = [f for f in analysis.findings if f.code.startswith("KD")]
    if is_certain is None:
        assert syntax_codes(analysis) == []
    else:
        # A ligature is a letter for robcogen2, which is why it is no error without a target.
        assert set(syntax_codes(analysis)) == {"KD004"}
        assert {f.fix.is_safe for f in found if f.fix} == {is_certain}


def test_blanks_quotes_and_brackets() -> None:
    text = robots.STUB.replace(
        "translation = (0.0, 0.1, 0.3)", "translation＝（0.0，−0.1，\xa00.3）"
    )
    analysis = analyse(text)
    assert values(analysis)[-6:-3] == [0.0, -0.1, 0.3]
    repaired = fixed(analysis, is_safe).analysis
    assert "translation=(0.0,-0.1, 0.3)" in repaired.text
    assert syntax_codes(repaired) == []


def test_comments_stay_as_they_are() -> None:
    comment = "// −1.0 × 10⁻³ “ﬁnger” \xa0 １．０ up–per"
    text = robots.STUB.replace("{ }", f"{{ {comment}\n }}").replace("mass = 1.0", "mass = １.０")
    repaired = fixed(analyse(text), is_safe).analysis
    assert remarks(repaired.text) == [comment]
    assert "mass = 1.0" in repaired.text


@pytest.mark.parametrize("written", ["٣.٥", "PI/٣.٥", "-٣.٥"])
def test_robcogen2_reads_digits_of_another_script(written: str) -> None:
    text = robots.STUB.replace("Ixy=0.0", f"Ixy={written}", 1)
    severities = {
        target: [f.severity for f in analyse(text, Settings(targets=targets)).findings]
        for target, targets in {
            "both": frozenset({"robcogen", "robcogen2"}),
            "robcogen2": frozenset({"robcogen2"}),
        }.items()
    }
    assert "error" in severities["both"]
    assert "error" not in severities["robcogen2"]


def test_robcogen2_divides_by_no_zero_beside_such_digits() -> None:
    text = robots.STUB.replace("Ixy=0.0", "Ixy=٣.٥", 1)
    text = text.replace("Ix=0.3", "Ix=1.0/0.0")
    (verdict,) = (v for v in verdicts(analyse(text)) if v.target == "robcogen2")
    assert not verdict.reads
