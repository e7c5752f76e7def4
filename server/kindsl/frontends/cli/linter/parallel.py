"""Lints many documents, on several processors if that is faster."""

import os
import sys
from collections.abc import Iterator, Sequence

from kindsl.frontends.cli.linter.one_document import Checked, Task, check
from kindsl.frontends.cli.outcome import Failure

# Starting a process costs as much as linting some dozens of documents.
_FILES_PER_JOB = 48
_BATCH = 16


def check_all(tasks: Sequence[Task], jobs: int) -> Iterator[Checked]:
    """Yield the result of each task, in order.

    Args:
        tasks: The documents.
        jobs: How many processes to use, 0 for as many as pay.
    """
    jobs = min(jobs or _paying_jobs(len(tasks)), len(tasks)) if _has_processes() else 1
    if jobs < 2:
        yield from map(check, tasks)
    else:
        yield from _in_processes(tasks, jobs)


def _paying_jobs(n_tasks: int) -> int:
    if n_tasks < 2 * _FILES_PER_JOB:
        return 1
    return min(_n_processors(), n_tasks // _FILES_PER_JOB)


def _has_processes() -> bool:
    return sys.platform != "emscripten"


def _n_processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _leave_interrupts_to_parent() -> None:
    """Let Ctrl-C end the parent, which ends the others without a traceback of each."""
    import signal

    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _in_processes(tasks: Sequence[Task], jobs: int) -> Iterator[Checked]:
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool

    method = "fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn"
    context = multiprocessing.get_context(method)
    done = 0
    with ProcessPoolExecutor(jobs, context, initializer=_leave_interrupts_to_parent) as pool:
        try:
            for checked in pool.map(check, tasks, chunksize=_BATCH):
                done += 1
                yield checked
        except BrokenProcessPool:
            for task in tasks[done:]:
                yield Checked(None, Failure(task.shown, "the process that linted it was killed"))
