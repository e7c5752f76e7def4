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
    has_affinity = hasattr(os, "sched_getaffinity")
    n_processors = len(os.sched_getaffinity(0)) if has_affinity else os.cpu_count() or 1
    jobs = min(jobs or min(n_processors, len(tasks) // _FILES_PER_JOB), len(tasks))
    if jobs < 2 or sys.platform == "emscripten":
        yield from map(check, tasks)
    else:
        yield from _in_processes(tasks, jobs)


def _in_processes(tasks: Sequence[Task], jobs: int) -> Iterator[Checked]:
    import multiprocessing
    import signal
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool

    method = "fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn"
    context = multiprocessing.get_context(method)
    done = 0
    # Ctrl-C ends the parent, which ends the others without a traceback of each.
    ignored = signal.SIGINT, signal.SIG_IGN
    with ProcessPoolExecutor(jobs, context, signal.signal, ignored) as pool:
        try:
            for checked in pool.map(check, tasks, chunksize=_BATCH):
                done += 1
                yield checked
        except BrokenProcessPool:
            for task in tasks[done:]:
                yield Checked(None, Failure(task.shown, "the process that linted it was killed"))
