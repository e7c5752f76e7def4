"""A tab with the playground, used as a person uses it."""

import base64
import json
import time
import zlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from typing import Any

from playwright.sync_api import Frame, Page, TimeoutError, ViewportSize
from tests.preview.handles import ARE_FREE, IS_GRASPED, LINES

TIMEOUT = 90.0
SIZE: ViewportSize = {"width": 1400, "height": 850}
FOUND = """() => {
    const { monaco, files } = window.playground;
    return monaco.editor.getModelMarkers({ resource: files.model().uri }).map((one) =>
        [one.code, one.startLineNumber, one.startColumn, one.endLineNumber, one.endColumn]);
}"""
# Holds back what the server says by some methods; an answer counts as its question or command.
HOLD_BACK = """{
    const Real = Worker, methods = new Set(), waiting = [];
    window.Worker = class extends Real {
        #asked = new Map();
        postMessage(message, ...more) {
            if (message?.method) this.#asked.set(message.id, message.params?.command ?? message.method);
            super.postMessage(message, ...more);
        }
        addEventListener(type, listener, ...more) {
            super.addEventListener(type, (event) => {
                const { method, id } = event.data ?? {};
                const take = () => listener.call(this, event);
                if (methods.has(method ?? this.#asked.get(id))) waiting.push(take);
                else take();
            }, ...more);
        }
    };
    window.late = {
        hold: (method) => methods.add(method),
        count: () => waiting.length,
        pass: () => {
            methods.clear();
            for (const take of waiting.splice(0)) take();
        },
    };
}"""  # noqa: E501
PLACE_CURSOR = "([line, column]) => playground.editor.setPosition({ lineNumber: line, column })"


