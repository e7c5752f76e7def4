"""What the server says of a text that is no longer the one that is shown."""

from typing import Any

import pytest
from tests.vscode import models
from tests.web.tab import PLACE_CURSOR, Tab

pytestmark = pytest.mark.timeout(900)
HEAVY = models.ARM.replace("mass = 2.0", "mass = 2.5")
LOWER = models.ARM.partition("link lower")[0].count("\n") + 1
LINE = "playground.editor.getPosition().lineNumber"
# In one go each, so that no message comes between: an edit that pushes all lines down by three,
# what was held back, and what a person does.
STEPS = """async (steps) => {
    const { monaco, files, editor } = playground;
    const top = new monaco.Range(1, 1, 1, 1);
    const known = {
        edit: () => files.model().applyEdits([{ range: top, text: "\\n\\n\\n" }]),
        pass: () => late.pass(),
        settle: () => new Promise((resolve) => setTimeout(resolve)),
    };
    for (const [step, value] of steps) {
        if (step === "show") files.show(value);
        else if (step === "open") files.open(...value);
        else if (step === "click") document.querySelector(value).click();
        else await known[step]();
    }
    return {
        line: editor.getPosition()?.lineNumber,
        tree: document.querySelectorAll("#outline button").length,
        problems: document.querySelectorAll("#problems .place").length,
    };
}"""


def at_once(tab: Tab, *steps: str | tuple[str, Any]) -> dict[str, int]:
    """Do steps before any message can come; return the cursor's line and what is listed."""
    named = [(step, None) if isinstance(step, str) else step for step in steps]
    seen: dict[str, int] = tab.page.evaluate(STEPS, named)
    return seen


def show_and_wait(tab: Tab, name: str, text: str) -> None:
    """Show a text and wait for its tree."""
    tab.show(name, text)
    tab.page.locator("#outline button", has_text="lower").first.wait_for()


def test_the_tree_of_another_text_is_gone_at_once(tab: Tab) -> None:
    show_and_wait(tab, "heavy.kindsl", HEAVY)
    tab.open_beside("arm.kindsl", models.ARM)
    assert at_once(tab, ("show", "arm.kindsl"))["tree"] == 0
    show_and_wait(tab, "arm.kindsl", models.ARM)
    assert at_once(tab, ("open", ["arm.kindsl", HEAVY]))["tree"] == 0


def test_the_tree_of_an_earlier_version_is_not_listed(tab: Tab) -> None:
    tab.open_beside("arm.kindsl", models.ARM)
    tab.show("heavy.kindsl", HEAVY)
    with tab.held("textDocument/documentSymbol"):
        tab.page.evaluate("() => playground.files.show('arm.kindsl')")
        tab.wait_for_held()
        assert at_once(tab, "edit", "pass", "settle")["tree"] == 0
    tab.page.locator("#outline button", has_text="lower").first.click()
    assert tab.page.evaluate(LINE) == LOWER + 3


def test_a_place_in_the_tree_moves_with_the_text(tab: Tab) -> None:
    show_and_wait(tab, "arm.kindsl", models.ARM)
    tab.page.evaluate(PLACE_CURSOR, [20, 1])
    assert at_once(tab, "edit", ("click", "#outline button"))["line"] == 4


def test_a_listed_problem_moves_with_the_text(tab: Tab) -> None:
    tab.show("arm.kindsl", models.BROKEN)
    first = tab.eventually(tab.found, "the problems")[0]
    tab.page.locator("#problems .place").first.wait_for()
    assert at_once(tab, ("click", "#problems .place"))["line"] == first[1]
    assert at_once(tab, "edit", ("click", "#problems .place"))["line"] == first[1] + 3


def test_findings_of_an_earlier_version_are_not_shown(tab: Tab) -> None:
    with tab.held("textDocument/publishDiagnostics"):
        tab.show("arm.kindsl", models.BROKEN)
        tab.wait_for_held()
        assert at_once(tab, "edit", "pass", "settle")["problems"] == 0
    tab.eventually(tab.found, "the problems of the new version")


def test_findings_of_a_text_that_was_replaced_are_not_shown(tab: Tab) -> None:
    with tab.held("textDocument/publishDiagnostics"):
        tab.show("arm.kindsl", models.BROKEN)
        tab.wait_for_held()
        steps = ("open", ["arm.kindsl", models.ARM]), ("show", "arm.kindsl"), "pass", "settle"
        assert at_once(tab, *steps)["problems"] == 0
    tab.show("arm.kindsl", models.BROKEN)
    tab.eventually(tab.found, "the problems")
    steps = ("open", ["arm.kindsl", models.ARM]), ("show", "arm.kindsl"), "settle"
    assert at_once(tab, *steps)["problems"] == 0


def test_an_answer_about_a_closed_text_is_no_complaint(tab: Tab) -> None:
    complaints = len(tab.complaints)
    with tab.held("textDocument/inlayHint"):
        tab.show("other.kindsl", models.ARM)
        tab.wait_for_held()
        tab.page.get_by_title("Close other.kindsl").click()
        at_once(tab, "pass", "settle")
    tab.show("arm.kindsl", models.ARM)
    tab.expect_robot("arm")
    assert tab.complaints[complaints:] == []


def test_a_comparison_shows_no_changes_of_others(tab: Tab) -> None:
    tab.open_beside("heavier.kindsl", HEAVY)
    tab.show("arm.kindsl", models.ARM)
    tab.page.locator("#do-compare").click()
    tab.page.locator("#old-side").select_option("heavier.kindsl")
    changes = tab.page.locator("#changes")
    tab.eventually(lambda: "mass 2.5 -> 2 kg" in changes.inner_text(), "the lighter link")
    with tab.held("kindsl.difference"):
        tab.page.locator("#old-side").select_option("arm.kindsl")
        assert changes.inner_text() == ""
    tab.eventually(lambda: changes.inner_text() == "Nothing changed mechanically", "no change")
    tab.page.locator("#end-comparison").click()


def test_a_picture_that_nobody_waits_for_is_no_complaint(tab: Tab) -> None:
    tab.open_beside("kindsl.toml", "")
    with tab.held("kindsl.preview"):
        tab.page.evaluate("() => { window.shown = playground.preview.show('kindsl.toml'); }")
        tab.show("arm.kindsl", models.ARM)
        tab.wait_for_held()
    tab.page.evaluate("() => window.shown")
    tab.expect_robot("arm")


def test_an_example_that_comes_twice_replaces_no_work(tab: Tab) -> None:
    tab.page.evaluate("""async () => {
        const { fetch } = window, waiting = [];
        window.fetch = (...asked) => new Promise((go) => waiting.push(() => go(fetch(...asked))));
        const examples = document.getElementById("examples");
        for (const _ of "12") {
            examples.value = "fancy";
            examples.dispatchEvent(new Event("change"));
        }
        window.fetch = fetch;
        window.comes = () => waiting.shift()();
    }""")
    active = "() => playground.files.active"
    tab.page.evaluate("() => comes()")
    tab.eventually(lambda: tab.page.evaluate(active) == "fancy.kindsl", "the example")
    tab.page.evaluate("() => playground.files.model().setValue('mine')")
    tab.show("arm.kindsl", models.ARM)
    tab.page.evaluate("() => comes()")
    tab.eventually(lambda: tab.page.evaluate(active) == "fancy.kindsl", "the example again")
    assert tab.text() == "mine"
