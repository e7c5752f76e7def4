"""A long random session: edits, requests, cancellations, undo storms, closed and reopened files.

    python benchmarks/soak.py [--edits 100000] [--documents 20] [--seed 1] [--prefixes]

No request may be answered with an error, no document may look otherwise than in a fresh server,
and the memory must come back when all is closed. With `--prefixes`, every prefix of each example
is asked every kind of request instead.
"""

import argparse
import random
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from benchmarks.lsp import resident_megabytes, robot  # noqa: E402
from tests.support.lsp import RawClient, StrictClient, ready_client  # noqa: E402
from tests.support.lsp_requests import every_request, place_of  # noqa: E402
from tests.support.walkers import walker  # noqa: E402

CANCELLED = -32800
MEMORY_BACK = 1.2
CLIENT = {
    "general": {"positionEncodings": ["utf-32"]},
    "textDocument": {
        "documentSymbol": {"hierarchicalDocumentSymbolSupport": True},
        "completion": {"completionItem": {"snippetSupport": True}},
    },
}
SETTINGS = {"kindsl": {"diagnostics": {"delay": 1}}}
PIECES = (
    "{", "}", "(", ")", ",", "=", "<", ">", "\n", " ", "0", "1.0", "-", "PI/2.0", "PI", "x",
    "m[1.0]", "link ", "link z {\n    id = 9\n}\n", "r_joint ", "via ", "children {", "// note\n",
    "/*", "*/", "mass = ", "Ix = 0.1\n", "frames {", "ref_frame {", "é", "🤖", "\u2028", "\t",
    "^link", "id = 2",
)  # fmt: skip


class Shown:
    """A document as the editor shows it, with what undoes each edit."""

    def __init__(self, uri: str, text: str) -> None:
        self.uri = uri
        self.text = text
        self.version = 1
        self.undo: list[tuple[int, int, str]] = []

    def replace(self, start: int, end: int, new: str) -> dict[str, Any]:
        """Change the text; return the change as the protocol has it."""
        change = {
            "range": {"start": place_of(self.text, start), "end": place_of(self.text, end)},
            "text": new,
        }
        self.text = self.text[:start] + new + self.text[end:]
        return change


class Session:
    """One client with many documents, and what it noticed."""

    def __init__(self, client: RawClient, seed: int, documents: int) -> None:
        self.client = client
        self.random = random.Random(seed)
        self.waiting: dict[int, str] = {}
        self.cancelled: set[int] = set()
        self.errors: list[str] = []
        self.answers = 0
        self.documents = [
            Shown(f"untitled:{number}", text)
            for number, text in zip(range(documents), self._texts(), strict=False)
        ]

    def open_all(self) -> None:
        for shown in self.documents:
            self.client.open(shown.uri, shown.text, shown.version)

    def close_all(self) -> None:
        for shown in self.documents:
            self.client.close(shown.uri)

    def step(self) -> None:
        """Do what someone, or something, might do next."""
        shown = self.random.choice(self.documents)
        kind = self.random.random()
        if kind < 0.90:
            self._edit(shown)
        elif kind < 0.97:
            self._undo(shown, self.random.randrange(1, 30))
        else:
            self._reopen(shown)
        if self.random.random() < 0.5:
            self._ask(shown)
        self._cancel()
        if len(self.waiting) > 40:
            self.settle()

    def settle(self) -> None:
        """Wait for all answers and look at them."""
        for msg_id, method in self.waiting.items():
            answer = self.client.answer(msg_id)
            self.answers += 1
            code = answer.get("error", {}).get("code")
            if code is not None and not (code == CANCELLED and msg_id in self.cancelled):
                self.errors.append(f"{method}: {answer['error']}")
        self.waiting.clear()
        self.cancelled.clear()
        self.client.messages.clear()

    def differences(self) -> Iterator[str]:
        """Yield what is wrong with documents, and where a fresh server sees them otherwise."""
        self.settle()
        with ready_client(CLIENT, initializationOptions=SETTINGS) as fresh:
            for shown in self.documents:
                fresh.open(shown.uri, shown.text)
                ours, other = looks(self.client, shown.uri), looks(fresh, shown.uri)
                if ours != other:
                    yield f"{shown.uri} looks otherwise"
                yield from (str(each["error"]) for each in ours if "error" in each)

    def _texts(self) -> Iterator[str]:
        examples = sorted((ROOT / "examples").glob("*.kindsl"))
        texts = [path.read_text(encoding="utf-8") for path in examples] + [robot(12), robot(60), ""]
        texts += [walker(self.random) for _ in range(3)]
        while True:
            yield self.random.choice(texts)

    def _edit(self, shown: Shown) -> None:
        """Make one to three changes in one notification, each after the one before."""
        changes = []
        for _ in range(self.random.choice((1, 1, 1, 2, 3))):
            start = self.random.randrange(len(shown.text) + 1)
            end = min(len(shown.text), start + self.random.choice((0, 0, 0, 1, 1, 4, 40)))
            new = self.random.choice((*PIECES, ""))
            shown.undo.append((start, start + len(new), shown.text[start:end]))
            changes.append(shown.replace(start, end, new))
        del shown.undo[:-100]
        self._send(shown, *changes)

    def _undo(self, shown: Shown, times: int) -> None:
        """Take edits back one by one, as fast as a held key."""
        for _ in range(min(times, len(shown.undo))):
            self._send(shown, shown.replace(*shown.undo.pop()))

    def _reopen(self, shown: Shown) -> None:
        self.client.close(shown.uri)
        self._ask(shown)
        shown.version += 1
        self.client.open(shown.uri, shown.text, shown.version)

    def _send(self, shown: Shown, *changes: dict[str, Any]) -> None:
        shown.version += 1
        self.client.change(shown.uri, shown.version, *changes)

    def _ask(self, shown: Shown) -> None:
        place = place_of(shown.text, self.random.randrange(len(shown.text) + 1))
        method, params = self.random.choice(list(every_request(shown.uri, place)))
        self.waiting[self.client.start(method, params)] = method

    def _cancel(self) -> None:
        if self.waiting and self.random.random() < 0.1:
            msg_id = self.random.choice(list(self.waiting))
            self.cancelled.add(msg_id)
            self.client.notify("$/cancelRequest", {"id": msg_id})