class Tab:
    """One page.

    Attributes:
        page: The browser's.
        requests: The addresses that were asked for.
        complaints: Errors and warnings of the page's console.
    """

    def __init__(self, page: Page) -> None:
        self.page = page
        self.requests: list[str] = []
        self.complaints: list[str] = []
        page.set_default_timeout(1000 * TIMEOUT)
        page.add_init_script(HOLD_BACK)
        page.on("request", lambda request: self.requests.append(request.url))
        page.on("pageerror", lambda error: self.complaints.append(str(error)))
        page.on("console", self._listen)

    def open(self, address: str) -> None:
        """Go to an address and wait for the server in the page."""
        self.page.goto(address)
        self.page.locator("body[data-state=ready]").wait_for()
        self.wait_for_texts()

    def wait_for_texts(self) -> None:
        """Wait until a text is shown, and all is said that a visit begins with."""
        self.page.wait_for_function("() => window.playground?.files.model() !== undefined")

    def eventually(self, see: Callable[[], Any], what: str) -> Any:
        """Return what is seen once it is true."""
        seen = self._seen_within(TIMEOUT, see)
        assert seen, f"not seen: {what}"
        return seen

    def _seen_within(self, seconds: float, see: Callable[[], Any]) -> Any:
        end = time.monotonic() + seconds
        while not (seen := see()) and time.monotonic() < end:
            self.page.wait_for_timeout(50)
        return seen

    def ask_until_seen(self, ask: Callable[[], Any], see: Callable[[], Any], what: str) -> Any:
        """Return what is seen once it is true, asking again with more and more patience.

        What opens over a text closes when that scrolls, or is told something new.
        """
        end = time.monotonic() + TIMEOUT
        patience = 1.0
        while time.monotonic() < end:
            ask()
            if seen := self._seen_within(patience, see):
                return seen
            patience *= 2
        raise AssertionError(f"not seen: {what}")

    def trigger(self, action: str) -> None:
        """Do what a key of the editor would do."""
        self.page.evaluate(
            "(id) => playground.editor.trigger('test', id, {})", f"editor.action.{action}"
        )

    def show(self, name: str, text: str) -> None:
        """Open a text in a tab of the editor."""
        self.open_beside(name, text)
        self.page.evaluate("(name) => playground.files.show(name)", name)

    def open_beside(self, name: str, text: str) -> None:
        """Open a text in a tab of the editor that is not shown."""
        self.page.evaluate("(file) => playground.files.open(...file)", [name, text])

    @contextmanager
    def held(self, method: str) -> Iterator[None]:
        """Hold back what the server says by a method, or answers to it, until the end."""
        self.page.evaluate("(method) => late.hold(method)", method)
        yield
        self.page.evaluate("() => late.pass()")

    def wait_for_held(self) -> None:
        """Wait until something is held back."""
        self.eventually(lambda: self.page.evaluate("() => late.count()"), "what is held back")

    def found(self) -> list[list[Any]]:
        """Return code, start and end of each problem of the shown text, lines from 1."""
        return sorted(self.page.evaluate(FOUND))

    def text(self) -> str:
        """Return the shown text."""
        return str(self.page.evaluate("() => playground.files.model().getValue()"))

    def fix_first(self) -> str:
        """Take the first fix of the first problem; return its title."""
        before = self.text()
        fix = self.page.locator("#problems .fix").first
        actions = self.page.locator(".action-widget .monaco-list-row.action")

        def ask() -> None:
            """Click, unless a list is there or comes meanwhile and lies over everything."""
            if not actions.first.is_visible():
                with suppress(TimeoutError):
                    fix.click(timeout=5000)

        def title_of_taken() -> str:
            """Click: if the list closes meanwhile, no key goes into the text."""
            titles = actions.all_inner_texts()
            try:
                if titles:
                    actions.first.click(timeout=5000)
            except TimeoutError:
                return ""
            return titles[0] if titles else ""

        title = str(self.ask_until_seen(ask, title_of_taken, "a list of fixes"))
        self.eventually(lambda: self.text() != before, f"the text changed by '{title}'")
        return title

    def preview(self) -> Frame:
        """Return the preview's frame."""
        frame: Frame = self.eventually(
            lambda: next((f for f in self.page.frames if "preview.html" in f.url), None), "preview"
        )
        return frame

    def grasp(self, kind: str, name: str) -> None:
        """Choose a thing in the preview and wait for its handles."""
        frame = self.preview()
        thing = {"kind": kind, "name": name}
        frame.evaluate("(thing) => kindsl.selection.choose(thing)", thing)
        frame.wait_for_function(IS_GRASPED, arg=[kind, name])

    def drag_arrow(self, component: str) -> None:
        """Pull a component's arrow by half of its length, from where nothing lies over it."""
        frame = self.preview()
        seen: list[Any] = []

        def found() -> tuple[float, float, float, float] | None:
            seen.append(frame.evaluate(LINES).get(component))
            if seen[-1] is None or seen[-1] not in seen[:-1]:
                return None  # still turning
            (x0, y0), (x1, y1) = seen[-1]
            dx, dy = x1 - x0, y1 - y0
            places = [(x0 + s * dx, y0 + s * dy) for s in (0.95, 0.8, 0.65, 0.5)]
            free = frame.evaluate(ARE_FREE, [component, places])
            return (*places[free.index(True)], dx, dy) if True in free else None

        x, y, dx, dy = self.eventually(found, f"the arrow {component}")
        box = self.page.locator("#preview").bounding_box()
        assert box is not None
        self.page.mouse.move(box["x"] + x, box["y"] + y)
        self.page.mouse.down()
        for share in (0.2, 0.35, 0.5):
            self.page.mouse.move(box["x"] + x + share * dx, box["y"] + y + share * dy)
        self.page.mouse.up()

    def expect_robot(self, name: str) -> None:
        """Wait until the preview shows a robot of that name."""
        title = self.preview().locator("#robot")
        self.eventually(lambda: title.text_content() == name, f"the robot {name}")

    def _listen(self, message: Any) -> None:
        if message.type in ("error", "warning"):
            self.complaints.append(message.text)


def fragment(active: str, files: Mapping[str, str]) -> str:
    """Return the part of a link that holds texts."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    data = json.dumps({"active": active, "files": dict(files)}).encode()
    packed = packer.compress(data) + packer.flush()
    return base64.urlsafe_b64encode(packed).decode().rstrip("=")
