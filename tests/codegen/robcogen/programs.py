"""Programs in C++ that use RobCoGen's classes, and what they print."""

import shutil
import subprocess
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from tests.codegen.compiling import EIGEN
from tests.codegen.robots import PLAIN

import kindsl
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.mechanics.spatial.arrays import Array
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.library import Library, Options

COMPILERS = [name for name in ("g++", "clang++") if shutil.which(name)]
# Takes two thirds of the time of g++ for Eigen's templates.
QUICK = COMPILERS[-1] if COMPILERS else ""
needs_cpp = pytest.mark.skipif(
    EIGEN is None or not COMPILERS, reason="there is no Eigen or no C++ compiler"
)
STRICT = ("-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror")

HEAD = """\
#include <cmath>
#include <cstdio>

#include "traits.h"
#include "joint_data_map.h"
#include "default_dynparams_getter.h"
#include "miscellaneous.h"

template <class M>
void row(const char* name, const M& m)
{
    std::printf("%s", name);
    for (int i = 0; i < m.rows(); i++) {
        for (int j = 0; j < m.cols(); j++) {
            std::printf(" %.17g", static_cast<double>(m(i, j)));
        }
    }
    std::puts("");
}

template <class V>
V numbers(double seed)
{
    V v;
    for (int i = 0; i < v.size(); i++) {
        v(i) = std::sin(seed * (i + 1));
    }
    return v;
}
"""


def generated(
    text: str,
    values: Mapping[str, float],
    folder: Path,
    language: str = "robcogen",
    **options: object,
) -> tuple[Analysis, Library]:
    """Write a robot's classes, with the runtime headers, to a folder."""
    bindings = {name: Binding(value) for name, value in values.items()}
    analysis = kindsl.parse(text, Settings(bindings=bindings))
    chosen = {"parameters": "all", "has_runtime": True, **options}
    real = chosen.pop("real", "double")
    asked = Options(str(language), PLAIN, real, False, prefix=_prefix(analysis), **chosen)
    library, files = generate(Source("robot.kindsl", analysis, {}), asked)
    for name, content in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(content, encoding="utf-8")
    return analysis, library


def _prefix(analysis: Analysis) -> str:
    return str(analysis.model.name).lower()


def built(
    folder: Path, source: str, *options: str, compiler: str = QUICK
) -> subprocess.CompletedProcess[str]:
    """Compile a program in the folder of the headers; the result tells what was complained of.

    What a project compiles apart is part of the program here, so that Eigen is read once.
    """
    is_program = "-fsyntax-only" not in options
    rest = '#include "miscellaneous.cpp"\n' if is_program else ""
    (folder / "main.cpp").write_text(source + rest, encoding="utf-8")
    command = [
        compiler, *STRICT, *options, "-I", ".", "-isystem", str(EIGEN), "main.cpp",
        *(["-o", "main"] if is_program else []),
    ]  # fmt: skip
    return subprocess.run(
        command, cwd=folder, capture_output=True, text=True, timeout=280, check=False
    )


def printed(folder: Path, source: str, *options: str, compiler: str = QUICK) -> dict[str, Array]:
    """Compile and run a program; return its rows by their names."""
    done = built(folder, source, "-std=c++14", *options, compiler=compiler)
    assert (done.returncode, done.stderr) == (0, "")
    return told(folder)


def told(folder: Path, *arguments: str) -> dict[str, Array]:
    """Run the program that was built in a folder; return its rows by their names."""
    text = subprocess.run(
        [folder / "main", *arguments], capture_output=True, text=True, timeout=60, check=True
    ).stdout
    rows = (line.split() for line in text.splitlines())
    return {name: np.array([float(x) for x in values]) for name, *values in rows}