def looks(client: RawClient, uri: str) -> tuple[Any, ...]:
    """Return what does not depend on the server's memory; where there is none, the error."""
    document = {"textDocument": {"uri": uri}}
    methods = ("diagnostic", "documentSymbol", "foldingRange", "semanticTokens/full", "codeLens")
    answers = [
        client.answer(client.start(f"textDocument/{method}", document)) for method in methods
    ]
    for answer in answers:
        answer.pop("id")
        if isinstance(answer.get("result"), dict):
            answer["result"].pop("resultId", None)
    return tuple(answers)


@contextmanager
def own_server() -> Iterator[RawClient]:
    """A server as editors start it: it shares no memory with another process."""
    client = StrictClient()
    try:
        client.initialize(CLIENT, initializationOptions=SETTINGS)
        yield client
    finally:
        client.kill()


def soak(edits: int, documents: int, seed: int, checks: int = 10) -> list[str]:
    """Return all that went wrong in a session; tell on the way how it goes."""
    begin = time.perf_counter()
    with own_server() as client:
        session = Session(client, seed, documents)
        start = _memory_after_a_first_session(session, edits // 10)
        session.open_all()
        problems: list[str] = []
        for number in range(1, edits + 1):
            session.step()
            if number % max(edits // checks, 1) == 0:
                problems += [f"edit {number}: {what}" for what in session.differences()]
                took = time.perf_counter() - begin
                memory = resident_megabytes(client.process.pid)
                print(f"{number} edits, {session.answers} answers, {took:.0f} s, {memory:.0f} MB,"
                      f" {len(problems) + len(session.errors)} problems", flush=True)  # fmt: skip
        session.settle()
        session.close_all()
        _let_go(client)
        end = resident_megabytes(client.process.pid)
        print(f"memory: {start:.0f} MB before, {end:.0f} MB after all was closed")
        if end > MEMORY_BACK * start:
            problems.append(f"memory did not come back: {end:.0f} MB after {start:.0f} MB")
        log = [line for line in client.stderr.splitlines() if "ERROR" in line]
        return problems + session.errors + log


def _memory_after_a_first_session(session: Session, edits: int) -> float:
    """Load what is loaded on demand, and fill what is kept within bounds for all documents."""
    client = session.client
    session.open_all()
    for shown in session.documents:
        looks(client, shown.uri)
        for method, params in every_request(shown.uri, place_of(shown.text, len(shown.text) // 2)):
            client.answer(client.start(method, params))
    for _ in range(edits):
        session.step()
    session.settle()
    session.close_all()
    _let_go(client)
    return resident_megabytes(client.process.pid)


def _let_go(client: RawClient) -> None:
    """Wait until the server has nothing left to do."""
    client.drain()
    time.sleep(1.5)
    client.drain()


def all_prefixes() -> list[str]:
    """Return the requests that failed on a prefix of an example."""
    problems = []
    with ready_client(CLIENT) as client:
        for example in sorted((ROOT / "examples").glob("*.kindsl")):
            text = example.read_text(encoding="utf-8")
            client.open("untitled:prefix", "")
            for end in range(len(text) + 1):
                client.change("untitled:prefix", end + 2, {"text": text[:end]})
                requests = every_request("untitled:prefix", place_of(text, end))
                asked = {client.start(method, params): method for method, params in requests}
                for msg_id, method in asked.items():
                    if "error" in client.answer(msg_id):
                        problems.append(f"{method} on the first {end} characters of {example.name}")
                client.messages.clear()
            client.close("untitled:prefix")
            print(f"{example.name}: {len(text) + 1} prefixes, {len(problems)} problems", flush=True)
    return problems


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--edits", type=int, default=100_000)
    parser.add_argument("--documents", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--prefixes", action="store_true")
    options = parser.parse_args()
    if options.prefixes:
        problems = all_prefixes()
    else:
        problems = soak(options.edits, options.documents, options.seed)
    for problem in problems[:50]:
        print(problem)
    return int(bool(problems))


if __name__ == "__main__":
    sys.exit(main())
