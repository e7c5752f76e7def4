"""The preview beside the text, in a real VS Code."""

from playwright.sync_api import Error, Frame, Page, expect
from tests.vscode import models
from tests.vscode.picture import colours
from tests.vscode.workbench import Workbench


def test_the_title_bar_opens_the_robot_beside_the_text(workbench: Workbench) -> None:
    workbench.open("arm.kindsl", models.ARM)
    workbench.page.locator(".editor-actions [aria-label*='Open Preview to the Side']").click()
    frame = workbench.preview_frame()
    expect(frame.locator("#robot")).to_have_text("arm")
    count, share = colours(workbench.page, settled_picture(frame))
    assert count > 50
    assert share < 0.95
    workbench.screenshot("preview")


def test_a_slider_moves_the_robot(workbench: Workbench) -> None:
    frame = workbench.preview_frame()
    before = settled_picture(frame)
    set_slider(frame, "elbow", 1.2)
    workbench.eventually(lambda: settled_picture(frame) != before, "the moved robot")
    workbench.screenshot("preview-moved")


def test_a_click_in_the_picture_moves_the_cursor(workbench: Workbench) -> None:
    frame = workbench.preview_frame()
    click_on(workbench.page, frame, "link lower")
    line = models.ARM.partition("link lower")[0].count("\n") + 1
    workbench.expect_cursor(line)
    expect(workbench.active_tab("arm.kindsl")).to_be_visible()
    assert workbench.preview_frame() is not None


def test_the_picture_follows_a_keystroke(workbench: Workbench) -> None:
    frame = workbench.preview_frame()
    before = settled_picture(frame)
    path = workbench.open("arm.kindsl")
    workbench.go_to("(0.4, 0.0", path, 3)
    workbench.press("Shift+ArrowRight")
    workbench.type("9")
    workbench.eventually(lambda: settled_picture(frame) != before, "the longer arm")
    workbench.save()


def test_shortcuts_work_with_the_focus_in_the_picture(workbench: Workbench) -> None:
    path = workbench.open("arm.kindsl")
    workbench.go_to("(0.9, 0.0", path, 3)
    workbench.press("Shift+ArrowRight")
    workbench.type("4")
    expect(workbench.page.locator(".tab.dirty")).to_have_count(1)
    picture = workbench.preview_frame().locator("#pane")
    picture.click(position={"x": 5, "y": 5})
    workbench.press("Control+s")
    expect(workbench.page.locator(".tab.dirty")).to_have_count(0)
    assert "(0.4, 0.0" in path.read_text()
    workbench.press("Control+p")
    names = workbench.page.locator(".quick-input-widget input[type=text]")
    expect(names).to_be_focused()
    workbench.press("Escape")
    expect(names).to_be_hidden()


def test_the_panel_follows_the_active_editor(workbench: Workbench) -> None:
    workbench.open("second.kindsl", models.ARM.replace("Robot arm", "Robot other"))
    expect_robot(workbench, "other")
    workbench.open("arm.kindsl")
    expect_robot(workbench, "arm")


def test_a_pinned_panel_stays(workbench: Workbench) -> None:
    click_in_title_bar(workbench, "Pin Preview to This Document")
    workbench.page.locator(".tab", has_text="Pinned: Preview arm.kindsl").wait_for()
    workbench.open("second.kindsl")
    workbench.page.wait_for_timeout(1500)
    expect_robot(workbench, "arm")
    click_in_title_bar(workbench, "Let Preview Follow the Active Editor")
    workbench.open("arm.kindsl")


def test_the_panel_comes_back_after_a_server_restart(workbench: Workbench) -> None:
    before = workbench.preview_frame().url
    workbench.run("Kinematics-DSL: Restart Server")
    workbench.eventually(lambda: workbench.preview_frame().url != before, "another server's page")
    expect_robot(workbench, "arm")


def test_the_panel_survives_a_reload_of_the_window(workbench: Workbench) -> None:
    with workbench.page.expect_event("domcontentloaded"):
        workbench.run("Developer: Reload Window")
    workbench.wait_until_up()
    expect_robot(workbench, "arm")
    workbench.screenshot("preview-reloaded")


def test_the_browser_shows_it_too(workbench: Workbench) -> None:
    workbench.open("arm.kindsl")
    with workbench.page.context.expect_page() as opened:
        workbench.run("Kinematics-DSL: Open Preview in Browser")
    page = opened.value
    expect(page.locator("#robot")).to_have_text("arm")
    page.close()


def test_the_lens_above_the_robot_opens_it(workbench: Workbench) -> None:
    tab = workbench.page.locator(".tab", has_text="Preview arm.kindsl")
    tab.locator(".codicon-close").click()
    expect(tab).to_have_count(0)
    workbench.open("second.kindsl")
    workbench.page.locator(".codelens-decoration a", has_text="Preview").click()
    expect_robot(workbench, "other")


def expect_robot(workbench: Workbench, name: str) -> None:
    """Wait until the preview shows the robot of that name."""

    def shown() -> bool:
        try:
            return workbench.preview_frame().locator("#robot").text_content() == name
        except Error:
            # The page was replaced while it was looked at.
            return False

    workbench.eventually(shown, f"the robot {name}")


def click_in_title_bar(workbench: Workbench, title: str) -> None:
    """Give the preview's tab the focus and click one of its buttons."""
    workbench.page.locator(".tab", has_text="Preview arm.kindsl").click()
    workbench.page.locator(f".editor-actions [aria-label*='{title}']").click()


def settled_picture(frame: Frame) -> bytes:
    """Return the picture of the robot once two in a row are the same."""
    pane = frame.locator("#pane")
    last = pane.screenshot()
    for _ in range(50):
        frame.wait_for_timeout(100)
        current = pane.screenshot()
        if current == last:
            return current
        last = current
    return last


def set_slider(frame: Frame, name: str, value: float) -> None:
    """Move a joint's slider as the mouse would: an input event with a new value."""
    slider = frame.get_by_role("slider", name=name, exact=True)
    slider.fill(str(value))


def click_on(page: Page, frame: Frame, name: str) -> None:
    """Click where the preview says that this is under the mouse."""
    box = frame.locator("canvas").bounding_box()
    assert box is not None
    tip = frame.locator(".tip")
    for row in range(1, 20):
        for column in range(1, 20):
            place = (box["x"] + column * box["width"] / 20, box["y"] + row * box["height"] / 20)
            page.mouse.move(*place)
            if tip.is_visible() and tip.text_content() == name:
                page.mouse.click(*place)
                return
    raise AssertionError(f"{name} is nowhere in the picture")
