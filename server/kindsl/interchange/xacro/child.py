"""What runs by itself: `python child.py FILE` writes the URDF of a xacro file to stdout.

A xacro file holds Python expressions, which may take for ever and all memory there is. Ends with 1
after one sentence on stdout where the file cannot be expanded.
"""

import contextlib
import io
import sys

_MEMORY = 4 * 2**30


def main() -> int:
    """Expand the file that the arguments name."""
    _bound_memory()
    import xacro

    try:
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            text, status = xacro.process_file(sys.argv[1]).toxml(), 0
    except Exception as error:
        text, status = _reason(error), 1
    sys.stdout.buffer.write(text.encode("utf-8", "replace"))
    return status


def _reason(error: Exception) -> str:
    """Return one sentence; xacro wraps what an expression raised."""
    if isinstance(getattr(error, "exc", error), MemoryError):
        return f"it needs more than {_MEMORY // 2**30} GB of memory"
    return " ".join(str(error).split()) or type(error).__name__


def _bound_memory() -> None:
    """Let the system refuse more memory, where it can."""
    with contextlib.suppress(ImportError, OSError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, _MEMORY))


if __name__ == "__main__":
    sys.exit(main())
