"""What the language server costs, as ratios against a trivial pygls server in the same run.

    python benchmarks/lsp.py [--quick]

The trivial server is pygls as it comes: one hover that answers a constant, one check that looks
for a word. Each figure is the median of alternating rounds, so that both see the same machine; a
change is measured by the processor time of all threads, which others on the machine change little.
"""

import argparse
import statistics
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tests.support.lsp import SERVER, RawClient

TRIVIAL = (sys.executable, __file__, "--trivial-server")
# What `make vsix` has built.
BUILT_IN_HOST = Path(__file__).resolve().parents[1] / "vscode-extension" / "server" / "host.js"
URI = "untitled:robot"
_FIRST = 10
# By the number of links: the goals; 10,000 no slower than before rules declared what they read.
MOST_CHANGES = {12: 2.4, 1000: 3.0, 10_000: 7.0}
NO_DELAY = {"kindsl": {"diagnostics": {"delay": 0}}}


class Figure(NamedTuple):
    """A measured ratio and what it may be."""

    name: str
    ours: float
    other: float
    limit: float
    unit: str = "ms"

    @property
    def ratio(self) -> float:
        return self.ours / self.other

    def __str__(self) -> str:
        verdict = "ok" if self.ratio <= self.limit else "TOO MUCH"
        values = f"{self.ours:9.2f} {self.other:9.2f} {self.unit}"
        return f"{self.name:58} {values} {self.ratio:7.2f} x (limit {self.limit:g}) {verdict}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer rounds, no 10,000 links")
    parser.add_argument("--trivial-server", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.trivial_server:
        serve_trivially()
        return 0
    too_much = False
    print(f"{'':58} {'ours':>9} {'other':>9}")
    for figure in figures(options.quick):
        print(figure, flush=True)
        too_much |= figure.ratio > figure.limit
    return int(too_much)


def figures(is_quick: bool) -> Iterator[Figure]:
    rounds = 5 if is_quick else 15
    ours, trivial = alternating(rounds, lambda: starting(SERVER), lambda: starting(TRIVIAL))
    yield Figure("process start to initialize result", ours, trivial, 1.25)
    if BUILT_IN_HOST.exists():
        yield from built_in(rounds)
    sizes = (12, 1000) if is_quick else (12, 1000, 10_000)
    changes: dict[int, float] = {}
    completions: dict[int, float] = {}
    for links in sizes:
        text = robot(links)
        with ready(SERVER, text) as kindsl, ready(TRIVIAL, text) as other:
            if links == 12:
                yield Figure(
                    "hover on a link, 12 links", *answering(kindsl, other, text, 40 * rounds), 1.5
                )
            changes[links], trivial = changing(kindsl, other, text, rounds)
            name = f"didChange to published diagnostics, processor time, {links} links"
            yield Figure(name, changes[links], trivial, MOST_CHANGES[links])
            completions[links] = completing(kindsl, text, 8 * rounds)
            if links == 10_000:
                memory = resident_megabytes(kindsl.process.pid)
                yield Figure("memory, 10,000 links, against 400 MB", memory, 400, 1.0, "MB")
    yield Figure("completion p95, 1,000 against 12 links", completions[1000], completions[12], 3.0)
    if not is_quick:
        yield Figure("didChange, ten times the links against 10 x", *growing(rounds), 1.0)
        for what, most, (taken, reading, hover) in zip(
            ("symbols", "symbols again", "findings"), (20, 10, 2000), searching(2000), strict=True
        ):
            yield Figure(f"{what} of 2,000 robots against reading", taken, reading, most, "s")
            yield Figure("hover p95 meanwhile, against 50 ms", hover, 50, 1.0)


def searching(robots: int) -> Iterator[tuple[float, float, float]]:
    """Yield how long questions about a folder take, and reading it, in seconds; hovers meanwhile.

    The questions are a search for symbols, the same again, and the findings of all files.
    """
    text = robot(12)
    with TemporaryDirectory() as name:
        folder = Path(name)
        for number in range(robots):
            (folder / f"{number}.kindsl").write_text(text.replace("link_7", f"link_7_{number}"))
        with ready(SERVER, text, {"uri": folder.as_uri(), "name": "robots"}) as client:
            search = "workspace/symbol", {"query": f"link_7_{robots - 1}"}
            pull = "workspace/diagnostic", dict[str, Any](previousResultIds=[])
            for method, params in (search, search, pull):
                begin = time.perf_counter()
                for file in folder.iterdir():
                    file.read_bytes()
                reading = milliseconds(begin) / 1e3
                begin = time.perf_counter()
                question = client.start(method, params)
                hovers = [hover(client, text)]
                while not any(message.get("id") == question for message in client.messages):
                    hovers.append(hover(client, text))
                    time.sleep(0.01)
                taken = milliseconds(begin) / 1e3
                yield taken, reading, sorted(hovers)[int(0.95 * len(hovers))]


def growing(rounds: int) -> tuple[float, float]:
    """Return a change's time at 10,000 links, and ten times that at 1,000, taking turns."""
    texts = robot(10_000), robot(1000)
    with ready(SERVER, texts[0]) as large, ready(SERVER, texts[1]) as small:
        changes = Changes(large, texts[0]), Changes(small, texts[1])
        ours, other = alternating(rounds, changes[0].make, changes[1].make)
    return ours, 10 * other


def alternating(
    rounds: int, one: Callable[[], float], other: Callable[[], float]
) -> tuple[float, float]:
    """Return the medians of two measurements that take turns."""
    pairs = [(one(), other()) for _ in range(rounds)]
    return statistics.median(a for a, _ in pairs), statistics.median(b for _, b in pairs)


def starting(command: tuple[str, ...]) -> float:
    begin = time.perf_counter()
    client = RawClient(command)
    client.request("initialize", {"processId": None, "rootUri": None, "capabilities": {}})
    took = milliseconds(begin)
    client.kill()
    return took


def built_in(rounds: int) -> Iterator[Figure]:
    """Yield what the server takes that the extension brings, beside that of a Python here."""
    command = ("node", "--disallow-code-generation-from-strings", str(BUILT_IN_HOST))
    text = robot(12)
    ours, other = alternating(rounds, lambda: opening(command, text), lambda: opening(SERVER, text))
    yield Figure("built-in Python: start to diagnostics", ours, other, 3.0)
    with ready(command, text) as client:
        memory = resident_megabytes(client.process.pid)
        yield Figure("built-in Python: memory, against 250 MB", memory, 250, 1.0, "MB")


def opening(command: tuple[str, ...], text: str) -> float:
    begin = time.perf_counter()
    with ready(command, text):
        return milliseconds(begin)


def answering(kindsl: RawClient, other: RawClient, text: str, rounds: int) -> tuple[float, float]:
    return alternating(rounds, lambda: hover(kindsl, text), lambda: hover(other, text))


def hover(client: RawClient, text: str) -> float:
    """Return how long a hover on a link takes."""
    position = place(text, text.index("link link_5 {") + 6)
    begin = time.perf_counter()
    assert client.request(
        "textDocument/hover", {"textDocument": {"uri": URI}, "position": position}
    )
    return milliseconds(begin)


class Changes:
    """Turns one digit in the middle, again and again."""

    def __init__(self, client: RawClient, text: str) -> None:
        self.client = client
        self.version = 1
        self.start = place(text, text.index("mass = ", len(text) // 2) + len("mass = "))
        self.make()

    def make(self) -> float:
        """Return the processor time until the diagnostics of the next version are there."""
        self.version += 1
        end = {**self.start, "character": self.start["character"] + 1}
        digit = {"range": {"start": self.start, "end": end}, "text": str(2 + self.version % 8)}
        begin = busy_milliseconds(self.client.process.pid)
        self.client.change(URI, self.version, digit)
        wait_for_version(self.client, self.version)
        return busy_milliseconds(self.client.process.pid) - begin


def changing(kindsl: RawClient, other: RawClient, text: str, rounds: int) -> tuple[float, float]:
    return alternating(rounds, Changes(kindsl, text).make, Changes(other, text).make)


def completing(kindsl: RawClient, text: str, rounds: int) -> float:
    """Return the 95th percentile of completions, each after a keystroke; the first load modules."""
    position = place(text, text.index("children {", len(text) // 2) + len("children {"))
    version, took = 10_000, []
    for count in range(rounds + _FIRST):
        version += 1
        span = {"start": position, "end": {**position, "character": position["character"]}}
        if count % 2:
            span["end"] = {**position, "character": position["character"] + 2}
        kindsl.change(URI, version, {"range": span, "text": "" if count % 2 else " l"})
        begin = time.perf_counter()
        where = {"textDocument": {"uri": URI}, "position": position}
        assert kindsl.request("textDocument/completion", where)
        took.append(milliseconds(begin))
        wait_for_version(kindsl, version)
    return sorted(took[_FIRST:])[int(0.95 * rounds)]


def wait_for_version(client: RawClient, version: int) -> None:
    client.wait(lambda message: message.get("params", {}).get("version") == version)


@contextmanager
def ready(command: tuple[str, ...], text: str, *folders: dict[str, str]) -> Iterator[RawClient]:
    client = RawClient(command)
    try:
        client.initialize(initializationOptions=NO_DELAY, workspaceFolders=list(folders) or None)
        client.open(URI, text)
        # Else the time would be that of telling findings, which the other server has none of.
        assert not client.diagnostics(URI)
        yield client
    finally:
        client.kill()


def robot(links: int) -> str:
    """Return a binary tree of links, twelve lines each."""
    children: dict[int, list[int]] = {}
    for number in range(1, links + 1):
        children.setdefault((number - 1) // 2, []).append(number)

    def child_list(parent: int) -> str:
        row = (f"        link_{c} via joint_{c}\n" for c in children.get(parent, []))
        return "    children {\n" + "".join(row) + "    }\n"

    base = f"RobotBase base {{\n{child_list(0)}}}\n"
    blocks = [
        f"link link_{n} {{\n    id = {n}\n    inertia_params {{\n"
        f"        mass = {2 + n % 8}.0 CoM = (0.01, 0.0, 0.1)\n"
        "        Ix = 0.4 Iy = 0.4 Iz = 0.1 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0\n    }\n"
        f"{child_list(n)}}}\n"
        for n in range(1, links + 1)
    ]
    joints = [
        f"r_joint joint_{n} {{\n    ref_frame {{\n        translation = (0.{n % 2}, 0.0, 0.3)\n"
        "        rotation = (PI/2.0, 0.0, 0.0)\n    }\n}\n"
        for n in range(1, links + 1)
    ]
    return "\n".join(("Robot Tree {", base, *blocks, *joints, "}\n"))


def place(text: str, offset: int) -> dict[str, int]:
    line = text.count("\n", 0, offset)
    return {"line": line, "character": offset - text.rfind("\n", 0, offset) - 1}


def resident_megabytes(process: int) -> float:
    for line in Path(f"/proc/{process}/status").read_text().splitlines():
        if line.startswith("VmRSS"):
            return int(line.split()[1]) / 1024
    raise OSError("the system does not tell a process' memory")


def busy_milliseconds(process: int) -> float:
    """Return the processor time that all threads of a process have had."""
    threads = Path(f"/proc/{process}/task").glob("*/schedstat")
    return sum(int(each.read_text().split()[0]) for each in threads) / 1e6


def milliseconds(begin: float) -> float:
    return 1e3 * (time.perf_counter() - begin)


def serve_trivially() -> None:
    from lsprotocol import types
    from pygls.lsp.server import LanguageServer

    server = LanguageServer("trivial", "1")

    @server.feature(types.TEXT_DOCUMENT_HOVER)
    def hover(_: types.HoverParams) -> types.Hover:
        return types.Hover("text")

    def check(ls: LanguageServer, params: Any) -> None:
        document = ls.workspace.get_text_document(params.text_document.uri)
        found = [
            types.Diagnostic(
                types.Range(types.Position(number, 0), types.Position(number, 4)), "left over"
            )
            for number, line in enumerate(document.lines)
            if "TODO" in line
        ]
        ls.text_document_publish_diagnostics(
            types.PublishDiagnosticsParams(document.uri, found, document.version)
        )

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def opened(ls: LanguageServer, params: types.DidOpenTextDocumentParams) -> None:
        check(ls, params)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(ls: LanguageServer, params: types.DidChangeTextDocumentParams) -> None:
        check(ls, params)

    server.start_io()


if __name__ == "__main__":
    sys.exit(main())
