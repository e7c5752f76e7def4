"""Work beside the reading of messages: in one thread of its own, or as a task nobody waits for."""

import asyncio
import contextlib
import itertools
import logging
import queue
import threading
from collections.abc import Callable, Coroutine
from concurrent.futures import Future
from enum import IntEnum
from typing import Any, Generic, TypeVar

T = TypeVar("T")

logger = logging.getLogger(__name__)
_running: set["asyncio.Task[Any]"] = set()


class Urgency(IntEnum):
    """The order of jobs: answers that someone waits for, then unasked ones."""

    ANSWER = 0
    DIAGNOSTICS = 1
    BACKGROUND = 2


class AbandonedError(Exception):
    """Nobody waits any more for what a job computes."""


class Worker:
    """Runs jobs one after the other in a single daemon thread.

    One thread is enough, since Python runs one at a time, and it gives analyses an order. It is
    our own so that no busy handler can fill the pool that others read from, and a daemon so
    that a long job never delays the end of the process.
    """

    __slots__ = ("_count", "_jobs", "_thread", "_under_way")

    def __init__(self) -> None:
        self._jobs: queue.PriorityQueue[tuple[int, int, Job[Any]]] = queue.PriorityQueue()
        self._count = itertools.count()
        self._thread: threading.Thread | None = None
        self._under_way: Job[Any] | None = None

    async def run(self, work: Callable[[], T], urgency: Urgency = Urgency.ANSWER) -> T:
        """Await work; cancelling the task leaves it out, or ends it at its next checkpoint."""
        job = self.submit(work, urgency)
        try:
            return await asyncio.wrap_future(job.future)
        except asyncio.CancelledError:
            job.is_abandoned = True
            raise

    def submit(self, work: Callable[[], T], urgency: Urgency = Urgency.ANSWER) -> "Job[T]":
        """Queue work; cancelling its future before it starts leaves it out."""
        if self._thread is None:
            self._thread = threading.Thread(target=self._run, name="kindsl-worker", daemon=True)
            self._thread.start()
        return self._put(work, urgency)

    def checkpoint(self) -> None:
        """Go on with the job under way only if somebody still waits for it; for jobs to call.

        Raises:
            AbandonedError: Nobody does.
        """
        if self._under_way is not None and self._under_way.is_abandoned:
            raise AbandonedError

    def _put(self, work: Callable[[], T], urgency: Urgency) -> "Job[T]":
        job = Job(work)
        self._jobs.put((urgency, next(self._count), job))
        return job

    def _run(self) -> None:
        while True:
            self._do_next()

    def _do_next(self) -> None:
        self._under_way = self._jobs.get()[-1]
        self._under_way.execute()
        self._under_way = None


class InlineWorker(Worker):
    """Does each job in a turn of the event loop, where there are no threads."""

    __slots__ = ()

    def submit(self, work: Callable[[], T], urgency: Urgency = Urgency.ANSWER) -> "Job[T]":
        """Queue work; cancelling its future before it starts leaves it out."""
        job = self._put(work, urgency)
        asyncio.get_running_loop().call_soon(self._do_next)
        return job


def start_task(work: Coroutine[Any, Any, Any]) -> "asyncio.Task[Any]":
    """Run something that nobody waits for; a failure is logged."""
    task = asyncio.ensure_future(work)
    _running.add(task)
    task.add_done_callback(_ended)
    return task


class Job(Generic[T]):
    """Work to do.

    Attributes:
        future: Its result.
        is_abandoned: Whether nobody wants that any more; the work ends at its next checkpoint.
    """

    __slots__ = ("_work", "future", "is_abandoned")

    def __init__(self, work: Callable[[], T]) -> None:
        self._work = work
        self.future: Future[T] = Future()
        self.is_abandoned = False

    def execute(self) -> None:
        """Do the work, unless its future has been cancelled."""
        if not self.future.set_running_or_notify_cancel():
            return
        # Else what it was asked of, which may keep the job, would live until the next collection.
        work = self._work
        del self._work
        with contextlib.suppress(RuntimeError):  # the event loop that waits for it has ended
            try:
                result = work()
            except BaseException as error:
                self.future.set_exception(error)
            else:
                self.future.set_result(result)


def _ended(task: "asyncio.Task[Any]") -> None:
    _running.discard(task)
    if not task.cancelled() and (error := task.exception()) is not None:
        logger.error("background work failed", exc_info=error)
