"""Long work about closed files in processes of its own, so that nobody waits for it who types.

There are as many as processors, at a lower priority. They are started when there is something to
do, and end when their standard input does, so whenever the server ends.
"""

import asyncio
import contextlib
import itertools
import logging
import os
import pickle
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from functools import partial
from typing import IO, Any, Protocol, TypeVar, cast

from kindsl.frontends.lsp.session.worker import Urgency, Worker

T = TypeVar("T")

logger = logging.getLogger(__name__)

# Of nineteen steps of priority: answers to a typist go first on a machine that is busy.
_LESS_URGENT = 5


class Helper(Protocol):
    """Does long work."""

    async def run(self, job: Callable[..., T], *arguments: Any) -> T:
        """Await a job, a function of a module; cancelling gives up the answer."""

    def stop(self) -> None:
        """Do nothing more."""


class WorkerHelper:
    """Does long work in the worker, in slices: a job is short, and all others go before it."""

    def __init__(self, worker: Worker) -> None:
        self._worker = worker

    async def run(self, job: Callable[..., T], *arguments: Any) -> T:
        """Await a job."""
        return await self._worker.run(partial(job, *arguments), Urgency.BACKGROUND)

    def stop(self) -> None:
        """Leave the worker to others."""


class HelperProcesses:
    """Does long work in as many processes as there are processors, each job in the idlest."""

    def __init__(self, worker: Worker, number: int | None = None) -> None:
        self._processes = [HelperProcess(worker) for _ in range(number or os.cpu_count() or 1)]

    async def run(self, job: Callable[..., T], *arguments: Any) -> T:
        """Await a job."""
        idlest = min(self._processes, key=lambda each: each.n_waiting)
        return await idlest.run(job, *arguments)

    def stop(self) -> None:
        """End the processes; who still waits for an answer is cancelled."""
        for process in self._processes:
            process.stop()


class HelperProcess:
    """Does long work in a process of its own, or in the worker where there can be none.

    A process that ends unasked is replaced once.
    """

    def __init__(self, worker: Worker) -> None:
        self._instead = WorkerHelper(worker)
        self._numbers = itertools.count()
        self._waiting: dict[int, asyncio.Future[Any]] = {}
        self._requests: queue.SimpleQueue[bytes | None]
        self._process: subprocess.Popen[bytes] | None = None
        self._starts_left = 2

    @property
    def n_waiting(self) -> int:
        """Of how many jobs the answer is waited for."""
        return len(self._waiting)

    async def run(self, job: Callable[..., T], *arguments: Any) -> T:
        """Await a job; what it raises is raised here."""
        while self._process is not None or self._starts_left:
            number, loop = next(self._numbers), asyncio.get_running_loop()
            answer = self._waiting[number] = loop.create_future()
            try:
                if self._process is None:
                    self._start(loop)
                self._requests.put(pickle.dumps((number, job, arguments)))
                return cast(T, await answer)
            except _LostError:
                pass
            except OSError as error:
                logger.warning("no process for long work: %s", error)
                self._starts_left = 0
            finally:
                self._waiting.pop(number, None)
        return await self._instead.run(job, *arguments)

    def stop(self) -> None:
        """End the process; who still waits for an answer is cancelled."""
        self._starts_left = 0
        for answer in self._waiting.values():
            answer.cancel()
        if self._process is not None:
            self._process.kill()
            self._process = None
            self._requests.put(None)

    def _start(self, loop: asyncio.AbstractEventLoop) -> None:
        """Start the process, and a thread for each direction: a full pipe holds up no message.

        Raises:
            OSError: There can be none.
        """
        code = f"import sys; sys.path[:] = {sys.path!r}; from {__name__} import serve; serve()"
        pipe = subprocess.PIPE
        process = subprocess.Popen([sys.executable, "-c", code], stdin=pipe, stdout=pipe)
        self._process, self._requests = process, queue.SimpleQueue()
        self._starts_left -= 1
        for work in (
            partial(_write, self._requests, cast(IO[bytes], process.stdin)),
            partial(self._read, loop, process),
        ):
            threading.Thread(target=work, name="kindsl-helper", daemon=True).start()

    def _read(self, loop: asyncio.AbstractEventLoop, process: "subprocess.Popen[bytes]") -> None:
        """Pass answers on until the process, or the event loop, has ended."""
        with contextlib.suppress(RuntimeError), cast(IO[bytes], process.stdout) as answers:
            try:
                while True:
                    loop.call_soon_threadsafe(self._answer, *pickle.load(answers))
            except (EOFError, OSError, pickle.UnpicklingError):
                process.kill()
                loop.call_soon_threadsafe(self._lose, process, process.wait())

    def _answer(self, number: int, is_done: bool, result: Any) -> None:
        answer = self._waiting.get(number)
        if answer is not None and not answer.done():
            if is_done:
                answer.set_result(result)
            else:
                answer.set_exception(result)

    def _lose(self, process: "subprocess.Popen[bytes]", status: int) -> None:
        if self._process is process:
            self._process = None
            self._requests.put(None)
            next_one = "another one is started" if self._starts_left else "the server does it"
            logger.warning("the process for long work has ended (%d): %s", status, next_one)
            for answer in self._waiting.values():
                if not answer.done():
                    answer.set_exception(_LostError())


class _LostError(Exception):
    """The process has ended before the answer came."""


def _write(requests: "queue.SimpleQueue[bytes | None]", pipe: IO[bytes]) -> None:
    """Pass requests on until there are no more, or the process has ended."""
    with contextlib.suppress(OSError), pipe:
        while (request := requests.get()) is not None:
            pipe.write(request)
            pipe.flush()


def serve() -> None:
    """Do the jobs that come on standard input until it ends; answer on standard output."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if hasattr(os, "nice"):
        os.nice(_LESS_URGENT)
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a job might print is no answer
    while True:
        try:
            number, job, arguments = pickle.load(sys.stdin.buffer)
        except (EOFError, pickle.UnpicklingError):
            return
        try:
            answer = number, True, job(*arguments)
        except Exception as error:
            answer = number, False, RuntimeError(f"{type(error).__name__}: {error}")
        try:
            pickle.dump(answer, answers)
            answers.flush()
        except BrokenPipeError:  # the server has ended meanwhile
            os._exit(0)
