"""Whatever is fixed in whatever text: `--fix` keeps numbers and remarks, none adds an error.

`--unsafe-fixes` keeps remarks and blocks. The texts are random robots with random mistakes, and
documents on which both generators were asked, texts of others beside the project.
"""

import gzip
import json
import random
from pathlib import Path

import pytest
from tests.support.amount import usually
from tests.support.kept import changed_numbers, errors, lost_blocks, lost_remarks
from tests.support.spoilt import spoilt_robot

from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.fixing import fixed, is_fixable, is_safe
from kindsl.judgement.analysis.settings import Settings

CASES = Path(__file__).parents[3] / "shared" / "differential" / "cases.jsonl.gz"
SETTINGS = (Settings(), Settings(select=("KD",)))
PARTS = 20


def assert_kept(text: str, settings: Settings) -> None:
    before = analyse(text, settings)
    safe, all_made = fixed(before, is_safe), fixed(before, is_fixable)
    assert changed_numbers(before, safe.analysis) == []
    for result in (safe, all_made):
        assert_no_harm(before, result.analysis)


def assert_no_harm(before: Analysis, after: Analysis) -> None:
    assert lost_remarks(before.text, after.text) == []
    assert lost_blocks(before, after) == []
    assert errors(after).total() <= errors(before).total()


@pytest.mark.parametrize("part", range(PARTS))
def test_fixes_of_random_mistakes_keep_what_is_there(part: int) -> None:
    generator = random.Random(f"spoilt {part}")
    for number in range(usually(5, thoroughly=370)):
        assert_kept(spoilt_robot(generator), SETTINGS[number % 2])


@pytest.mark.published
@pytest.mark.parametrize("part", range(PARTS))
def test_fixes_of_documents_that_were_asked_about_keep_what_is_there(part: int) -> None:
    if not CASES.exists():
        pytest.skip("the documents that the generators were asked about are not beside the project")
    with gzip.open(CASES, "rt", encoding="utf-8") as lines:
        texts = [json.loads(line)["text"] for line in lines]
    for text in texts[part :: PARTS * usually(30, thoroughly=1)]:
        assert_kept(text, SETTINGS[part % 2])
