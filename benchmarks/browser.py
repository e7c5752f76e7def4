"""What the server costs in a browser's tab, beside bare Pyodide and the server on the machine.

    python benchmarks/browser.py [--quick]

Headless Chromium on the loopback interface. First diagnostics after a cold start (nothing cached)
and a warm one, of the package's sources, of its compiled zip and of the memory image; then a digit
typed and the last message to the preview's page, against the same over stdio and a websocket.
"""

import argparse
import json
import statistics
import sys
import tempfile
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, BrowserContext

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks")]

from tests.vscode.browser import chromium  # noqa: E402
from tests.web import site  # noqa: E402

from preview import Line, Typing, tell  # noqa: E402

WAYS = ("bare", "sources", "zips", "image")
IMAGE_PER_SOURCES = 0.4
WARM_PER_BARE = 1.0
EDIT_PER_NATIVE = 3.0

PAGE = """<!DOCTYPE html><title>benchmark</title><script>
"use strict";
const URI = "file:///robot.kindsl";
let worker, seen;

function wait(wanted) {
  return new Promise((resolve) => { seen = (data) => wanted(data) && resolve(data); });
}

function notify(method, params) { worker.postMessage({ jsonrpc: "2.0", method, params }); }

async function start(way, text) {
  const begin = performance.now();
  if (way === "bare") {
    worker = new Worker("bare.js");
    await new Promise((resolve) => { worker.onmessage = resolve; });
    return performance.now() - begin;
  }
  worker = new Worker("server/worker.js");
  worker.onmessage = ({ data }) => seen && seen(data);
  const base = new URL(way === "sources" ? "sources/" : "server/", location.href).href;
  worker.postMessage({ base, useImage: way === "image" });
  worker.postMessage({ jsonrpc: "2.0", id: 1, method: "initialize", params: { processId: null, rootUri: null, capabilities: {} } });
  notify("initialized", {});
  notify("textDocument/didOpen", { textDocument: { uri: URI, languageId: "kinematics-dsl", version: 1, text } });
  await wait(({ method }) => method === "textDocument/publishDiagnostics");
  return performance.now() - begin;
}

async function show() {
  worker.postMessage({ jsonrpc: "2.0", id: 2, method: "workspace/executeCommand", params: { command: "kindsl.preview", arguments: [URI] } });
  const { result } = await wait(({ id }) => id === 2);
  notify("kindsl/previewRequest", { document: result.url, request: { type: "hello", joints: {}, parameters: {} } });
  await wait(({ method, params }) => method === "kindsl/previewMessages" && params.messages.some(({ is_whole: isWhole }) => isWhole));
}

async function digit(line, character, version) {
  const range = { start: { line, character }, end: { line, character: character + 1 } };
  const begin = performance.now();
  notify("textDocument/didChange", { textDocument: { uri: URI, version }, contentChanges: [{ range, text: String(version % 9 + 1) }] });
  await wait(({ method, params }) => method === "kindsl/previewMessages" && params.messages.some(({ type }) => type === "joint"));
  const drawn = performance.now() - begin;
  await new Promise((resolve) => setTimeout(resolve, 400));
  return drawn;
}
</script>"""  # noqa: E501
BARE = """importScripts("sources/pyodide.js");
const base = new URL("sources/", location.href).href;
loadPyodide({ indexURL: base }).then((py) => postMessage(py.runPython("1 + 1")));
"""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer rounds")
    rounds = 1 if parser.parse_args().quick else 5
    text = (ROOT / "examples" / "quadruped.kindsl").read_text()
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        gather(Path(folder), site.build())
        with site.served(Path(folder)) as address:
            results = starts(browser, address, text, rounds)
            results.append(edits(browser, address, text, 10 * rounds))
    return int(not all(results))


def gather(folder: Path, playground: Path) -> None:
    """Put the page, the server, and the server as plain sources, into one folder."""
    (folder / "index.html").write_text(PAGE)
    (folder / "bare.js").write_text(BARE)
    (folder / "server").symlink_to(playground / "server")
    sources = folder / "sources"
    sources.mkdir()
    pyodide = site.WEB / "node_modules" / "pyodide"
    for name in ("pyodide.js", "pyodide.asm.js", "pyodide.asm.wasm", "python_stdlib.zip"):
        (sources / name).symlink_to(pyodide / name)
    (sources / "pyodide-lock.json").symlink_to(playground / "server" / "pyodide-lock.json")
    root = site.WEB / "build" / "site"
    with zipfile.ZipFile(sources / "site.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        for file in sorted(root.rglob("*.py")):
            archive.write(file, file.relative_to(root))


def starts(browser: Browser, address: str, text: str, rounds: int) -> list[bool]:
    """Compare the ways to start, each cold and then warm, in turns."""
    times: dict[tuple[str, str], list[float]] = {}
    for _ in range(rounds):
        for way in WAYS:
            with fresh_context(browser) as context:
                for state in ("cold", "warm", "warm"):
                    times.setdefault((way, state), []).append(started(context, address, way, text))
    medians = {key: statistics.median(values) for key, values in times.items()}
    for (way, state), value in sorted(medians.items()):
        print(f"{way:8} {state}: {value:8.0f} ms", flush=True)
    cold = {way: medians[way, "cold"] for way in WAYS}
    warm = {way: medians[way, "warm"] for way in WAYS}
    return [
        tell("cold: image, sources", cold["image"], cold["sources"], IMAGE_PER_SOURCES),
        tell("warm: image, bare Pyodide", warm["image"], warm["bare"], WARM_PER_BARE),
    ]


@contextmanager
def fresh_context(browser: Browser) -> Iterator[BrowserContext]:
    context = browser.new_context()
    yield context
    context.close()


def started(context: BrowserContext, address: str, way: str, text: str) -> float:
    page = context.new_page()
    page.goto(address)
    time = float(page.evaluate("([way, text]) => start(way, text)", [way, text]))
    page.close()
    return time


def edits(browser: Browser, address: str, text: str, count: int) -> bool:
    """Compare a digit typed in the tab with the same over stdio and a websocket."""
    before = text.partition("_joint ")[0]
    place = text.index("translation = (", len(before)) + len("translation = (")
    place = text.index(".", place) + 1
    line, column = text.count("\n", 0, place), place - text.rfind("\n", 0, place) - 1
    page = browser.new_page()
    page.goto(address)
    page.evaluate("([way, text]) => start(way, text)", ["image", text])
    page.evaluate("() => show()")
    web: list[Any] = [
        page.evaluate(f"() => digit({json.dumps(line)}, {json.dumps(column)}, {version})")
        for version in range(2, count + 2)
    ]
    page.close()
    typing = Typing(text, {})
    socket = Line(typing.url)
    native = []
    for _ in range(count):
        sent, _ = typing.digit()
        native.append(1e3 * (socket.wait_for("joint", sent).time - sent))
        socket.settle()
    socket.close()
    typing.close()
    drawn = statistics.median(web), statistics.median(native)
    return tell("digit to picture: in the tab, on the machine", *drawn, EDIT_PER_NATIVE)


if __name__ == "__main__":
    raise SystemExit(main())
