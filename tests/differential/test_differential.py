"""The verdicts for both targets, and the values read, against the generators' own."""

from itertools import islice
from pathlib import Path
from typing import Any

import pytest
from tests.differential.documents import documents
from tests.differential.readings import difference
from tests.differential.references import robot_model_tools
from tests.differential.shared_cases import FILE, shared_cases
from tests.differential.verdicts import is_read
from tests.support.amount import usually
from tests.support.published import published

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.verdicts import verdicts

pytest.importorskip("robmodel", reason="robot-model-tools is not installed")
SEED = 20
AMOUNT = usually(300, 5000)
STEP = usually(10, 1)

needs_cases = pytest.mark.skipif(not FILE.is_file(), reason="../shared/differential is absent")


def test_robot_model_tools_says_the_same_of_random_documents(tmp_path: Path) -> None:
    tried = [*islice(documents(SEED), AMOUNT)]
    answers = [robot_model_tools(document.text, tmp_path).reads for document in tried]
    ours = [is_read(document.text, "robcogen2") for document in tried]
    differing = zip(tried, answers, ours, strict=True)
    assert [(d.kind, d.text) for d, theirs, reads in differing if theirs != reads] == []
    assert 0.2 < sum(answers) / AMOUNT < 0.8


@published
@needs_cases
@pytest.mark.parametrize("target", ["robcogen", "robcogen2"])
def test_the_verdicts_of_the_shared_cases(target: str) -> None:
    differing = [
        (case["kind"], case["text"])
        for case in shared_cases()[::STEP]
        if is_read(case["text"], target) != (case[target] == "accept")
    ]
    assert differing == []


@published
@needs_cases
def test_the_verdict_lines_say_the_same_whatever_the_target() -> None:
    for case in shared_cases()[:: 4 * STEP]:
        told = {verdict.target: verdict.reads for verdict in verdicts(analyse(case["text"]))}
        assert told == {t: case[t] == "accept" for t in ("robcogen", "robcogen2")}, case["text"]


@published
@needs_cases
def test_what_neither_reads_is_an_error_without_a_target_and_what_one_reads_no_syntax_error() -> (
    None
):
    for case in shared_cases()[::STEP]:
        errors = [f.code for f in analyse(case["text"]).findings if f.severity == "error"]
        if "accept" in (case["robcogen"], case["robcogen2"]):
            assert [code for code in errors if code.startswith("KD0")] == [], case["text"]
        elif case["text"].strip():
            assert errors, case["text"]


@published
@needs_cases
@pytest.mark.parametrize("target", ["robcogen", "robcogen2"])
def test_the_values_of_the_shared_cases(target: str) -> None:
    differing: list[tuple[str, Any]] = []
    cases = [case for case in shared_cases() if f"{target}_reads" in case]
    for case in cases[::STEP]:
        found = difference(case["text"], case[f"{target}_reads"], target)
        if found:
            differing.append((case["kind"], found))
    assert differing == []
    assert cases
