"""Every fix on whole robots, sound ones with a kind of mistake all through: what it promises.

A fix fixes its finding and brings no error. Unless it says otherwise, it keeps the mechanism to
1e-9 and all comments.
"""

import re
from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from tests.support.amount import usually
from tests.support.documents import SOUND_EXAMPLES, sound_documents
from tests.support.kept import errors, remarks
from tests.support.mechanisms import assert_same_mechanism, mechanics_by_name

from kindsl.frontends.features.actions.code_actions import fix_all
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.text.edits import apply_edits

ALL = Settings(select=("KD",))
OF_EACH = 3

# What a fix says that it changes: numbers that were rounded, inertia that no body can have.
ROUNDED = {"KD503": 1e-5}
NEW_INERTIA = {"KD306", "KD307", "KD308", "KD313", "KD509"}
# Comments that are the matter of the finding.
OTHER_COMMENTS = {"KD003", "KD602", "KD704"}


def _ids_repeated(text: str) -> str:
    return re.sub(r"\bid *= *\d+", "id = 1", text)


def _sections_exchanged(text: str) -> str:
    return re.sub(r"(mass *= *\S+)(\s+)(CoM *= *\([^)]*\))", r"\3\2\1", text)


MISTAKES = {
    "none": lambda text: text,
    "integers": lambda text: re.sub(r"\b(\d+)\.0\b", r"\1", text),
    "no-break spaces": lambda text: text.replace(" = ", "\xa0=\xa0"),
    "repeated ids": _ids_repeated,
    "exchanged entries": _sections_exchanged,
    "decimal angles": lambda text: text.replace("PI/2.0", "1.570796"),
    "block comments": lambda text: re.sub(r"//(.*)", r"/*\1 */", text),
    "useless suppressions": lambda text: "// kindsl: ignore[KD301]\n" + text,
    "two spellings": lambda text: re.sub(r"inertia_\w+", "inertia_params", text, count=1),
}


# Usually three mistakes in each document, each mistake in a third of the documents.
each_case = pytest.mark.parametrize(
    ("path", "mistake"),
    [
        pytest.param(*document.values, mistake, marks=document.marks, id=f"{document.id}-{mistake}")
        for n, document in enumerate(sound_documents())
        for k, mistake in enumerate(MISTAKES)
        if (n + k) % usually(3, thoroughly=1) == 0
    ],
)


@cache
def errors_of(path: Path) -> frozenset[str]:
    """Return the codes of the errors that a document has without a mistake."""
    return frozenset(errors(analyse(path.read_text(encoding="utf-8"), ALL)))


@each_case
def test_a_fix_does_what_it_promises(path: Path, mistake: str) -> None:
    before = analyse(MISTAKES[mistake](path.read_text(encoding="utf-8")), ALL)
    known = errors(before).keys() | errors_of(path)
    tried: Counter[str] = Counter()
    for finding in before.findings:
        tried[finding.code] += 1
        if finding.fix is not None and tried[finding.code] <= OF_EACH:
            after = before.edited(finding.fix.edits)
            assert codes(after)[finding.code] <= codes(before)[finding.code]
            told = [(f.code, f.start, f.message) for f in after.findings]
            assert (finding.code, finding.start, finding.message) not in told
            assert errors(after).keys() <= known
            assert_promised(before, after, {finding.code})


@each_case
def test_all_safe_fixes_together_do_what_they_promise(path: Path, mistake: str) -> None:
    before = analyse(MISTAKES[mistake](path.read_text(encoding="utf-8")), ALL)
    edits = fix_all(before)
    after = analyse(apply_edits(before.text, edits), ALL) if edits else before
    fixed = {finding.code for finding in before.findings if finding.fix and finding.fix.is_safe}
    assert bool(edits) == bool(fixed)
    assert_promised(before, after, fixed)
    assert fix_all(after) == ()


def assert_promised(before: Analysis, after: Analysis, fixed: set[str]) -> None:
    if not fixed & NEW_INERTIA:
        values = {str(parameter.name): 0.3 for parameter in before.model.parameters}
        tolerance = max([1e-9, *(ROUNDED[code] for code in fixed & ROUNDED.keys())])
        old, new = mechanics_by_name(before, values), mechanics_by_name(after, values)
        assert_same_mechanism(old, new, tolerance)
    if not fixed & OTHER_COMMENTS:
        assert remarks(after) == remarks(before)


def codes(analysis: Analysis) -> Counter[str]:
    return Counter(finding.code for finding in analysis.findings)


def test_the_mistakes_are_found() -> None:
    found = Counter[str]()
    for path in SOUND_EXAMPLES:
        for make in MISTAKES.values():
            found += codes(analyse(make(path.read_text(encoding="utf-8")), ALL))
    assert found.keys() >= {"KD004", "KD005", "KD007", "KD101", "KD503", "KD602", "KD702", "KD704"}
