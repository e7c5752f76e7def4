"""What a user sees and does in a document and finds on the extension's page, in a real VS Code."""

import re
import subprocess
import sys

from playwright.sync_api import Error, Frame, expect
from tests.vscode import models
from tests.vscode.workbench import Workbench

WIDTHS = "() => [...document.images].map((image) => image.naturalWidth)"


def test_findings_are_underlined_and_listed(workbench: Workbench) -> None:
    workbench.open("listed.kindsl", models.BROKEN)
    expect(workbench.squiggles("error")).to_have_count(2)
    row = workbench.problems().filter(has_text="KD106")
    expect(row).to_contain_text("elbov")
    expect(row).to_contain_text("Ln 12")
    workbench.screenshot("problems")
    workbench.hide_panel()


def test_a_binding_that_nothing_uses_is_underlined(workbench: Workbench) -> None:
    workbench.open("bound.kindsl", models.ARM)
    path = workbench.open("kindsl.toml", "[parameters]\nfree = 2.0\n")
    expect(workbench.squiggles("warning")).to_have_count(1)
    expect(workbench.problems().filter(has_text="KD404")).to_contain_text("Ln 2")
    workbench.hide_panel()
    workbench.run("View: Close Editor")
    expect(workbench.page.locator(".tab", has_text=path.name)).to_have_count(0)
    path.unlink()


def test_hover_tells_about_a_link(workbench: Workbench) -> None:
    path = workbench.open("hover.kindsl", models.ARM)
    workbench.go_to("lower via", path)
    workbench.hover("lower")
    workbench.screenshot("hover")
    workbench.press("Escape")


def test_completion_offers_what_fits_the_place(workbench: Workbench) -> None:
    text = models.ARM.replace("        children { }\n", "        children {\n        }\n")
    path = workbench.open("completion.kindsl", text)
    workbench.go_to("children {\n        }", path, len("children {"))
    workbench.press("Enter")
    workbench.press_until("Control+Space", workbench.suggestions())
    workbench.screenshot("completion")
    workbench.press("Escape")
    workbench.save()


def test_a_snippet_writes_a_section(workbench: Workbench) -> None:
    path = workbench.open("snippet.kindsl", models.ARM)
    workbench.go_to("    r_joint shoulder", path)
    workbench.type("p_joi")
    offered = workbench.suggestions().filter(has_text="p_joint")
    # A list that comes by itself goes for good where something takes the focus for a moment.
    workbench.press_until("Control+Space", offered)
    written = workbench.page.locator(".editor-group-container.active .view-line")
    workbench.click_until(offered.first, written.filter(has_text=re.compile(r"p_joint\s+\w+\s+\{")))
    workbench.press("Escape")
    assert re.search(r"p_joint \w+ \{\s+ref_frame \{", workbench.text_of(path))


def test_rename_reaches_every_place(workbench: Workbench) -> None:
    path = workbench.open("rename.kindsl", models.ARM)
    workbench.go_to("elbow {", path)
    field = workbench.page.locator(".rename-box input")
    workbench.press_until("F2", field)
    expect(field).to_have_value("elbow")
    field.fill("knee")
    field.press("Enter")
    expect(workbench.page.locator(".tab.active.dirty")).to_have_count(1)
    assert workbench.text_of(path) == models.ARM.replace("elbow", "knee")


def test_format_lays_the_document_out(workbench: Workbench) -> None:
    crooked = models.ARM.replace("            mass = 2.0", "  mass=2.0").replace("{ }", "{}")
    path = workbench.open("format.kindsl", crooked)
    workbench.run_until("Format Document", workbench.page.locator(".tab.active.dirty"))
    command = [sys.executable, "-m", "kindsl", "format", "-"]
    result = subprocess.run(command, input=crooked, capture_output=True, text=True, check=True)
    assert workbench.text_of(path) == result.stdout


def test_format_leaves_alone_what_does_not_parse(workbench: Workbench) -> None:
    broken = models.ARM.replace("CoM = (0.2, 0.0, 0.0)", "CoM = (0.2, 0.0,")
    path = workbench.open("unformatted.kindsl", broken)
    expect(workbench.squiggles("error").first).to_be_visible()
    workbench.run("Format Document")
    # A later question is answered, so the formatter has answered too.
    workbench.go_to("lower via", path)
    workbench.hover("lower")
    workbench.press("Escape")
    assert workbench.text_of(path) == broken


def test_a_quick_fix_mends_the_place(workbench: Workbench) -> None:
    path = workbench.open("fix.kindsl", models.BROKEN)
    expect(workbench.squiggles("error")).to_have_count(2)
    workbench.go_to("elbov", path, 1)
    fix = workbench.fixes("elbow").and_(workbench.page.locator(".focused"))
    expect(fix).to_be_visible()
    workbench.screenshot("quick-fix")
    workbench.press("Enter")
    expect(workbench.squiggles("error")).to_have_count(1)
    assert "lower via elbow" in workbench.text_of(path)


