"""A window of VS Code, driven as a user would: keys, clicks, and what is there to be seen."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol

from playwright.sync_api import Error, Frame, Locator, Page, TimeoutError, expect
from tests.vscode.code_server import ROOT

SHOTS = ROOT / "artifacts" / "vscode"
TIMEOUT = 60_000
START_TIMEOUT = 90_000
# A gesture that brought nothing for so long was swallowed, and is made again.
PATIENCE = 10_000
GESTURES = 10
ACTIVE_GROUP = ".editor-group-container.active"


class Server(Protocol):
    """What serves VS Code."""

    def url(self, folder: Path) -> str:
        """Return the address that opens a folder."""
        ...


class Workbench:
    """One window on one folder.

    Attributes:
        page: The browser's page.
        folder: The folder that the window shows.
    """

    def __init__(self, page: Page, server: Server, folder: Path) -> None:
        self.page = page
        self.folder = folder
        page.set_default_timeout(TIMEOUT)
        expect.set_options(timeout=TIMEOUT)
        page.goto(server.url(folder), wait_until="domcontentloaded")
        self.wait_until_up()

    def wait_until_up(self) -> None:
        """Wait for the window, and for its extension host to have found the folder."""
        self.page.wait_for_selector(".explorer-folders-view", timeout=START_TIMEOUT)
        self.page.wait_for_selector(".statusbar-item", timeout=START_TIMEOUT)

    # ------------------------------------------------------------ documents

    def open(self, name: str, text: str | None = None) -> Path:
        """Open a file in the first column, made first if a text is given; return its path."""
        path = self.folder / name
        if text is not None:
            path.write_text(text, encoding="utf-8")
        shown = f'{ACTIVE_GROUP} .monaco-editor.focused[data-uri$="/{name}"]'

        def choose() -> None:
            self._focus_first_group()
            self.run("File: Open File...")
            self._rows(name).first.click(timeout=PATIENCE)
            self.field().wait_for(state="hidden", timeout=PATIENCE)
            self.page.wait_for_selector(shown, timeout=PATIENCE)

        self.insist(choose, f"{name} in an editor")
        return path

    def _focus_first_group(self) -> None:
        first = self.page.locator(".editor-group-container").first

        def focus() -> None:
            self.press("Control+1")
            # Not at once where the preview has the focus, whose page answers a key a moment later.
            self.wait_until(lambda: "active" in (first.get_attribute("class") or "").split())

        self.insist(focus, "the first group of editors")

    def active_tab(self, name: str) -> Locator:
        """The tab of a file, where it is its group's visible one."""
        return self.page.locator(f'.tab.active[data-resource-name="{name}"]')

    def save(self) -> None:
        """Save the active document."""

        def save() -> None:
            self.press("Control+s")
            unsaved = self.page.locator(f"{ACTIVE_GROUP} .tab.active.dirty")
            unsaved.wait_for(state="detached", timeout=PATIENCE)

        self.insist(save, "a saved document")

    def text_of(self, path: Path) -> str:
        """Save, and return what is in the file."""
        self.save()
        return path.read_text(encoding="utf-8")

    def go_to(self, text: str, path: Path, offset: int = 0) -> None:
        """Put the cursor at the first place of a text in the saved file."""
        before = path.read_text(encoding="utf-8").partition(text)[0] + text[:offset]
        line = before.count("\n") + 1
        column = len(before) - (before.rfind("\n") + 1) + 1
        self.go_to_place(line, column)

    def go_to_place(self, line: int, column: int) -> None:
        """Put the cursor at a place of the document that has the focus, both from 1."""

        def go() -> None:
            self.ask("Control+g", f":{line}:{column}")
            self.field().press("Enter", timeout=PATIENCE)
            self.cursor_in(line, column).wait_for(timeout=PATIENCE)
            self.wait_for_editor(PATIENCE)

        self.insist(go, f"the cursor at {line}:{column}")

    def wait_for_editor(self, timeout: float = TIMEOUT) -> None:
        """Wait until keys go into the text of the active group, for milliseconds at most."""
        self.page.wait_for_selector(f"{ACTIVE_GROUP} .monaco-editor.focused", timeout=timeout)

    def cursor_in(self, line: int, column: int | None = None) -> Locator:
        """The status bar where it tells a place in that line, or that very place."""
        pattern = rf"Ln {line}, Col {column}\b" if column else rf"Ln {line}, Col"
        return self.page.locator("#status\\.editor\\.selection", has_text=re.compile(pattern))

    # ------------------------------------------------------------ keys and commands

    def press(self, key: str) -> None:
        """Press a key."""
        self.page.keyboard.press(key)

    def type(self, text: str) -> None:
        """Type a text, a key at a time."""
        self.page.keyboard.type(text, delay=15)

    def run(self, title: str) -> None:
        """Run a command from the palette."""

        def choose() -> None:
            self.ask("F1", f">{title}")
            try:
                self._rows(title).first.click(timeout=PATIENCE)
            except TimeoutError:
                # While it is open it does not learn of a command that comes.
                self.press("Escape")
                raise

        self.insist(choose, f"the command {title}")

    def run_until(self, title: str, seen: Locator) -> None:
        """Run a command, again while VS Code answers it with nothing, until that is seen."""
        self.insist_until(lambda: self.run(title), seen, f"what {title} shows")

    def press_until(self, key: str, seen: Locator) -> None:
        """Press a key, again while VS Code answers it with nothing, until that is seen."""
        self.insist_until(lambda: self.press(key), seen, f"what {key} shows")

    def click_until(self, button: Locator, seen: Locator) -> None:
        """Click what VS Code may be drawing anew, until that is seen."""
        self.insist_until(lambda: button.click(timeout=PATIENCE), seen, "what a click shows")

    def fixes(self, text: str) -> Locator:
        """List the fixes at the cursor; return those that tell that text."""
        rows = self.page.locator(".action-widget .monaco-list-row", has_text=text)

        def ask() -> None:
            # VS Code says that there are none while it is about to ask.
            self.press("Escape")
            self.press("Control+.")

        self.insist_until(ask, rows, f"the fix {text}")
        return rows

    def close(self, tab: Locator) -> None:
        """Close a tab."""

        def close() -> None:
            if tab.count():
                tab.locator(".codicon-close").click(timeout=PATIENCE)
            tab.wait_for(state="detached", timeout=PATIENCE)

        self.insist(close, "a closed tab")

    def page_in_browser(self) -> Page:
        """Open the document's preview in the browser, and return its page."""
        context = self.page.context
        before = context.pages
        allow = self.page.get_by_role("button", name="Open", exact=True)

        def opened() -> list[Page]:
            return [page for page in context.pages if page not in before]

        def choose() -> None:
            self.run("Kinematics-DSL: Open Preview in Browser")
            self.wait_until(lambda: allow.is_visible() or opened() != [])
            if allow.is_visible():
                allow.click()
            self.wait_until(lambda: opened() != [])

        self.insist(choose, "a page in the browser")
        return opened()[0]

    def _rows(self, text: str) -> Locator:
        return self.page.locator(".quick-input-list .monaco-list-row", has_text=text)

    def field(self) -> Locator:
        """The input field of the palette and of dialogs."""
        return self.page.locator(".quick-input-widget input[type=text]")

    def ask(self, key: str, text: str) -> None:
        """Press a key that opens an input field and fill it."""

        def ask() -> None:
            self.press(key)
            try:
                self.field().fill(text, timeout=PATIENCE)
            except TimeoutError:
                # The focus is elsewhere, in the preview's page for example.
                tab = self.page.locator(".editor-group-container .tab.active").first
                if tab.is_visible():
                    tab.click(timeout=PATIENCE)
                raise

        self.insist(ask, f"an input field after {key}")

    def insist(self, gesture: Callable[[], None], what: str) -> None:
        """Make a gesture that waits for what it brings, again while VS Code swallows it."""
        for _ in range(GESTURES):
            try:
                gesture()
            except TimeoutError:
                continue
            return
        self.screenshot("missing")
        raise AssertionError(f"not seen: {what}")

    def insist_until(self, gesture: Callable[[], None], seen: Locator, what: str) -> None:
        """Make a gesture until that is seen, not again where it only came late."""
        is_made = False

        def make() -> None:
            nonlocal is_made
            if not (is_made and seen.first.is_visible()):
                is_made = True
                gesture()
            seen.first.wait_for(timeout=PATIENCE)

        self.insist(make, what)

    def wait_until(self, see: Callable[[], bool]) -> None:
        """Wait for what a gesture brings.

        Raises:
            TimeoutError: It did not come for a while.
        """
        for _ in range(PATIENCE // 100):
            if see():
                return
            self.page.wait_for_timeout(100)
        raise TimeoutError("not seen")

    def eventually(self, see: Callable[[], Any], what: str) -> Any:
        """Return what is seen once it is true."""
        for _ in range(TIMEOUT // 100):
            seen = see()
            if seen:
                return seen
            self.page.wait_for_timeout(100)
        self.screenshot("missing")
        raise AssertionError(f"not seen: {what}")

    # ------------------------------------------------------------ what is there to be seen

    def problems(self) -> Locator:
        """The rows of the Problems panel."""
        panel = self.page.locator(".markers-panel")

        def show() -> None:
            if not panel.is_visible():
                self.press("Control+Shift+m")
            panel.wait_for(timeout=PATIENCE)

        self.insist(show, "the Problems panel")
        return panel.locator(".monaco-list-row")

    def hide_panel(self) -> None:
        """Hide the panel below the editors."""
        panel = self.page.locator(".markers-panel")

        def hide() -> None:
            if panel.is_visible():
                self.run("View: Toggle Panel Visibility")
            panel.wait_for(state="hidden", timeout=PATIENCE)

        self.insist(hide, "no panel")

    def squiggles(self, severity: str) -> Locator:
        """The underlined places of a severity: error, warning, info."""
        return self.page.locator(f".editor-instance .squiggly-{severity}")

    def hover(self, text: str) -> None:
        """Show the hover at the cursor, which tells that text."""
        content = self.page.locator(".monaco-hover:visible .monaco-hover-content", has_text=text)
        self.run_until("Show or Focus Hover", content)

    def pane(self, title: str) -> Locator:
        """A part of the side bar, by its title."""
        header = self.page.locator(f'.pane-header[aria-label^="{title}"]')
        return self.page.locator(".pane", has=header)

    def suggestions(self) -> Locator:
        """The rows of the completion list."""
        return self.page.locator(".suggest-widget.visible .monaco-list-row")

    def status(self, text: str) -> Locator:
        """An item of the status bar."""
        return self.page.locator(".statusbar-item", has_text=text)

    def notifications(self) -> Locator:
        """The messages that popped up."""
        return self.page.locator(".notification-toast")

    def lines(self) -> list[str]:
        """The lines of the active editor that are on the screen, inlay hints included."""
        found = self.page.locator(".editor-group-container.active .view-line").all_inner_texts()
        return [line.replace("\xa0", " ") for line in found]

    def preview_frame(self) -> Frame:
        """The page that kindsl serves, inside the panel."""

        def find() -> Frame | None:
            frames = [frame for frame in self.page.frames if "token=" in frame.url]
            return frames[-1] if frames and _is_drawing(frames[-1]) else None

        frame: Frame = self.eventually(find, "the frame of the preview")
        return frame

    def screenshot(self, name: str) -> Path:
        """Keep a picture of the window."""
        SHOTS.mkdir(parents=True, exist_ok=True)
        path = SHOTS / f"{name}.png"
        self.page.screenshot(path=path)
        return path


def _is_drawing(frame: Frame) -> bool:
    """Return whether a page shows its picture; not one that VS Code has just replaced."""
    try:
        return frame.locator("canvas").first.is_visible()
    except Error:
        return False
