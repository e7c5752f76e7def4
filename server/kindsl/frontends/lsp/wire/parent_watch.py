"""Ends the server when the editor that started it has died."""

import asyncio
import os
import sys

_POLL_SECONDS = 2.0


async def wait_for_exit(process_id: int) -> None:
    """Return once the process is gone; at once when there is no such process.

    A file descriptor of the process tells it without polling where the system has them (Linux).
    """
    if hasattr(os, "pidfd_open"):
        try:
            descriptor = os.pidfd_open(process_id)
        except ProcessLookupError:
            return
        except OSError:
            pass  # not permitted, or an old kernel: poll
        else:
            await _readable(descriptor)
            return
    while is_alive(process_id):
        await asyncio.sleep(_POLL_SECONDS)


def is_alive(process_id: int) -> bool:
    """Return whether a process of that id exists."""
    if sys.platform == "win32":
        return _is_alive_on_windows(process_id)
    try:
        os.kill(process_id, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except PermissionError:
        return True
    return True


async def _readable(descriptor: int) -> None:
    loop = asyncio.get_running_loop()
    done = loop.create_future()
    loop.add_reader(descriptor, done.cancel)
    try:
        await asyncio.wait((done,))
    finally:
        loop.remove_reader(descriptor)
        os.close(descriptor)


def _is_alive_on_windows(process_id: int) -> bool:
    import ctypes

    synchronize, timed_out = 0x00100000, 0x102
    kernel = ctypes.windll.kernel32  # type: ignore[attr-defined]
    handle = kernel.OpenProcess(synchronize, False, process_id)
    if not handle:
        return False
    try:
        return bool(kernel.WaitForSingleObject(handle, 0) == timed_out)
    finally:
        kernel.CloseHandle(handle)
