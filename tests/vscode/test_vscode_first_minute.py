"""What somebody meets first: a robot that moves, Enter, and what their other programs wrote.

That are reports of CAD programs, which are pasted, and a URDF.
"""

from functools import partial
from pathlib import Path

from playwright.sync_api import Locator, expect
from tests.analysis.test_urdf_fixes import LEGS, spoilt
from tests.cad.test_reports import REPORTS
from tests.vscode import models
from tests.vscode.workbench import PATIENCE, Workbench

MOMENT = 'iyy="0.0046023457"'
LINKS = ("upper", "lower", "hand")
NAMES = ("SolidWorks_upper_arm", "Fusion 360_hip", "Creo_shank")
POSE = "translation = (0.0, 0.0, 0.5) rotation = (0.0, 0.0, 0.0)"


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


def arm() -> str:
    """Return an arm of three links, each without inertia."""
    joints = ("shoulder", "elbow", "wrist")
    children = [f"{link} via {joint}" for link, joint in zip(LINKS, joints, strict=True)]
    lines = ["Robot arm {", f"RobotBase ground {{ children {{ {children[0]} }} }}"]
    for number, (link, child) in enumerate(zip(LINKS, (*children[1:], ""), strict=True), 1):
        lines += [
            f"link {link} {{",
            f"    id = {number}",
            "    ",
            f"    children {{ {child} }}",
            "}",
        ]
    lines += [f"r_joint {joint} {{ ref_frame {{ {POSE} }} }}" for joint in joints]
    return "\n".join((*lines, "}", ""))


def paste(workbench: Workbench, text: str) -> None:
    """Paste a text as the browser does."""
    workbench.page.evaluate("text => navigator.clipboard.writeText(text)", text)
    workbench.press("Control+v")


def _is_written(workbench: Workbench, path: Path, number: int) -> bool:
    return workbench.text_of(path).count("inertia_params") == number


def test_three_links_from_pasted_reports_alone(workbench: Workbench) -> None:
    workbench.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    path = workbench.open("pasted.kindsl", arm())
    # A server that is still starting is not waited for: the text is pasted, and the fix offered.
    expect(workbench.page.locator(".statusbar-item", has_text="3 dof")).to_be_visible()
    for number, (name, link) in enumerate(zip(NAMES, LINKS, strict=True), 1):
        before = path.read_text(encoding="utf-8").partition(f"link {link} {{")[0]
        workbench.go_to_place(before.count("\n") + 3, 5)
        paste(workbench, REPORTS[name])
        workbench.eventually(partial(_is_written, workbench, path, number), f"inertia of {link}")
    workbench.screenshot("pasted")
    assert "Moments" not in path.read_text(encoding="utf-8")
    expect(workbench.squiggles("error")).to_have_count(0)


def test_ignore_shows_no_bulb_of_a_fix(workbench: Workbench) -> None:
    text = arm().replace("(0.0, 0.0, 0.5)", "(0.0, 0.0, 50.0)")
    path = workbench.open("ignored.kindsl", text)
    workbench.go_to("50.0", path)
    row = workbench.fixes("Ignore KD502")
    workbench.screenshot("ignored")
    expect(row.locator(".codicon-light-bulb, .codicon-lightbulb")).to_have_count(0)
    fix = workbench.page.locator(".action-widget .monaco-list-row", has_text="Convert to metres")
    expect(fix.locator(".codicon-light-bulb, .codicon-lightbulb")).to_have_count(1)
    workbench.press("Escape")


def test_a_urdf_is_underlined_explained_and_fixed(workbench: Workbench) -> None:
    path = workbench.open("legs.urdf", spoilt(MOMENT, MOMENT.replace('"0', '"-0')))
    expect(workbench.squiggles("error")).to_have_count(1)
    expect(workbench.problems().filter(has_text="KD301")).to_contain_text("'left_thigh'")
    workbench.hide_panel()
    workbench.go_to('link name="left_thigh"', path)
    workbench.hover("carried by joint left_hip")
    workbench.screenshot("urdf")
    workbench.press("Escape")
    workbench.go_to("<inertial>", path, 1)
    fix = workbench.fixes("Change sign of iyy").and_(workbench.page.locator(".focused"))
    expect(fix).to_be_visible()
    workbench.press("Enter")
    expect(workbench.squiggles("error")).to_have_count(0)
    assert workbench.text_of(path) == LEGS
