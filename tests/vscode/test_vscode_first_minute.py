"""What somebody meets first: a robot that moves, and an Enter that breaks the line."""

from playwright.sync_api import Locator, expect
from tests.vscode import models
from tests.vscode.workbench import PATIENCE, Workbench


def test_the_walkthrough_begins_with_a_robot_that_moves(workbench: Workbench) -> None:
    steps = workbench.page.locator(".getting-started-step")
    open_walkthrough(workbench, steps)
    workbench.eventually(lambda: steps.count() == 3, "the steps")
    first, done = steps.first, workbench.page.locator(".getting-started-step .complete:visible")
    expect(first).to_contain_text("See a robot move")
    workbench.screenshot("walkthrough")
    preview = workbench.page.locator(".tab", has_text="Preview ")
    workbench.click_until(first.locator(".monaco-button"), preview)
    frame = workbench.preview_frame()
    frame.wait_for_function("() => kindsl.scene.trees.robot.joints.size === 12")
    frame.locator("#animate").click()
    moved = "() => [...kindsl.scene.q.values()].some((value) => Math.abs(value) > 0.01)"
    frame.wait_for_function(moved)
    frame.locator("#animate").click()
    workbench.screenshot("walkthrough-example")
    open_walkthrough(workbench, steps)
    # The robot was seen, and the server runs; nothing was written yet.
    workbench.eventually(lambda: done.count() == 2, "two ticks")
    workbench.screenshot("walkthrough-ticked")


def test_enter_breaks_the_line_behind_a_number(workbench: Workbench) -> None:
    path = workbench.open("typed.kindsl", models.ARM.replace("id = 1\n", "\n", 1))
    workbench.go_to_place(6, 1)
    workbench.type("id = 1")
    workbench.press("Enter")
    workbench.eventually(lambda: "id = 1\n" in workbench.text_of(path), "the number and its line")


def open_walkthrough(workbench: Workbench, steps: Locator) -> None:
    """Open the walkthrough until its steps are seen."""
    title = "Get started with the Kinematics-DSL"
    row = workbench.page.locator(".quick-input-list .monaco-list-row", has_text=title)

    def choose() -> None:
        workbench.run_until("Welcome: Open Walkthrough...", row)
        row.click(timeout=PATIENCE)

    workbench.insist_until(choose, steps, "the walkthrough")
