"""Robots typed into VS Code's editor core: Enter breaks the line, Tab goes through what it took."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page
from tests.support.amount import usually
from tests.typist.monaco import QUICK_FRAMES, editor, put, settled, type_keys
from tests.typist.typist import Hand, lines_to_type, type_document
from tests.vscode.browser import chromium

from kindsl.frontends.features.completion.item import without_placeholders
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.formatting import format_document
from kindsl.language.text.edits import apply_edits

# The first test waits for what is installed for all of them.
pytestmark = pytest.mark.timeout(900)
EXAMPLES = Path(__file__).parents[2] / "examples"
QUICK = Hand(0.0, 0.0, hurries_repetitions=True)
ROBOT = "Robot R {\n    $0\n}"
BASE = ROBOT.replace(
    "    $0", "RobotBase base {\n    children {\n        arm via j\n    }\n}\n    $0"
)
LINK = BASE.replace("    $0", "link arm {\n    id = 1\n    $0\n}")
INERTIA = LINK.replace("$0", "inertia_params {\n        $0\n    }")
JOINTS = LINK.replace("$0", "children {}").replace("\n}\n}", "\n}\n    $0\n}")
JOINT = JOINTS.replace("    $0", "r_joint j {\n    $0\n}")
PLACES = {
    "document": "$0",
    "robot": ROBOT,
    "base": BASE,
    "link": LINK,
    "children": LINK.replace("$0", "children {\n        $0\n    }"),
    "inertia": INERTIA,
    "moments": INERTIA.replace("$0", "mass = 1.0\n        CoM = (0.0, 0.0, 0.0)\n        $0"),
    "frames": LINK.replace("$0", "children {}\n    frames {\n        $0\n    }"),
    "joints": JOINTS,
    "joint": JOINT,
    "pose": JOINT.replace("$0", "ref_frame {\n        $0\n    }"),
}


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium(*QUICK_FRAMES) as running:
        yield running


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    with editor(browser, quickSuggestionsDelay=0) as page:
        yield page


@pytest.fixture(scope="module")
def known() -> set[str]:
    """What kinds of lines were typed before, by the one hand that types all examples."""
    return set()


# The quadruped has nearly as many lines as the others together, and few of another shape.
@pytest.mark.parametrize(
    "name", ["broken_arm", "fancy", "industrial_arm", *usually([], ["quadruped"])]
)
def test_enter_breaks_the_line_and_indents_as_the_formatter_does(
    page: Page, name: str, known: set[str]
) -> None:
    put(page, "")
    lines = lines_to_type((EXAMPLES / f"{name}.kindsl").read_text())
    assert not type_document(page, lines, QUICK, known)
    text = settled(page).text
    assert text.split() == " ".join(lines).split()
    syntax = analyse(text).syntax
    if not any(island.problems for island in syntax.islands):
        formatted = apply_edits(text, format_document(syntax))
        assert _without_empty_lines(text) == _without_empty_lines(formatted)


@pytest.mark.parametrize("place", PLACES)
def test_tab_accepts_what_is_chosen_and_goes_through_it(page: Page, place: str) -> None:
    text = PLACES[place]
    _ask(page, text)
    labels = settled(page).labels
    assert labels
    for index, label in enumerate(labels):
        _ask(page, text)
        for _ in range(index):
            page.keyboard.press("ArrowDown")
        assert settled(page).chosen == label
        page.keyboard.press("Tab")
        _check_accepted(page, label)


def test_nothing_opens_behind_a_name_that_is_new(page: Page) -> None:
    put(page, "Robot R {\n", 10)
    type_keys(page, "RobotBase base", 0.0)
    assert not settled(page).labels
    page.keyboard.press("Tab")
    assert settled(page).text.split() == ["Robot", "R", "{", "RobotBase", "base"]


def _ask(page: Page, marked: str) -> None:
    put(page, marked.replace("$0", ""), marked.index("$0"))
    page.keyboard.press("Control+Space")
    settled(page)


def _check_accepted(page: Page, label: str) -> None:
    """Check that what was accepted stands in the formatter's style, and that Tab leaves it."""
    text = settled(page).text
    assert "\t" not in text and not re.search(r"^ +(Robot|link|r_joint|p_joint)\b", text, re.M), (
        label
    )
    for _ in range(40):
        if not page.evaluate("typist.isInSnippet()"):
            break
        page.keyboard.press("Tab")
    after = settled(page)
    assert after.text == text, label
    assert after.labels == (), label
    assert without_placeholders(after.text) == after.text


def _without_empty_lines(text: str) -> list[str]:
    return [line.rstrip() for line in text.splitlines() if line.strip()]
