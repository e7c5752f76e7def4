"""Work beside the message loop whose failure must be seen."""

import asyncio
import logging
from collections.abc import Coroutine
from typing import Any

logger = logging.getLogger(__name__)

_running: set["asyncio.Task[Any]"] = set()


def start(work: Coroutine[Any, Any, Any]) -> "asyncio.Task[Any]":
    """Run something that nobody waits for; a failure is logged."""
    task = asyncio.ensure_future(work)
    _running.add(task)
    task.add_done_callback(_ended)
    return task


def _ended(task: "asyncio.Task[Any]") -> None:
    _running.discard(task)
    if not task.cancelled() and (error := task.exception()) is not None:
        logger.error("background work failed", exc_info=error)
