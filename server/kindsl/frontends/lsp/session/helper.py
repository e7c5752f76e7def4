"""Long work about closed files in processes of its own, so that nobody waits for it who types.

They have a lower priority. They are started when there is something to do, and end when their
standard input does, so whenever the server ends.
"""

import asyncio
import contextlib
import logging
import os
import pickle
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import IO, Any, TypeVar, cast

from kindsl.frontends.lsp.session.worker import Urgency, Worker

T = TypeVar("T")

logger = logging.getLogger(__name__)

# Of nineteen steps of priority: answers to a typist go first on a machine that is busy.
_LESS_URGENT = 5


class Helper:
    """Does long work in processes, a thread for each waiting for its answer.

    Where there can be none, or one has ended unasked, it is done in the worker, in slices: a job is
    short, and all others go before it.
    """

    def __init__(self, worker: Worker, number: int) -> None:
        """Take the worker, and in how many processes to work, if any."""
        self._worker = worker
        self._threads = ThreadPoolExecutor(number, "kindsl-helper") if number else None
        self._of_thread = threading.local()
        self._processes: list[subprocess.Popen[bytes]] = []
        self._is_stopped = False

    async def run(self, job: Callable[..., T], *arguments: Any) -> T:
        """Await a job, a function of a module; what it raises is raised here.

        Cancelling gives up the answer.
        """
        work = partial(self._do, job, arguments)
        if self._threads is not None and not self._is_stopped:
            running = asyncio.get_running_loop().run_in_executor(self._threads, work)
            try:
                return cast(T, await running)
            except _LostError:
                if self._is_stopped:
                    raise asyncio.CancelledError from None
                self._threads = None
        return await self._worker.run(partial(job, *arguments), Urgency.BACKGROUND)

    def stop(self) -> None:
        """End the processes; who still waits for an answer is cancelled."""
        self._is_stopped = True
        for process in self._processes:
            _end(process)
        if self._threads is not None:
            self._threads.shutdown(wait=False, cancel_futures=True)

    def _do(self, job: Callable[..., Any], arguments: tuple[Any, ...]) -> Any:
        """Have a job done by this thread's process.

        Raises:
            _LostError: There is none, or none any more.
        """
        request = pickle.dumps((job, arguments))
        try:
            process = self._process()
            requests = cast(IO[bytes], process.stdin)
            requests.write(request)
            requests.flush()
            is_done, result = pickle.load(cast(IO[bytes], process.stdout))
        except (EOFError, OSError, ValueError, pickle.UnpicklingError) as error:
            if not self._is_stopped:
                logger.warning("no process for long work, the server does it: %s", error)
            raise _LostError from None
        if is_done:
            return result
        raise result

    def _process(self) -> "subprocess.Popen[bytes]":
        own = self._of_thread.__dict__
        if "process" not in own:
            code = f"import sys; sys.path[:] = {sys.path!r}; from {__name__} import serve; serve()"
            pipe = subprocess.PIPE
            process = subprocess.Popen([sys.executable, "-c", code], stdin=pipe, stdout=pipe)
            own["process"] = process
            self._processes.append(process)
            if self._is_stopped:  # meanwhile
                _end(process)
        return cast("subprocess.Popen[bytes]", own["process"])


class _LostError(Exception):
    """There is no process that will answer."""


def _end(process: "subprocess.Popen[bytes]") -> None:
    process.kill()
    with contextlib.suppress(OSError), process:
        pass


def serve() -> None:
    """Do the jobs that come on standard input until it ends; answer on standard output."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if hasattr(os, "nice"):
        os.nice(_LESS_URGENT)
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a job might print is no answer
    while True:
        try:
            job, arguments = pickle.load(sys.stdin.buffer)
        except (EOFError, pickle.UnpicklingError):
            return
        try:
            answer = True, job(*arguments)
        except Exception as error:
            answer = False, RuntimeError(f"{type(error).__name__}: {error}")
        try:
            pickle.dump(answer, answers)
            answers.flush()
        except BrokenPipeError:  # the server has ended meanwhile
            os._exit(0)
