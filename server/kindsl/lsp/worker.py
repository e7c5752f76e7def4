"""One thread that does the long work, apart from the one that reads messages."""

import asyncio
import contextlib
import itertools
import queue
import threading
from collections.abc import Callable
from concurrent.futures import Future
from enum import IntEnum
from typing import TypeVar

T = TypeVar("T")


class Urgency(IntEnum):
    """What goes first: answers that someone waits for, then what we offer unasked."""

    ANSWER = 0
    DIAGNOSTICS = 1
    BACKGROUND = 2


class Worker:
    """Runs jobs one after the other in a single daemon thread.

    One thread is enough, since Python runs one at a time, and it gives analyses an order. It is
    our own so that no busy handler can fill the pool that others read from, and a daemon so
    that a long job never delays the end of the process.
    """

    __slots__ = ("_count", "_jobs", "_thread")

    def __init__(self) -> None:
        self._jobs: queue.PriorityQueue[tuple[int, int, Callable[[], None]]]
        self._jobs = queue.PriorityQueue()
        self._count = itertools.count()
        self._thread: threading.Thread | None = None

    async def run(self, job: Callable[[], T], urgency: Urgency = Urgency.ANSWER) -> T:
        """Await a job; cancelling the task leaves a job out that has not started."""
        return await asyncio.wrap_future(self.submit(job, urgency))

    def submit(self, job: Callable[[], T], urgency: Urgency = Urgency.ANSWER) -> "Future[T]":
        """Queue a job; cancelling its future before it starts leaves it out."""
        if self._thread is None:
            self._thread = threading.Thread(target=self._run, name="kindsl-worker", daemon=True)
            self._thread.start()
        future: Future[T] = Future()
        self._jobs.put((urgency, next(self._count), lambda: _execute(job, future)))
        return future

    def _run(self) -> None:
        while True:
            self._jobs.get()[-1]()


def _execute(job: Callable[[], T], future: "Future[T]") -> None:
    if not future.set_running_or_notify_cancel():
        return
    with contextlib.suppress(RuntimeError):  # the event loop that waits for it has ended
        try:
            result = job()
        except BaseException as error:
            future.set_exception(error)
        else:
            future.set_result(result)
