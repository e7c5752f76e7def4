"""A language server of its own that starts in a moment: a fork of what has imported it once."""

import multiprocessing
import os
import subprocess
import sys
from collections.abc import Mapping
from multiprocessing.reduction import DupFd
from pathlib import Path

import kindsl

# Importing is most of a start, and no test's business; those of the start itself run the command.
_STARTER = multiprocessing.get_context("forkserver")
_PACKAGES = ("frontends/lsp", "frontends/features", "judgement", "language", "robots/mechanism")
_HOME = Path(kindsl.__file__).parent
_STARTER.set_forkserver_preload(
    [
        ".".join(("kindsl", *file.relative_to(_HOME).with_suffix("").parts))
        for package in _PACKAGES
        for file in sorted((_HOME / package).rglob("*.py"))
        if file.stem != "__init__"
    ]
)


class PreparedServer:
    """What clients need of a `subprocess.Popen`, around the language server.

    Attributes:
        pid: The number of the process.
        stdin: Where it reads.
        stdout: Where it writes.
        stderr: Where it complains.
    """

    def __init__(self, *options: str) -> None:
        (here, to), (from_out, out), (from_err, err) = (os.pipe() for _ in range(3))
        ends = here, out, err
        arguments = [*map(_End, ends), options, Path.cwd(), dict(os.environ)]
        self._process = _STARTER.Process(target=_serve, args=arguments)
        self._process.start()
        for end in ends:
            os.close(end)
        assert self._process.pid is not None
        self.pid = self._process.pid
        self.stdin, self.stdout, self.stderr = (
            os.fdopen(there, mode)
            for there, mode in ((to, "wb"), (from_out, "rb"), (from_err, "rb"))
        )

    def wait(self, timeout: float) -> int:
        """Return the exit code once the process has ended, in seconds."""
        self._process.join(timeout)
        if self._process.exitcode is None:
            raise subprocess.TimeoutExpired("language server", timeout)
        return self._process.exitcode

    def send_signal(self, number: int) -> None:
        """Send a signal, if the process has not ended."""
        if self._process.exitcode is None:
            os.kill(self.pid, number)

    def kill(self) -> None:
        """End the process at once."""
        self._process.kill()


class _End:
    """An end of a pipe, which is given to the process that starts."""

    def __init__(self, number: int) -> None:
        self._number = number

    def __reduce__(self) -> tuple[object, ...]:
        return _taken, (DupFd(self._number),)


def _taken(end: DupFd) -> int:
    return int(end.detach())


def _serve(
    stdin: int,
    stdout: int,
    stderr: int,
    options: tuple[str, ...],
    cwd: Path,
    env: Mapping[str, str],
) -> None:
    from kindsl.frontends.cli.language_server import main

    for target, end in enumerate((stdin, stdout, stderr)):
        os.dup2(end, target)
        os.close(end)
    sys.stdin, sys.stdout = os.fdopen(0, closefd=False), os.fdopen(1, "w", closefd=False)
    sys.stderr = os.fdopen(2, "w", 1, closefd=False)
    os.chdir(cwd)
    os.environ.clear()
    os.environ.update(env)
    sys.argv[1:] = options
    main()
