"""The language server with handlers that misbehave, to see what reaches the client."""

import asyncio
import sys
import threading

from kindsl.frontends.lsp.run import serve_stdio
from kindsl.frontends.lsp.server import KindslLanguageServer
from kindsl.frontends.lsp.session import progress as progress_module
from kindsl.frontends.lsp.session.progress import Progress


class Clock:
    """What it takes for scans: the time that they say."""

    now = 0.0

    def monotonic(self) -> float:
        return self.now


server = KindslLanguageServer()
ran: list[int] = []
may_go_on = threading.Semaphore(0)
progress_module.time = clock = Clock()  # type: ignore[assignment]


@server.feature("test/print")
def print_something(*_: object) -> str:
    print("Content-Length: 3\r\n\r\nxyz", flush=True)
    return "printed"


@server.feature("test/fail")
def fail(*_: object) -> None:
    raise ZeroDivisionError("first line\nsecond line")


@server.feature("test/failLater")
async def fail_later(*_: object) -> None:
    await asyncio.sleep(0)
    raise KeyError("later")


@server.feature("test/notJson")
def answer_no_json(*_: object) -> float:
    return float("nan")


@server.feature("test/wait")
async def wait(*_: object) -> None:
    await asyncio.sleep(60)


@server.feature("test/busy")
async def keep_the_worker_busy(*_: object) -> None:
    await server.session.worker.run(may_go_on.acquire)


@server.feature("test/goOn")
async def let_the_worker_go_on(jobs: int) -> None:
    may_go_on.release(jobs)


@server.feature("test/scan")
async def scan(seconds: float) -> None:
    async with Progress(server.session, "Scanning", None) as progress:
        for done in range(4):
            await progress.report(done, 4)
            clock.now += seconds / 4


@server.feature("test/mark")
async def mark(number: int) -> None:
    ran.append(number)


@server.feature("test/markInWorker")
async def mark_in_worker(number: int) -> None:
    await server.session.worker.run(lambda: ran.append(number))


@server.feature("test/marks")
async def marks(*_: object) -> list[int]:
    return ran


@server.command("test.fail")
def fail_as_command(*_: object) -> None:
    raise ZeroDivisionError("command")


sys.exit(asyncio.run(serve_stdio(server)))
