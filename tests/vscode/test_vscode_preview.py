"""The preview beside the text, in a real VS Code."""

from playwright.sync_api import Error, Frame, Locator, TimeoutError, expect
from tests.vscode import models
from tests.vscode.picture import colours
from tests.vscode.workbench import PATIENCE, Workbench

NEXT_PICTURE = "() => new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)))"


def test_the_title_bar_opens_the_robot_beside_the_text(workbench: Workbench) -> None:
    workbench.open("arm.kindsl", models.ARM)
    action = workbench.page.locator(".editor-actions [aria-label*='Open Preview to the Side']")
    workbench.click_until(action, workbench.page.locator(".tab", has_text="Preview arm.kindsl"))
    frame = workbench.preview_frame()
    expect(frame.locator("#robot")).to_have_text("arm")

    def has_a_robot() -> bool:
        count, share = colours(workbench.page, settled_picture(frame))
        return count > 50 and share < 0.95

    workbench.eventually(has_a_robot, "a picture with a robot")
    workbench.screenshot("preview")


def test_a_slider_moves_the_robot(workbench: Workbench) -> None:
    frame = workbench.preview_frame()
    before = settled_picture(frame)
    set_slider(frame, "elbow", 1.2)
    workbench.eventually(lambda: settled_picture(frame) != before, "the moved robot")
    workbench.screenshot("preview-moved")


def test_a_click_in_the_picture_moves_the_cursor(workbench: Workbench) -> None:
    frame = workbench.preview_frame()
    line = models.ARM.partition("link lower")[0].count("\n") + 1
    click_on(workbench, frame, "link lower", workbench.cursor_in(line))
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

    def save() -> None:
        picture.click(position={"x": 5, "y": 5}, timeout=PATIENCE)
        # VS Code hears a moment later that the picture has the focus, and loses a key until then.
        workbench.press("Control+s")
        workbench.page.locator(".tab.dirty").wait_for(state="detached", timeout=PATIENCE)

    workbench.insist(save, "a saved document")
    assert "(0.4, 0.0" in path.read_text()
    names = workbench.page.locator(".quick-input-widget input[type=text]:focus")
    workbench.press_until("Control+p", names)
    workbench.press("Escape")
    expect(names).to_be_hidden()


def test_the_status_bar_follows_while_the_picture_has_the_focus(workbench: Workbench) -> None:
    path = workbench.open("arm.kindsl")
    before = path.read_text()
    expect(workbench.status("2 dof")).to_be_visible()
    picture = workbench.preview_frame().locator("#pane")

    def focus() -> None:
        picture.click(position={"x": 5, "y": 5}, timeout=PATIENCE)
        workbench.page.locator(".tab.active", has_text="Preview arm").wait_for(timeout=PATIENCE)

    workbench.insist(focus, "the focus in the picture")
    path.write_text(models.OTHER)
    expect(workbench.status("1 dof")).to_be_visible()
    path.write_text(before)
    expect(workbench.status("2 dof")).to_be_visible()


def test_the_panel_follows_the_active_editor(workbench: Workbench) -> None:
    workbench.open("second.kindsl", models.OTHER)
    expect_robot(workbench, "other")
    workbench.open("arm.kindsl")
    expect_robot(workbench, "arm")


def test_a_pinned_panel_stays(workbench: Workbench) -> None:
    tab = workbench.page.locator(".tab", has_text="Preview arm.kindsl")
    pinned = tab.filter(has_text="Pinned: ")
    click_in_title_bar(workbench, "Pin Preview to This Document", pinned)
    workbench.open("second.kindsl")
    # The extension changes the panel before it tells the degrees of freedom.
    expect(workbench.status("1 dof")).to_be_visible()
    expect(pinned).to_have_count(1)
    expect_robot(workbench, "arm")
    following = tab.filter(has_not_text="Pinned: ")
    click_in_title_bar(workbench, "Let Preview Follow the Active Editor", following)
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
    page = workbench.page_in_browser()
    expect(page.locator("#robot")).to_have_text("arm")
    page.close()


def test_the_lens_above_the_robot_opens_it(workbench: Workbench) -> None:
    workbench.close(workbench.page.locator(".tab", has_text="Preview arm.kindsl"))
    workbench.open("second.kindsl")
    lens = workbench.page.locator(".codelens-decoration a", has_text="Preview")
    workbench.click_until(lens, workbench.page.locator(".tab", has_text="Preview second.kindsl"))
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


def click_in_title_bar(workbench: Workbench, title: str, seen: Locator) -> None:
    """Give the preview's tab the focus and click one of its buttons, until that is seen."""

    def click() -> None:
        workbench.page.locator(".tab", has_text="Preview arm.kindsl").click(timeout=PATIENCE)
        button = workbench.page.locator(f".editor-actions [aria-label*='{title}']")
        button.click(timeout=PATIENCE)
        seen.wait_for(timeout=PATIENCE)

    workbench.insist(click, f"what {title} does")


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


def click_on(workbench: Workbench, frame: Frame, name: str, seen: Locator) -> None:
    """Click where the preview says that this is under the mouse, until that is seen."""
    tip = frame.locator(".tip:visible", has_text=name)

    def click() -> None:
        box = frame.locator("canvas").bounding_box()
        assert box is not None
        for row in range(1, 20):
            for column in range(1, 20):
                place = (box["x"] + column * box["width"] / 20, box["y"] + row * box["height"] / 20)
                workbench.page.mouse.move(*place)
                # The page is told of the mouse with its next picture.
                frame.evaluate(NEXT_PICTURE)
                if tip.count():
                    workbench.page.mouse.click(*place)
                    seen.wait_for(timeout=PATIENCE)
                    return
        raise TimeoutError(f"{name} is nowhere in the picture")

    workbench.insist(click, f"what a click on {name} shows")
