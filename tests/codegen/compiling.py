"""C compilers at hand, and what they make of generated code."""

import shutil
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

from kindsl.mechanics.dynamics.evaluation import compiling

EIGEN = next(
    (
        folder
        for folder in (
            Path("/usr/include/eigen3"),
            *(Path(p, "cmeel.prefix", "include", "eigen3") for p in sys.path if p),
        )
        if folder.is_dir()
    ),
    None,
)
STRICT = ["-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]


class Compiler(NamedTuple):
    """A C compiler.

    Attributes:
        name: For people.
        command: How to call it.
        sanitizers: The options that find undefined behaviour.
    """

    name: str
    command: tuple[str, ...]
    sanitizers: tuple[str, ...]


def _compilers() -> list[Compiler]:
    found = []
    all_sanitizers = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    for name in ("gcc", "clang"):
        if shutil.which(name):
            found.append(Compiler(name, (name,), all_sanitizers))
    return found


COMPILERS = _compilers()
needs_compiler = pytest.mark.skipif(not COMPILERS, reason="there is no C compiler")
each_compiler = pytest.mark.parametrize("compiler", COMPILERS, ids=lambda c: c.name)


@pytest.fixture
def quickly_compiled(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Let mechanics be compiled in a folder of the test, straight, for a few calls."""
    monkeypatch.setenv("KINDSL_CACHE", str(tmp_path))
    monkeypatch.setattr(compiling, "OPTIONS", (*compiling.OPTIONS, "-O0"))


def build(compiler: Compiler, folder: Path, options: list[str], output: str) -> Path:
    """Compile all C files of a folder into one file, without a single warning."""
    sources = sorted(str(path) for path in folder.glob("*.c"))
    command = [*compiler.command, *STRICT, *options, *sources, "-lm", "-o", str(folder / output)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")
    return folder / output


def run_tests(program: Path) -> str:
    """Run a test program, which must succeed."""
    done = subprocess.run([program], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
