"""Writes files wholly or not at all: the one place that puts texts on a disk for somebody."""

import contextlib
import errno
import os
import secrets
import shutil
import stat
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from kindsl.language.text.encodings import encoded

# Paths of what the process has open already: written to as it is, never replaced.
_STREAMS = ("/dev/stdout", "/dev/stderr", "/dev/fd/", "/proc/")


def write_file(path: str, content: bytes) -> None:
    """Make a file hold something else, wholly or not at all; see `write_files`."""
    write_files({path: content})


def write_files(contents: Mapping[str, bytes]) -> None:
    """Make files hold something else: all of them or, if one cannot be written, none.

    A file that is there keeps its mode, owner, attributes, and the links to it. Each gets its
    content in a neighbour that then takes its place; where that would lose any of these, or the
    folder cannot be written, it is overwritten, and gets its old content back if that fails.

    Args:
        contents: The new contents by path; devices and pipes are written to.

    Raises:
        OSError: One cannot be written; its `filename` names it.
    """
    staged: list[_Staged] = []
    try:
        for path, content in contents.items():
            with _named(path):
                staged.append(_staged(path, content))
        # First what may still fail.
        for one in sorted(staged, key=lambda one: one.temporary is not None):
            with _named(one.target):
                _commit(one)
    finally:
        for one in staged:
            _discard(one.temporary)


def write_folder(folder: str, texts: Mapping[str, str]) -> None:
    """Write texts into a folder, all or none; a new folder only if all can be written.

    Raises:
        OSError: The folder or one of the files cannot be written.
    """
    is_new = not os.path.isdir(folder)
    try:
        for name in texts:
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
        write_files({os.path.join(folder, name): encoded(text) for name, text in texts.items()})
    except OSError:
        if is_new:
            shutil.rmtree(folder, ignore_errors=True)
        raise


@contextlib.contextmanager
def _named(path: str) -> Iterator[None]:
    """Give a system's error the name of the file that it is about for people."""
    try:
        yield
    except OSError as error:
        error.filename, error.filename2 = path, None
        raise


class _Staged(NamedTuple):
    """Text that is ready to be put in its place.

    Attributes:
        temporary: The neighbour that holds the content, None where the target is written to.
    """

    target: str
    temporary: str | None
    content: bytes


def _staged(path: str, content: bytes) -> _Staged:
    status = _status(path)
    if status is not None and _is_stream(path, status):
        return _Staged(path, None, content)
    target = os.path.realpath(path)
    if status is not None and not os.access(target, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    if status is None:
        return _Staged(target, _neighbour(target, content, None), content)
    if status.st_nlink > 1:
        return _Staged(target, None, content)
    try:
        return _Staged(target, _neighbour(target, content, status), content)
    except PermissionError:
        return _Staged(target, None, content)


def _is_stream(path: str, status: os.stat_result) -> bool:
    return os.path.abspath(path).startswith(_STREAMS) or not stat.S_ISREG(status.st_mode)


def _status(path: str) -> os.stat_result | None:
    try:
        return os.stat(path)
    except FileNotFoundError:
        return None


def _neighbour(target: str, content: bytes, status: os.stat_result | None) -> str:
    """Return a new file beside the target with the content, and all else like the target.

    Raises:
        PermissionError: The folder cannot be written, or what the target has cannot be given.
    """
    temporary = os.path.join(os.path.dirname(target), f".kindsl-{secrets.token_hex(6)}")
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
    descriptor = os.open(temporary, flags, 0o666 if status is None else 0o600)
    try:
        with open(descriptor, "wb") as file:
            if status is not None:
                _make_alike(temporary, target, status)
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
    except BaseException:
        _discard(temporary)
        raise
    return temporary


def _make_alike(temporary: str, target: str, status: os.stat_result) -> None:
    own = os.stat(temporary)
    if (own.st_uid, own.st_gid) != (status.st_uid, status.st_gid):
        os.chown(temporary, status.st_uid, status.st_gid)
    if hasattr(os, "listxattr"):
        try:
            for name in os.listxattr(target):
                os.setxattr(temporary, name, os.getxattr(target, name))
        except OSError:
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES)) from None
    os.chmod(temporary, stat.S_IMODE(status.st_mode))


def _commit(staged: _Staged) -> None:
    if staged.temporary is not None:
        os.replace(staged.temporary, staged.target)
    elif _is_stream(staged.target, os.stat(staged.target)):
        with open(staged.target, "ab", buffering=0) as file:
            _write_all(file.fileno(), staged.content)
    else:
        _overwrite(staged.target, staged.content)


def _overwrite(target: str, content: bytes) -> None:
    """Write over a file; what was in it has its room still, should the new content have none."""
    with open(target, "r+b", buffering=0) as file:
        old = file.readall()
        try:
            _fill(file.fileno(), content)
        except BaseException:
            with contextlib.suppress(OSError):
                _fill(file.fileno(), old)
            raise


def _fill(descriptor: int, content: bytes) -> None:
    os.lseek(descriptor, 0, os.SEEK_SET)
    _write_all(descriptor, content)
    os.ftruncate(descriptor, len(content))
    os.fsync(descriptor)


def _write_all(descriptor: int, content: bytes) -> None:
    view = memoryview(content)
    while view:
        view = view[os.write(descriptor, view) :]


def _discard(temporary: str | None) -> None:
    if temporary is not None:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
