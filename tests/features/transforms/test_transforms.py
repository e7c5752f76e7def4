"""Completion and changes in transforms documents."""

import pytest
from tests.cli.samples import arm

from kindsl.frontends.features.transforms import transforms_actions, transforms_completions
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.analysis.transforms_findings import transforms_findings
from kindsl.language.semantics.transforms import transforms_document
from kindsl.language.text.edits import apply_edits

MODEL = analyse(arm()).model
LISTED = "Robot arm\nFrames { fr_base, tip }\n"


@pytest.mark.parametrize(
    ("text", "offered"),
    [
        ("|", ["Robot"]),
        ("Robot |", ["arm"]),
        ("Robot arm\n|", ["Frames", "Transforms", "Jacobians"]),
        ("Robot arm\nFrames { |", ["fr_base", "fr_upper", "fr_lower", "tip"]),
        ("Robot arm\nFrames { fr_base, |", ["fr_upper", "fr_lower", "tip"]),
        ("Robot arm\nFrames { fr_base, low|", ["fr_lower"]),
        ("Robot arm\nFrames { tip|", []),
        (f"{LISTED}Transforms {{ |", ["fr_base", "tip", "base, target"]),
        (f"{LISTED}Transforms {{ tip |", ["<-", "->"]),
        (f"{LISTED}Transforms {{ tip -|", ["<-", "->"]),
        (f"{LISTED}Transforms {{ tip <|", ["<-"]),
        (f"{LISTED}Transforms {{ tip ->|", []),
        (f"{LISTED}Transforms {{ tip <- |", ["fr_base", "tip"]),
        (f"{LISTED}Transforms {{ tip -> fr|", ["fr_base"]),
        (f"{LISTED}Transforms {{ base=|", ["fr_base", "tip"]),
        (f"{LISTED}Transforms {{ base=tip, |", ["target"]),
        (f"{LISTED}Transforms {{ base=tip, target=|\n}}", ["fr_base", "tip"]),
        (f"{LISTED}Jacobians {{ }} |", ["Transforms"]),
        ("Robot arm ; Frames { |", ["fr_base", "fr_upper", "fr_lower", "tip"]),
    ],
)
def test_what_may_be_typed(text: str, offered: list[str]) -> None:
    offset = text.index("|")
    found = transforms_completions(text.replace("|", ""), offset, MODEL)
    assert [item.label for item in found.items] == offered


@pytest.mark.parametrize("floating", [False, True])
def test_the_written_document_has_no_findings(floating: bool) -> None:
    model = analyse(arm(floating=floating)).model
    (action,) = transforms_actions("\n", model, 0, 0)
    text = apply_edits("\n", action.edits)
    assert text == transforms_document(model)
    assert transforms_findings(text, model, Settings()) == ()
    assert all(f"target={name}" in text for name in ("fr_upper", "fr_lower", "tip"))


@pytest.mark.parametrize(
    ("text", "title", "code"),
    [
        (LISTED.replace("tip", "tipp"), "Replace 'tipp' with 'tip'", "KD801"),
        (f"{LISTED}Transforms {{ base=tip, target=fr_lower }}", "List 'fr_lower' under", "KD802"),
        ("Robot arm\nTransforms { base=tip, target=tip }", "List 'tip' under 'Frames'", "KD802"),
    ],
)
def test_a_fix_mends_its_finding(text: str, title: str, code: str) -> None:
    found = [f for f in transforms_findings(text, MODEL, Settings()) if f.code == code]
    offered = transforms_actions(text, MODEL, found[-1].start, found[-1].start)
    (fix,) = [each for each in offered if each.title.startswith(title)]
    after = transforms_findings(apply_edits(text, fix.edits), MODEL, Settings())
    assert [f.code for f in after] == []


def test_all_frames_are_listed() -> None:
    (action,) = transforms_actions(LISTED, MODEL, 0, 0)
    text = apply_edits(LISTED, action.edits)
    assert "{ fr_base, tip, fr_upper, fr_lower }" in text
    assert transforms_actions(text, MODEL, 0, 0) == []
