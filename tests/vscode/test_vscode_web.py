"""The extension in VS Code for the web: no process, the server in a worker, a virtual workspace."""

import json
from collections.abc import Iterator
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, Locator, TimeoutError, expect
from tests.vscode import browser as browser_module
from tests.vscode import models, vscode_web
from tests.vscode.code_server import EXTENSION, ROOT
from tests.vscode.workbench import PATIENCE, START_TIMEOUT, Workbench

# The first test waits for what is built for all of them.
pytestmark = pytest.mark.timeout(900)
# The reach is bound by the configuration in the workspace, and nowhere else.
BROKEN = models.BROKEN.replace("(0.4, 0.0, 0.0)", "(reach, 0.0, 0.0)")
URDF = (ROOT / "docs" / "guide" / "pan_tilt.urdf").read_text()
CONFIGURATION = "parameters = { reach = 0.4 }\n"


@pytest.fixture(scope="module")
def requests() -> list[str]:
    """The addresses that the window and its frames have asked for."""
    return []


@pytest.fixture(scope="module")
def workbench(
    browser: Browser, requests: list[str], tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Workbench]:
    """One window on the workspace."""
    browser_module.require("npm")
    files = {
        "arm.kindsl": BROKEN, "kindsl.toml": CONFIGURATION, "parts/closed.kindsl": models.BROKEN,
        "pan_tilt.urdf": URDF, "broken.urdf": "<robot>\n<link",
    }  # fmt: skip
    extension = vscode_web.unpacked_extension(tmp_path_factory.mktemp("package"))
    work = tmp_path_factory.mktemp("vscode-web")
    with vscode_web.running(work, extension, files) as server:
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        page.context.on("request", lambda request: requests.append(request.url))
        window = Workbench(page, server, work)

        def open_file() -> None:
            try:
                page.get_by_role("treeitem", name="arm.kindsl").click(timeout=START_TIMEOUT)
            except TimeoutError:
                # VS Code does without an extension, that of the files, which it could not load.
                page.reload(wait_until="domcontentloaded")
                raise
            window.active_tab("arm.kindsl").wait_for(timeout=PATIENCE)

        window.insist(open_file, "arm.kindsl in an editor")
        # The server starts, then finds.
        expect(window.squiggles("error")).to_have_count(2, timeout=90_000)
        yield window
        page.close()


def test_findings_explain_and_fix_themselves(workbench: Workbench) -> None:
    place = BROKEN.partition("elbov")[0]
    workbench.go_to_place(place.count("\n") + 1, len(place) - place.rfind("\n"))
    workbench.hover("elbov")
    workbench.press("Escape")
    take_first_fix(workbench)
    expect(workbench.squiggles("error")).to_have_count(1)
    workbench.eventually(lambda: any("via elbow" in line for line in workbench.lines()), "the fix")


def test_the_configuration_of_a_virtual_workspace_holds(workbench: Workbench) -> None:
    shown = [line for line in workbench.lines() if "reach" in line]
    assert shown
    workbench.eventually(
        lambda: any("0.4" in line for line in workbench.lines() if "reach" in line), "its value"
    )


def test_a_slider_moves_the_robot_in_the_panel(workbench: Workbench) -> None:
    action = workbench.page.locator(".editor-actions [aria-label*='Open Preview to the Side']")
    workbench.click_until(action, workbench.page.locator(".tab", has_text="Preview arm.kindsl"))
    page = preview_page(workbench)
    expect(page.locator("#robot")).to_have_text("arm")
    page.get_by_role("slider", name="shoulder", exact=True).fill("1.2")
    turned = "() => Math.abs(kindsl.scene.q.get('shoulder') - 1.2) < 0.01"
    workbench.eventually(lambda: page.evaluate(turned), "the arm turned")
    workbench.screenshot("vscode-web")


def test_the_picture_follows_the_text(workbench: Workbench) -> None:
    workbench.page.locator(".editor-group-container .view-line").first.click()
    workbench.go_to_place(1, len("Robot arm") + 1)
    workbench.type("2")
    expect(preview_page(workbench).locator("#robot")).to_have_text("arm2")


def test_the_robot_is_shown_as_urdf(workbench: Workbench) -> None:
    workbench.page.locator(".editor-group-container .view-line").first.click()
    workbench.run("Kinematics-DSL: Show as URDF")
    workbench.eventually(
        lambda: any('<robot name="arm2">' in line for line in workbench.lines()), "the URDF"
    )


