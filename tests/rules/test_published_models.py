"""Published models: known defects are found, good ones are left in peace."""

from collections import Counter
from pathlib import Path

import pytest
from tests.support.published import published, published_model, published_models

from kindsl.judgement.analysis.analysis import analyse

CLEAN = ("urdf2kindsl__03_anymal", "robcogen2__hyq")


pytestmark = published


def codes(name: str, *severities: str) -> Counter[str]:
    findings = analyse(published_model(name).read_text(encoding="utf-8")).findings
    return Counter(f.code for f in findings if f.severity in severities)


@pytest.mark.parametrize("name", CLEAN)
def test_clean_model_has_no_error_and_no_warning(name: str) -> None:
    found = codes(name, "error", "warning")
    assert set(found) <= {"KD507"}


def test_the_masses_of_the_ur5_lie_along_the_axes_of_another_format() -> None:
    assert codes("rmt__ur5", "error", "warning") == {"KD313": 2}


@pytest.mark.parametrize("path", published_models())
def test_no_published_model_has_an_error_of_syntax(path: Path) -> None:
    findings = analyse(path.read_text(encoding="utf-8")).findings
    assert [f.message for f in findings if f.code.startswith("KD0")] == []


def test_defects_of_fixed_hyq_are_found() -> None:
    assert codes("dslkin__FixedHyQ", "error") == {"KD101": 2, "KD109": 1, "KD301": 7}


def test_defect_of_inverted_pendulum_is_found() -> None:
    assert codes("ct__ct_InvertedPendulum", "error") == {"KD302": 1}


def test_parametric_model_asks_for_its_parameters() -> None:
    found = codes("hyqdesc__hyq", "error", "warning")
    assert found["KD401"] == 15
    assert not [code for code in found if code < "KD4"]
