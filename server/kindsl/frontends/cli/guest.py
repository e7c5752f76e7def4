"""Runs the linter where Python is a guest: what it writes and how it waits are its host's matter.

The host is the editor's own Node on a machine without Python, which shows files to read only.
"""

import errno
import os
import sys
import time
from collections.abc import Callable, Mapping, Sequence

from kindsl.frontends.cli.documents import writing

# Writes a file; returns the name of the error where that fails, such as "EACCES", else "".
Write = Callable[[str, bytes], str]


def run(
    arguments: Sequence[str], folder: str, write: Write, sleep: Callable[[float], object]
) -> int:
    """Run `kdsl-lint` with arguments in a folder and return the exit status.

    Args:
        arguments: As given to `kdsl-lint`.
        folder: Becomes the working directory.
        write: Writes a file for the linter, if the user has named it or a folder above it.
        sleep: Waits for some seconds without using the processor.
    """
    from kindsl.frontends.cli.lint import main

    def write_files(contents: Mapping[str, bytes]) -> None:
        for path, content in contents.items():
            failure = write(os.path.abspath(path), content)
            if failure:
                number = getattr(errno, failure, errno.EIO)
                raise OSError(number, os.strerror(number), path)

    vars(writing).update(write_files=write_files, write_file=lambda p, c: write_files({p: c}))
    vars(time).update(sleep=sleep)
    os.chdir(folder)
    try:
        status = main(list(arguments))
    except SystemExit as error:
        status = error.code if isinstance(error.code, int) else 1
    sys.stdout.flush()
    sys.stderr.flush()
    return status