def test_colours_come_from_the_meaning(workbench: Workbench) -> None:
    path = workbench.open("colours.kindsl", models.ARM)
    workbench.go_to("upper via", path)
    inspection = workbench.page.locator(".token-inspect-widget")
    told = inspection.filter(has_text="semantic token type")

    def inspect() -> None:
        # It tells what was known when it opened, and is not opened twice.
        workbench.press("Escape")
        workbench.run("Developer: Inspect Editor Tokens and Scopes")

    workbench.insist_until(inspect, told, "the meaning of a name")
    expect(inspection).to_contain_text("class")
    expect(inspection).to_contain_text("entity.name.type.class.link.kindsl")
    workbench.press("Escape")


def test_inlay_hints_stand_beside_values(workbench: Workbench) -> None:
    path = workbench.open("hints.kindsl", models.ARM)
    workbench.go_to("r_joint elbow", path)
    written = set(re.sub(r"\s", "", models.ARM))
    shown = workbench.eventually(
        lambda: [line for line in workbench.lines() if set(re.sub(r"\s", "", line)) - written],
        "an inlay hint",
    )
    assert shown
    workbench.screenshot("inlay-hints")


def test_the_lens_above_a_link_lists_its_references(workbench: Workbench) -> None:
    path = workbench.open("lens.kindsl", models.ARM)
    workbench.go_to("r_joint elbow", path)
    lens = workbench.page.locator(".codelens-decoration a", has_text="1 reference").last
    peek = workbench.page.locator(".peekview-widget .ref-tree")
    workbench.click_until(lens, peek)
    expect(peek).to_contain_text("lower via elbow")
    workbench.press("Escape")


def test_the_outline_is_the_text(workbench: Workbench) -> None:
    path = workbench.open("outline.kindsl", models.ARM)
    workbench.run("Explorer: Focus on Outline View")
    rows = workbench.page.locator(".outline-pane .monaco-list-row")
    levels = {"pedestal": "2", "upper": "2", "lower": "2", "tip": "3"}
    for name, level in levels.items():
        row = rows.filter(has_text=re.compile(rf"^\s*{name}"))
        expect(row).to_have_attribute("aria-level", level)
    workbench.go_to("translation = (0.3", path)
    crumbs = workbench.page.locator(".breadcrumbs-control .monaco-breadcrumb-item")
    for name in ("lower", "tip"):
        expect(crumbs.filter(has_text=name)).to_be_visible()
    workbench.screenshot("outline")
    workbench.pane("Outline").locator(".pane-header").click()


def test_the_tree_view_leads_to_the_source(workbench: Workbench) -> None:
    path = workbench.open("tree.kindsl", models.ARM)
    workbench.run("Explorer: Focus on Kinematic Tree View")
    tree = workbench.pane("Kinematic Tree")
    expect(tree.locator(".pane-header")).to_contain_text(path.name)
    row = tree.get_by_role("treeitem").filter(has_text=re.compile(r"^\s*lower"))
    line = path.read_text().partition("link lower")[0].count("\n") + 1
    workbench.click_until(row, workbench.cursor_in(line))
    workbench.screenshot("kinematic-tree")


def test_the_status_bar_counts_the_degrees_of_freedom(workbench: Workbench) -> None:
    workbench.open("status.kindsl", models.ARM)
    expect(workbench.status("2 dof")).to_be_visible()


def test_findings_come_back_after_a_restart(workbench: Workbench) -> None:
    workbench.open("restart.kindsl", models.BROKEN)
    expect(workbench.squiggles("error")).to_have_count(2)
    workbench.run("Kinematics-DSL: Restart Server")
    expect(workbench.squiggles("error")).to_have_count(2)
    expect(workbench.notifications()).to_have_count(0)


def test_an_untitled_document_is_checked(workbench: Workbench) -> None:
    workbench.run("Kinematics-DSL: New Robot")
    workbench.page.locator(".tab.active", has_text="Untitled").wait_for()
    # Its names are there to be typed over.
    workbench.eventually(lambda: any("RobotBase" in line for line in workbench.lines()), "a robot")
    workbench.wait_for_editor()
    workbench.type("Robot r {\nnonsense\n")
    expect(workbench.squiggles("error").first).to_be_visible()
    workbench.screenshot("untitled")


def test_the_extensions_page_shows_its_pictures(workbench: Workbench) -> None:
    row = workbench.page.locator(".extension-list-item", has_text="Kinematics-DSL").first
    workbench.run_until("View: Show Extensions", row)
    workbench.click_until(row, workbench.page.locator(".extension-editor"))

    def drawn() -> bool:
        shown = [widths(frame) for frame in workbench.page.frames if "webview" in frame.url]
        return any(len(found) >= 2 and min(found) > 100 for found in shown)

    workbench.eventually(drawn, "pictures in the extension's page")
    workbench.screenshot("extension-page")


def widths(frame: Frame) -> list[int]:
    """Return the width of each picture in a frame, 0 for one that is not shown."""
    try:
        found: list[int] = frame.evaluate(WIDTHS)
    except Error:
        # The frame was replaced while it was looked at.
        return []
    return found
