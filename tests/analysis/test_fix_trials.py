"""A fix that changes a robot is offered only if it leaves nothing worse, under every rule."""

from collections.abc import Sequence

import pytest
from tests.support.examples import four_legs, link, robot

from kindsl.frontends.features.actions.code_actions import quick_fixes
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic, Findings
from kindsl.judgement.analysis.fix_trials import offered
from kindsl.judgement.analysis.fixing import announced, fixed, is_fixable
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.language.syntax.document import SyntaxDocument, parse
from kindsl.language.text.edits import TextEdit

NEGATIVE_MOMENT = """inertia_params {
        mass = 4.1
        CoM = (0.0, 0.0, 0.12)
        Ix=0.0841 Iy=-0.0822 Iz=0.0141 Ixy=0.001 Ixz=0.002 Iyz=-0.003
    }"""
ARM = robot(link("upper", 1, "", NEGATIVE_MOMENT), base="upper via shoulder", joints="shoulder")
NO_SETTINGS = Settings()
LEGS = four_legs(RF="0.08, 0.0, 0.03")


class Misled(Analysis):
    """A document in which the first finding of a rule gets another fix than it has."""

    def __init__(
        self, syntax: SyntaxDocument, code: str, changes: dict[str, str], settings: Settings
    ) -> None:
        super().__init__(syntax, settings)
        self.of = code, changes

    @property
    def findings(self) -> Findings:
        found, (code, changes) = list(super().findings), self.of
        first = next((n for n, each in enumerate(found) if each.code == code), None)
        if first is not None and all(old in self.text for old in changes):
            places = sorted((self.text.index(old), old) for old in changes)
            edits = (TextEdit(at, at + len(old), changes[old]) for at, old in places)
            fix = TextFix("Mislead", False, tuple(edits))
            found[first] = found[first]._replace(fix=fix, choices=())
        return Findings(found, self.text)

    def edited(self, edits: Sequence[TextEdit]) -> "Misled":
        return Misled(self._written.edited(edits), *self.of, self.settings)

    def with_settings(self, settings: Settings) -> "Misled":
        return Misled(self._written, *self.of, settings)


def misled(
    text: str, code: str, changes: dict[str, str], settings: Settings = NO_SETTINGS
) -> tuple[Misled, Diagnostic]:
    analysis = Misled(parse(text), code, changes, settings)
    return analysis, next(each for each in analysis.findings if each.code == code)


CASES = {
    "heals": (ARM, "KD307", {"-0.0822": "0.0822"}, True),
    "leaves it impossible, without a cause": (ARM, "KD307", {"Iz=0.0141": "Iz=5.0141"}, False),
    "leaves its finding": (ARM, "KD307", {"Iyz=-0.003": "Iyz=-0.0031"}, False),
    "brings another fault": (ARM, "KD307", {"mass = 4.1": "mass = -4.1"}, False),
    "spoils another joint": (LEGS, "KD509", {"0.03)": "0.0)", "(-0.4, 0.2": "(-0.4, 0.3"}, False),
}


@pytest.mark.parametrize("name", CASES)
def test_a_fix_is_offered_only_if_it_stands_its_trial(name: str) -> None:
    text, code, changes, is_offered = CASES[name]
    analysis, finding = misled(text, code, changes)
    (tried,) = offered(analysis, [finding])
    assert (tried.fix is not None) is is_offered
    assert tried._replace(fix=None) == finding._replace(fix=None)


def test_no_way_offers_a_fix_that_does_not_stand_its_trial() -> None:
    analysis, finding = misled(*CASES["brings another fault"][:3])
    titles = [action.title for action in quick_fixes(analysis, finding.start, finding.end)]
    assert "Mislead" not in titles
    assert all(each.fix is None and not each.choices for each in announced(analysis))
    assert fixed(analysis, is_fixable).rounds == ()


def test_a_choice_is_tried_too() -> None:
    analysis, finding = misled(*CASES["brings another fault"][:3])
    assert finding.fix is not None
    (tried,) = offered(analysis, [finding._replace(fix=None, choices=(finding.fix,))])
    assert tried.choices == ()


def test_rules_that_the_user_leaves_out_are_tried_too() -> None:
    settings = Settings(ignore=("KD303",))
    analysis, finding = misled(*CASES["brings another fault"][:3], settings)
    assert offered(analysis, [finding])[0].fix is None


def test_fixes_of_names_are_not_tried() -> None:
    text = robot(link("upper", 1), base="uper via shoulder", joints="shoulder")
    analysis = analyse(text)
    finding = next(each for each in analysis.findings if each.code == "KD105")
    assert finding.fix is not None
    assert offered(analysis, [finding]) == [finding]


def test_findings_alone_cost_no_trial(monkeypatch: pytest.MonkeyPatch) -> None:
    analysis = analyse(ARM)

    def edited(*_: object) -> Analysis:
        raise AssertionError("a fix was tried")

    monkeypatch.setattr(Analysis, "edited", edited)
    assert any(each.fix is not None for each in analysis.findings)


def test_of_many_fixes_only_the_bad_one_goes() -> None:
    joints = [f"joint{i}" for i in range(20)]
    text = robot(
        *(link(f"upper{i}", i + 1, "", NEGATIVE_MOMENT) for i in range(20)),
        link("sound", 21),
        base=" ".join(f"upper{i} via joint{i}" for i in range(20)) + " sound via last",
        joints=" ".join([*joints, "last"]),
    )
    analysis = Misled(parse(text), "KD307", {"mass = 4.1": "mass = -4.1"}, NO_SETTINGS)
    fixes = [each for each in analysis.findings if each.fix is not None]
    assert len(fixes) == 20
    tried = [each for each in offered(analysis, analysis.findings) if each.fix is not None]
    assert tried == fixes[1:]
