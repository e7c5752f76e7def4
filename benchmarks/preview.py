"""What the live preview costs, beside the language server's own work in the same run.

    python benchmarks/preview.py [--quick]

The real server over stdio, and a page's websocket without a page: a digit of a joint's place is
typed; the clock runs to the published diagnostics, and to the last frame of the change. Diagnostics
wait until typing rests, by default 0.1 s; the frame does not.
"""

import argparse
import asyncio
import json
import statistics
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

import umsgpack
from tornado.websocket import WebSocketClientConnection, websocket_connect

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.support.lsp import RawClient  # noqa: E402
from tests.support.models import Style, random_model  # noqa: E402

URI = "untitled:robot"
NO_DELAY = {"kindsl": {"diagnostics": {"delay": 0}}}
DEFAULT_DELAY: dict[str, Any] = {}
QUIET = 0.05  # seconds without a frame: the change has been sent
MOST_TIMES = {"none": 2.0, "default": 0.5}
MOST_BYTES = 5_000
MOST_GROWTH = 1.1


class Frame(NamedTuple):
    """A change as it came in."""

    time: float
    size: int
    parts: list[dict[str, Any]]


class Line:
    """A tab's websocket, read by a thread of its own."""

    def __init__(self, url: str) -> None:
        self.frames: list[Frame] = []
        self._url = url.replace("http:", "ws:").replace("/?", "/live?")
        self._loop = asyncio.new_event_loop()
        self._connection: WebSocketClientConnection | None = None
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()
        self.wait_for("status")

    def wait_for(self, kind: str, after: float = 0.0) -> Frame:
        """Return the first frame with a part of a kind after a time."""
        deadline = time.perf_counter() + 30.0
        while time.perf_counter() < deadline:
            for frame in list(self.frames):
                if frame.time >= after and any(part["type"] == kind for part in frame.parts):
                    return frame
            time.sleep(0.0005)
        raise TimeoutError(f"no frame '{kind}' has come")

    def settle(self) -> None:
        """Wait until no frame has come for a while."""
        count = -1
        while count != len(self.frames):
            count = len(self.frames)
            time.sleep(QUIET)

    def send(self, message: dict[str, Any]) -> None:
        """Say something as the page would."""
        assert self._connection is not None
        self._loop.call_soon_threadsafe(self._connection.write_message, json.dumps(message))

    def close(self) -> None:
        if self._connection is not None:
            self._loop.call_soon_threadsafe(self._connection.close)
        self._thread.join(5.0)

    def _run(self) -> None:
        with suppress(asyncio.CancelledError):
            self._loop.run_until_complete(self._read())
        self._loop.close()

    async def _read(self) -> None:
        self._connection = await websocket_connect(self._url)
        while (data := await self._connection.read_message()) is not None:
            parts = umsgpack.unpackb(data)["parts"]
            self.frames.append(Frame(time.perf_counter(), len(data), parts))


class Typing:
    """Types digits into a joint's place, as an editor would."""

    def __init__(self, text: str, settings: dict[str, Any] = NO_DELAY) -> None:
        self.client = RawClient()
        self.client.initialize(initializationOptions=settings)
        self.client.open(URI, text)
        self.client.diagnostics(URI)
        command = {"command": "kindsl.preview", "arguments": [URI]}
        self.url = self.client.request("workspace/executeCommand", command)["url"]
        before = text.partition("_joint ")[0]
        place = text.index("translation = (", len(before)) + len("translation = (")
        place = text.index(".", place) + 1
        self._line = text.count("\n", 0, place)
        self._column = place - text.rfind("\n", 0, place) - 1
        self._version = 1

    def digit(self) -> tuple[float, float]:
        """Change a digit; return when it was sent and when the diagnostics came."""
        self._version += 1
        position = {"line": self._line, "character": self._column}
        end = {"line": self._line, "character": self._column + 1}
        change = {"range": {"start": position, "end": end}, "text": str(self._version % 9 + 1)}
        sent = time.perf_counter()
        self.client.change(URI, self._version, change)
        self.client.diagnostics(URI)
        return sent, time.perf_counter()

    def memory(self) -> float:
        """Return the server's resident memory, MB."""
        status = Path(f"/proc/{self.client.process.pid}/status").read_text()
        return float(status.partition("VmRSS:")[2].split()[0]) / 1e3

    def close(self) -> None:
        self.client.kill()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer rounds")
    is_quick = parser.parse_args().quick
    quadruped = (ROOT / "examples" / "quadruped.kindsl").read_text()
    long = random_model(200, 3, Style(has_expressions=False))
    results = [
        keystrokes(quadruped, 20 if is_quick else 100, "none", NO_DELAY),
        keystrokes(quadruped, 20 if is_quick else 100, "default", DEFAULT_DELAY),
        sizes(long, 5 if is_quick else 20),
        thousand_edits(quadruped, 200 if is_quick else 1000),
    ]
    return int(not all(results))


def keystrokes(text: str, rounds: int, delay: str, settings: dict[str, Any]) -> bool:
    """Compare the last frame of a change with the diagnostics of the same change."""
    typing = Typing(text, settings)
    line = Line(typing.url)
    findings, frames = [], []
    for _ in range(rounds):
        sent, answered = typing.digit()
        line.wait_for("joint", sent)
        line.settle()
        findings.append(answered - sent)
        frames.append(line.frames[-1].time - sent)
    line.close()
    typing.close()
    ours, other = statistics.median(frames) * 1e3, statistics.median(findings) * 1e3
    name = f"keystroke to last frame, to diagnostics ({delay} delay)"
    return tell(name, ours, other, MOST_TIMES[delay])


def sizes(text: str, rounds: int) -> bool:
    """Weigh what a digit of a 200-link robot sends."""
    typing = Typing(text)
    line = Line(typing.url)
    weights = []
    for _ in range(rounds):
        first = len(line.frames)
        sent, _ = typing.digit()
        line.wait_for("joint", sent)
        line.settle()
        weights.append(sum(frame.size for frame in line.frames[first:]))
    line.close()
    typing.close()
    whole = sum(frame.size for frame in line.frames[:first])
    is_good = max(weights) < MOST_BYTES
    print(f"a digit of 200 links sends at most {max(weights)} bytes "
          f"(limit {MOST_BYTES}, the whole robot {whole}) {verdict(is_good)}")  # fmt: skip
    return is_good


def thousand_edits(text: str, edits: int) -> bool:
    """See that memory stays flat, and that a new tab gets one value per property."""
    typing = Typing(text)
    line = Line(typing.url)
    for _ in range(edits // 4):
        typing.digit()
    before = typing.memory()
    for _ in range(edits):
        typing.digit()
    line.settle()
    grown = tell(f"memory after {edits} edits, before", typing.memory(), before, MOST_GROWTH, "MB")
    fresh = Line(typing.url)
    keys = [(part["path"], part["type"]) for f in fresh.frames for part in f.parts]
    is_single = len(keys) == len(set(keys))
    print(f"a new tab gets {len(keys)} parts, one per property {verdict(is_single)}")
    for open_line in (line, fresh):
        open_line.close()
    typing.close()
    return grown and is_single


def tell(name: str, ours: float, other: float, limit: float, unit: str = "ms") -> bool:
    is_good = ours <= limit * other
    figures = f"{ours:8.2f} {other:8.2f} {unit} {ours / other:6.2f} x (limit {limit:g})"
    print(f"{name:52} {figures} {verdict(is_good)}", flush=True)
    return is_good


def verdict(is_good: bool) -> str:
    return "ok" if is_good else "TOO MUCH"


if __name__ == "__main__":
    sys.exit(main())
