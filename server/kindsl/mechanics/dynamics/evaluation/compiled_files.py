"""Compiled code that is kept: loading it runs it, so only what we wrote ourselves is trusted."""

import contextlib
import hashlib
import os
import stat
from pathlib import Path

_WRITABLE_BY_OTHERS = 0o022


def kept_file(folder: Path, key: str, suffix: str) -> Path | None:
    """Return the file that was made for a key, None without one; what is not trusted is removed.

    A file's name ends in the SHA-256 of its content.

    Raises:
        PermissionError: The folder is somebody else's, or others may put files into it.
    """
    _require_own(folder)
    for path in sorted(folder.glob(f"{key}-*{suffix}")):
        with contextlib.suppress(OSError):
            if _is_own(path.lstat()) and path.name == f"{key}-{digest_of(path)}{suffix}":
                return path
            path.unlink()
    return None


def digest_of(path: Path) -> str:
    """Return the SHA-256 of a file."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _require_own(folder: Path) -> None:
    status = folder.stat()
    if not _is_ours(status):
        raise PermissionError(0, "it belongs to somebody else")
    if os.name == "posix" and stat.S_IMODE(status.st_mode) & _WRITABLE_BY_OTHERS:
        raise PermissionError(0, "others may write to it")


def _is_own(status: os.stat_result) -> bool:
    """Return whether nobody else can have written a file; its links lead anywhere."""
    if not stat.S_ISREG(status.st_mode) or not _is_ours(status):
        return False
    return os.name != "posix" or not stat.S_IMODE(status.st_mode) & _WRITABLE_BY_OTHERS


def _is_ours(status: os.stat_result) -> bool:
    return not hasattr(os, "geteuid") or status.st_uid in (os.geteuid(), 0)
