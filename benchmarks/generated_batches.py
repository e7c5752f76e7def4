"""Batches of generated C in lanes against the loop that other processors run.

    python benchmarks/generated_batches.py [DOCUMENT ...] [--compiler cc] [OPTION ...]

Without documents for the robots of `../shared/robcogen_interface` and an arm of six. The library is
compiled twice with the same options (else `-O2`), once with `-DPREFIX_NO_LANES`; both take turns
with the same 1,000 states. Prints the least times, microseconds of the processor for a state, their
ratio, and how far the results are apart.
"""

import argparse
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.codegen.loaded import Loaded  # noqa: E402

import kindsl  # noqa: E402
from kindsl.products.codegen.generating import Source, generate  # noqa: E402
from kindsl.products.codegen.library import Library, Options  # noqa: E402

SHARED = ROOT.parent / "shared/robcogen_interface"
DOCUMENTS = (
    SHARED / "testhyq/description/test_hyq.kindsl",
    SHARED / "testIrb4600/description/testirb4600.kindsl",
    ROOT / "examples/industrial_arm.kindsl",
)
QUANTITIES = ("inverse_dynamics", "forward_dynamics", "joint_space_inertia")
SIZE = 1000
ROUNDS = 40


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("documents", nargs="*", type=Path)
    parser.add_argument("--compiler", default="cc")
    args, options = parser.parse_known_args()
    for document in args.documents or [path for path in DOCUMENTS if path.is_file()]:
        with tempfile.TemporaryDirectory() as temporary:
            compare(document, Path(temporary), [args.compiler, *(options or ["-O2"])])


def compare(document: Path, folder: Path, command: list[str]) -> None:
    """Print a row for each quantity of a robot."""
    options = Options("c", QUANTITIES, "double", False, "unbound", "r")
    library, files = generate(Source(document.name, kindsl.load(document), {}), options)
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    sides = [built(folder, library, command, *macro) for macro in (["-DR_NO_LANES"], [])]
    generator = np.random.default_rng(1)
    for function in library.all_functions:
        values = {a.name: generator.uniform(-1.0, 1.0, (SIZE, len(a.components)))
                  for a in function.arguments}  # fmt: skip
        values["fext"] = None
        outputs = [[np.zeros(SIZE * len(r.entries)) for r in function.results] for _ in sides]
        calls = [
            side.prepared(function, values, output, SIZE)
            for side, output in zip(sides, outputs, strict=True)
        ]
        rounds = [[timed(call) for call in calls] for _ in range(ROUNDS)]
        loop, lanes = (min(times) / SIZE * 1e6 for times in zip(*rounds, strict=True))
        one, other = (np.concatenate(output) for output in outputs)
        apart = np.max(np.abs(one - other) / np.maximum(1.0, np.abs(one)))
        print(
            f"{document.stem:16} {function.name:20} loop {loop:7.3f}  lanes {lanes:7.3f}  "
            f"ratio {loop / lanes:5.2f}  apart {apart:.0e}"
        )


def built(folder: Path, library: Library, command: list[str], *macro: str) -> Loaded:
    """Return the library, compiled."""
    path = folder / f"r{len(macro)}.so"
    sources = [str(file) for file in folder.glob("*.c") if not file.name.endswith("_test.c")]
    options = ["-std=c11", "-shared", "-fPIC", *macro]
    subprocess.run([*command, *options, *sources, "-lm", "-o", str(path)], check=True)
    return Loaded(path, library)


def timed(call: Callable[[], None]) -> float:
    """Return the processor's seconds for a call."""
    start = time.thread_time()
    call()
    return time.thread_time() - start


if __name__ == "__main__":
    main()
