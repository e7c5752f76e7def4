"""Published models: known defects are found, good ones are left in peace."""

from collections import Counter
from pathlib import Path

import pytest

from kindsl.analysis.analysis import analyse
from kindsl.analysis.diagnostics import Diagnostic
from kindsl.analysis.settings import Settings

SHARED = Path(__file__).parents[3] / "shared"
CORPUS = SHARED / "corpus"
CONFORMANCE = SHARED / "conformance"
CLEAN = ("rmt__ur5", "urdf2kindsl__03_anymal", "robcogen2__hyq")

needs_corpus = pytest.mark.skipif(not CORPUS.is_dir(), reason="the published models are not here")
needs_cases = pytest.mark.skipif(not CONFORMANCE.is_dir(), reason="the cases are not here")


def findings_in(name: str) -> list[Diagnostic]:
    (path,) = CORPUS.glob(f"{name}*.kindsl")
    return list(analyse(path.read_text(encoding="utf-8")).findings)


def codes(name: str, *severities: str) -> Counter[str]:
    return Counter(f.code for f in findings_in(name) if f.severity in severities)


@needs_corpus
@pytest.mark.parametrize("name", CLEAN)
def test_clean_model_has_no_error_and_no_warning(name: str) -> None:
    found = codes(name, "error", "warning")
    assert set(found) <= {"KD507"}


@needs_corpus
def test_no_published_model_has_an_error_of_syntax() -> None:
    for path in sorted(CORPUS.glob("*.kindsl")):
        found = [f.message for f in findings_in(path.stem) if f.code.startswith("KD0")]
        assert found == [], path.stem


@needs_corpus
def test_defects_of_fixed_hyq_are_found() -> None:
    assert codes("dslkin__FixedHyQ", "error") == {"KD101": 2, "KD109": 1, "KD301": 7}


@needs_corpus
def test_defect_of_inverted_pendulum_is_found() -> None:
    assert codes("ct__ct_InvertedPendulum", "error") == {"KD302": 1}


@needs_corpus
def test_parametric_model_asks_for_its_parameters() -> None:
    found = codes("hyqdesc__hyq", "error", "warning")
    assert found["KD401"] == 15
    assert not [code for code in found if code < "KD4"]


def verdicts() -> list[dict[str, str]]:
    table = CONFORMANCE / "verdicts.tsv"
    if not table.is_file():
        return []
    lines = table.read_text(encoding="utf-8").splitlines()
    columns = lines[0].split("\t")
    rows = (dict(zip(columns, line.split("\t"), strict=False)) for line in lines[1:])
    return list(rows)


def accepted() -> list[object]:
    rows = (row for row in verdicts() if "accept" in (row["A"], row["B"]))
    return [pytest.param(row["name"], id=row["name"]) for row in rows]


def text_of(name: str) -> str:
    path = CONFORMANCE / "cases" / f"{name}.kindsl"
    return path.read_bytes().decode("utf-8", "surrogateescape")


@needs_cases
@pytest.mark.parametrize("name", accepted())
def test_what_a_generator_accepts_has_no_error_of_syntax(name: str) -> None:
    found = analyse(text_of(name)).findings
    assert [f.message for f in found if f.code.startswith("KD0")] == []


LOADING = ("KD0", "KD105", "KD106", "KD107", "KD108", "KD6")


@needs_cases
@pytest.mark.parametrize(("target", "column"), [("robcogen", "A"), ("robcogen2", "B")])
def test_with_a_target_named_its_verdict_is_ours(target: str, column: str) -> None:
    settings = Settings(targets=frozenset([target]))
    differing = []
    for row in verdicts():
        found = analyse(text_of(row["name"]), settings).findings
        errors = [f for f in found if f.severity == "error" and f.code.startswith(LOADING)]
        if bool(errors) != (row[column] == "reject"):
            differing.append(row["name"])
    assert differing == []
