"""What a round of fixes must not do, and which fixes are therefore never made."""

from collections import Counter
from collections.abc import Sequence

import pytest
from tests.support import robots
from tests.support.examples import joint, link, robot
from tests.support.kept import errors

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.fixing import Fixed, announced, fixed, is_fixable, is_safe, made
from kindsl.judgement.analysis.proof import effect
from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.judgement.rules.base import Severity
from kindsl.language.syntax.document import parse
from kindsl.language.text.edits import TextEdit

ARM = robots.ARM
COPIED = link("upper", 1).replace(
    "children", "inertia_params { mass = 2.0 CoM = (0.0, 0.0, 0.0) }\n    children"
)
OPEN = link("upper", 1).replace("children", "/* of the tool id\n    children")


def fix(text: str, old: str, new: str, *, safe: bool = True) -> Diagnostic:
    """Return a finding whose fix replaces the first place of a text."""
    at = text.index(old)
    edit = TextEdit(at, at + len(old), new)
    proposed = TextFix("Fix", safe, (edit,), False, parse(text))
    return Diagnostic("KD500", "x", Severity.HINT, "is odd", edit.start, edit.end, fix=proposed)


def made_of(text: str, *findings: Diagnostic) -> Fixed | None:
    return made(analyse(text), findings)


def test_words_that_nothing_reads_are_not_removed_unasked() -> None:
    text = link("upper", 1).replace("children", "gearing of hook children")
    assert not effect(parse(text), parse(text.replace("gearing", ""))).is_kept
    as_remark = text.replace("gearing of hook", "// gearing of hook\n")
    assert effect(parse(text), parse(as_remark)).is_kept


def test_safe_fixes_must_keep_all_together() -> None:
    """A product with two zeros stays zero if one of them changes, not if both do."""
    text = joint("elbow", rotation="0.00*0.000, 0.0, 0.0")
    one, other = fix(text, "0.00", "1.0"), fix(text, "0.000", "1.0")
    assert is_safe(one)
    assert is_safe(other)
    done = made_of(text, one, other)
    assert done is not None
    assert done.n_findings == 1
    assert "(1.0*0.000, " in done.analysis.text


def test_errors_never_grow() -> None:
    text = ARM
    before = errors(analyse(text))
    harm = fix(text, "link upper", "link upper_", safe=False)
    assert made_of(text, harm) is None
    spoilt = text.replace("link upper", "link upper_")
    assert errors(analyse(spoilt)).total() > before.total()


def numbered_from_four() -> str:
    links = link("upper", 4, "lower via elbow"), link("lower", 5)
    base = "upper via shoulder hand via wrist"
    return robot(*links, base=base, joints="shoulder elbow wrist")


def test_fixes_of_meaning_bring_no_other_kind_of_error_together() -> None:
    """The number that a new link gets is the one that the renumbering gives to another."""
    analysis = analyse(numbered_from_four())
    assert set(errors(analysis)) == {"KD105", "KD109"}
    edits = [finding.fix.edits for finding in analysis.findings if finding.fix is not None]
    together = analysis.edited(sorted(edit for each in edits for edit in each))
    assert errors(together) == Counter(KD101=1)
    result = fixed(analysis, is_fixable)
    for edits_made in result.rounds:
        analysis = analysis.edited(edits_made)
        assert "KD101" not in errors(analysis)
    assert not errors(result.analysis)
    assert sorted(each.id or 0 for each in result.analysis.model.links) == [1, 2, 3]


def test_a_text_is_read_before_it_is_judged() -> None:
    text = numbered_from_four().replace("0.3)", "7)", 1)
    first, *rest = fixed(analyse(text), is_fixable).rounds
    at = text.index("7)") + 1
    assert first == (TextEdit(at, at, ".0"),)
    assert rest


@pytest.mark.parametrize("text", [COPIED, OPEN])
def test_what_is_never_made_is_only_a_choice(text: str) -> None:
    (known,) = [f for f in analyse(text).findings if f.fix is not None]
    assert known.fix is not None
    assert known.code in {"KD003", "KD009"}
    (told,) = [f for f in announced(analyse(text)) if f.code == known.code]
    assert told == known._replace(fix=None, choices=(known.fix,))


class Given(Analysis):
    """A document with findings of its own."""

    given: Sequence[Diagnostic] = ()

    @property
    def findings(self) -> tuple[Diagnostic, ...]:  # type: ignore[override]
        return tuple(self.given) or analyse(self.text).findings


def test_a_fix_that_uncovers_errors_is_told_as_a_choice_whatever_is_beside_it() -> None:
    text = ARM
    harm = fix(text, "link upper", "link upper_", safe=False)
    good = fix(text, "0.0", "0.00")
    analysis = Given(parse(text))
    analysis.given = (good, harm, good)
    assert [f.fix is None for f in announced(analysis)] == [False, True, False]


def test_what_is_announced_is_what_is_made() -> None:
    analysis = analyse(numbered_from_four().replace("0.3)", "0)"))
    assert announced(analysis) == tuple(analysis.findings)
