"""The verdict of each generator, whatever is decided."""

import pytest
from tests.analysis.test_verdicts_of_targets import ARM

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.analysis.verdicts import verdicts


def told(text: str, settings: Settings | None = None) -> list[str]:
    return list(map(str, verdicts(analyse(text, settings or Settings()))))


def test_both_read_a_sound_document() -> None:
    assert told(ARM % "") == ["robcogen reads it", "robcogen2 reads it"]


@pytest.mark.parametrize("value", ["pi/2.5e1", "0.1e1*pi", "PI/2.5e1"])
def test_robcogen_refuses_an_exponent_beside_pi(value: str) -> None:
    text = (ARM % "").replace("0.1)", f"{value})", 1)
    assert value in text
    assert told(text) == ["robcogen refuses it, 1 place", "robcogen2 reads it"]


def test_no_decision_changes_a_verdict() -> None:
    text = (
        (ARM % "")
        .replace("0.1)", "1.0e-1)", 1)
        .replace("{\n", "{ // kindsl: ignore-file[KD6]\n", 1)
    )
    expected = ["robcogen refuses it, 1 place", "robcogen2 reads it"]
    assert told(text) == expected
    ignoring = Settings(frozenset(["robcogen2"]), ignore=("KD6",), severity={"KD6": "hint"})  # type: ignore[dict-item]
    assert told(text, ignoring) == expected


def test_a_joint_with_the_name_of_a_link_is_refused_by_robcogen2() -> None:
    text = (ARM % "").replace("elbow", "upper")
    assert told(text) == ["robcogen reads it", "robcogen2 refuses it, 1 place"]
    settings = Settings(frozenset(["robcogen2"]))
    assert ("KD112", "error") in [(f.code, f.severity) for f in analyse(text, settings).findings]
    harmless = (ARM % "").replace("elbow", "lower")
    assert told(harmless) == ["robcogen reads it", "robcogen2 reads it"]
