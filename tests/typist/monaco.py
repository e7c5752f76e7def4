"""VS Code's editor core in a browser, with the real language server behind it.

The npm package `monaco-editor` is that core: the suggest list, Enter, Tab, snippets and brackets
behave in it as they do in VS Code. It is installed once into build/monaco.
"""

import fcntl
import json
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from playwright.sync_api import Browser, Page, Route
from tests.support.lsp import RawClient, running_server
from tests.vscode.browser import TIMEOUT, missing

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build" / "monaco"
# Frames come as fast as they are drawn, and nobody looks at them.
QUICK_FRAMES = ("--disable-gpu", "--disable-gpu-vsync", "--disable-frame-rate-limit")
_ADDRESS = "http://typist.invalid"
_TYPES = {".html": "text/html", ".mjs": "text/javascript", ".js": "text/javascript"}
# What moves by itself and makes no difference to what is typed.
_STILL = {"cursorBlinking": "solid", "smoothScrolling": False}
CAPABILITIES = {
    "textDocument": {
        "completion": {
            "contextSupport": True,
            "completionItem": {
                "snippetSupport": True,
                "insertReplaceSupport": True,
                "insertTextModeSupport": {"valueSet": [1, 2]},
            },
        }
    }
}


def install() -> Path:
    """Return the folder of VS Code's editor core, installed if it is not there yet."""
    BUILD.mkdir(parents=True, exist_ok=True)
    npm = shutil.which("npm")
    if npm is None:
        missing("npm is not installed")
    lock = (HERE / "package-lock.json").read_text()
    with (BUILD / "lock").open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        stamp = BUILD / "installed"
        if not stamp.exists() or stamp.read_text() != lock:
            for name in ("package.json", "package-lock.json"):
                shutil.copy(HERE / name, BUILD / name)
            command = [npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund"]
            subprocess.run(command, cwd=BUILD, check=True, capture_output=True, timeout=300)
            stamp.write_text(lock)
    return BUILD / "node_modules" / "monaco-editor" / "min"


def editor_options(**more: Any) -> dict[str, Any]:
    """Return the editor's options that VS Code and the extension's defaults come to.

    What Enter does to an open list is as VS Code ships it, whatever the extension sets.
    """
    manifest = json.loads((ROOT / "vscode-extension" / "package.json").read_text())
    defaults = manifest["contributes"]["configurationDefaults"]["[kinematics-dsl]"]
    options: dict[str, Any] = {}
    for name, value in defaults.items():
        *groups, last = name.removeprefix("editor.").split(".")
        level = options
        for group in groups:
            level = level.setdefault(group, {})
        level[last] = value
    return {"autoIndent": "full", **options, "acceptSuggestionOnEnter": "on", **_STILL, **more}


@contextmanager
def editor(browser: Browser, text: str = "", **options: Any) -> Iterator[Page]:
    """Open a page with the editor on a document, its cursor at the start."""
    folder = install()
    configuration = json.loads((ROOT / "grammar" / "language-configuration.json").read_text())
    with running_server() as server:
        announced = server.initialize(CAPABILITIES)["capabilities"]
        page = browser.new_page(viewport={"width": 700, "height": 400})
        page.set_default_timeout(TIMEOUT)
        page.route(f"{_ADDRESS}/**", lambda route: _serve(route, folder))
        page.expose_function("askServer", lambda method, params: _ask(server, method, params))
        page.expose_function("tellServer", lambda method, params: _tell(server, method, params))
        page.goto(f"{_ADDRESS}/page.html", wait_until="load")
        page.wait_for_function("window.typist !== undefined")
        page.evaluate(
            "options => typist.start(options)",
            {
                "configuration": configuration,
                "triggerCharacters": announced["completionProvider"]["triggerCharacters"],
                "options": editor_options(**options),
                "initialText": text,
            },
        )
        try:
            yield page
        finally:
            page.close()


class Seen(NamedTuple):
    """What a person sees.

    Attributes:
        text: The document.
        offset: Where the cursor is.
        line: The cursor's line, from 0.
        labels: The open list, empty if none is open.
        chosen: Its chosen item.
    """

    text: str
    offset: int
    line: int
    labels: tuple[str, ...]
    chosen: str


def settled(page: Page) -> Seen:
    """Return what is seen once the editor has come to rest after the keys so far."""
    found = page.evaluate("typist.settle().then(typist.seen)")
    return Seen(**{**found, "labels": tuple(found["labels"])})


def type_keys(page: Page, text: str, delay: float) -> None:
    """Type a text, with milliseconds between two keys; 0: each as soon as the list has come."""
    if delay:
        page.keyboard.type(text, delay=delay)
    else:
        page.evaluate("text => typist.type(text)", text)


def hurry(page: Page, lines: list[str]) -> None:
    """Type lines and Enter too fast for any list; a brace that is closed is stepped over."""
    page.evaluate("lines => lines.forEach(typist.hurry)", lines)


def put(page: Page, text: str, offset: int | None = None) -> None:
    """Replace the document, the cursor at an offset or at the end."""
    page.evaluate(
        "([text, offset]) => typist.put(text, offset)",
        [text, len(text) if offset is None else offset],
    )


def _ask(server: RawClient, method: str, params: str) -> str:
    """Hand a question on; texts cross between browser and Python many times faster than objects."""
    return json.dumps(server.request(method, json.loads(params)))


def _tell(server: RawClient, method: str, params: str) -> None:
    server.notify(method, json.loads(params))


def _serve(route: Route, folder: Path) -> None:
    path = route.request.url.removeprefix(_ADDRESS)
    file = (
        folder / path.removeprefix("/monaco/") if path.startswith("/monaco/") else HERE / path[1:]
    )
    if file.is_file():
        route.fulfill(path=file, content_type=_TYPES.get(file.suffix))
    else:
        route.fulfill(status=404)