def test_a_urdf_is_imported_with_remarks(workbench: Workbench) -> None:
    field = workbench.field()

    def choose() -> None:
        workbench.run("Kinematics-DSL: Import URDF or SDF")
        workbench.wait_until(lambda: field.is_visible() and field.input_value() == "/robots/")
        field.fill("/robots/pan_tilt.urdf")
        field.press("Enter", timeout=PATIENCE)
        field.wait_for(state="hidden", timeout=PATIENCE)

    workbench.insist(choose, "an imported file")
    workbench.eventually(
        lambda: any(line.startswith("Robot pan_tilt {") for line in workbench.lines()),
        "the document",
    )
    remarks = workbench.notifications().filter(has_text="pan_tilt.urdf: ")
    expect(remarks.first).to_contain_text(
        "the link 'camera', fixed to 'tilt_link', became a frame of it"
    )
    workbench.screenshot("imported")


def test_what_cannot_be_imported_is_said(workbench: Workbench) -> None:
    message = workbench.notifications().filter(has_text="broken.urdf: ")

    def choose() -> None:
        workbench.press("Escape")  # a menu of the time before lies over everything
        file = workbench.page.get_by_role("treeitem", name="broken.urdf")
        file.click(button="right", timeout=PATIENCE)
        item = workbench.page.get_by_role("menuitem", name="Import URDF or SDF")
        # A menu does not hear a button that is released in its first 100 ms.
        item.click(delay=300, timeout=PATIENCE)
        message.first.wait_for(timeout=PATIENCE)

    workbench.insist(choose, "a message")
    expect(message.first).to_contain_text("not a readable URDF: not well-formed XML at line 2")


def test_no_other_host_is_asked(requests: list[str]) -> None:
    web = [urlsplit(url) for url in requests if url.startswith("http")]
    assert web
    assert {
        url.hostname for url in web if not (url.hostname or "").endswith(vscode_web.SITE)
    } == set()


def test_what_needs_a_process_is_not_offered(workbench: Workbench) -> None:
    rows = workbench.page.locator(".quick-input-list .monaco-list-row")
    workbench.ask("F1", ">Kinematics-DSL: ")
    expect(rows.filter(has_text="Restart Server")).to_be_visible()
    for title in ("Select Python Interpreter", "Open Preview in Browser"):
        expect(rows.filter(has_text=title)).to_have_count(0)
    workbench.press("Escape")


def test_findings_of_closed_files_are_listed(workbench: Workbench) -> None:
    page, tabs = workbench.page, workbench.page.locator(".tab")
    while tabs.count() > 0:
        workbench.run("View: Revert and Close Editor")
    was_open = workbench.problems().filter(has_text="arm.kindsl")
    never_open = workbench.problems().filter(has_text="closed.kindsl")
    expect(was_open).to_have_count(1)
    expect(never_open).to_have_count(1)
    folder, file = (
        page.get_by_role("treeitem", name=name, exact=True) for name in ("parts", "closed.kindsl")
    )
    workbench.click_until(folder, file)
    workbench.click_until(file, workbench.active_tab("closed.kindsl"))
    expect(workbench.squiggles("error")).to_have_count(2)
    workbench.screenshot("web-closed")
    page.locator(".editor-group-container .view-line").first.click()
    workbench.press("Control+a")
    workbench.press("Delete")
    # All files have been asked for once more when this is known.
    expect(never_open).to_have_count(0)
    expect(was_open).to_have_count(1)


def test_each_command_that_is_offered_is_there() -> None:
    manifest = json.loads((EXTENSION / "package.json").read_text())
    sources = [EXTENSION / "src" / name for name in ("commands.ts", "browser/extension.ts")]
    source = "".join(path.read_text() for path in sources)
    hidden = {
        item["command"]
        for item in manifest["contributes"]["menus"]["commandPalette"]
        if "!isWeb || remoteName" in item["when"]
    }
    for command in manifest["contributes"]["commands"]:
        assert (f'"{command["command"]}"' in source) != (command["command"] in hidden), command


def take_first_fix(workbench: Workbench) -> None:
    """Take the first fix at the cursor; a list that comes during a check closes at once."""
    fix = workbench.page.locator(".action-widget .monaco-list-row.action").first

    def is_listed() -> bool:
        workbench.run("Quick Fix...")
        try:
            fix.wait_for(timeout=5000)
        except TimeoutError:
            return False
        return True

    workbench.eventually(is_listed, "a list of fixes")
    # Not a click: the list takes none while it is new.
    workbench.press("Enter")


def preview_page(workbench: Workbench) -> Locator:
    """Return the body of the panel's page, found again whenever the editor replaces its frames."""
    panel = workbench.page.frame_locator("iframe.webview.ready").frame_locator("#active-frame")
    return panel.locator("body")
