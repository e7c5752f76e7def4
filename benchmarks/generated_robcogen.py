"""RobCoGen's own C++ classes against generated ones, in one program through the same interface.

    python benchmarks/generated_robcogen.py [FOLDER] [--compiler g++] [--rounds N] [OPTION ...]

FOLDER is `../shared/robcogen_interface` unless said otherwise: documents, RobCoGen's generated
headers and `compare.cpp`, which prints outputs and the processor's time of each call. It is
compiled twice with the same options (else `-std=c++14 -O3`) and both programs run in turns. Prints
the least times, microseconds, their ratio, and how far the outputs are apart.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.codegen.compiling import EIGEN  # noqa: E402

ROBOTS = {"testIrb4600": "testirb4600", "testhyq": "test_hyq"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument(
        "folder", nargs="?", type=Path, default=ROOT.parent / "shared/robcogen_interface"
    )
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--rounds", type=int, default=5)
    args, options = parser.parse_known_args()
    folder = args.folder.resolve()
    if not folder.is_dir():
        print(f"there is no folder {folder}")
        return
    with tempfile.TemporaryDirectory() as temporary:
        programs = []
        for side in ("theirs", "ours"):
            place = Path(temporary, side)
            place.mkdir()
            shutil.copy(folder / "compare.cpp", place)
            (place / "iit").symlink_to(folder / "iit")
            for robot, document in ROBOTS.items():
                (place / robot).mkdir()
                if side == "theirs":
                    (place / robot / "generated").symlink_to(folder / robot / "generated")
                else:
                    generate(folder / robot / "description" / document, place / robot / "generated")
            sources = ["compare.cpp", *(f"{robot}/generated/miscellaneous.cpp" for robot in ROBOTS)]
            command = [args.compiler, *(options or ["-std=c++14", "-O3"]), "-DNDEBUG", "-w", "-I."]
            command += ["-isystem", str(EIGEN), *sources, "-o", "compare"]
            subprocess.run(command, cwd=place, check=True)
            programs.append(place / "compare")
        runs = [[run(program) for program in programs] for _ in range(args.rounds)]
    for name in runs[0][0][1]:
        theirs, ours = (min(both[side][1][name] for both in runs) for side in (0, 1))
        print(f"{name:12} theirs {theirs:7.3f}  ours {ours:7.3f}  ratio {theirs / ours:6.2f}")
    apart = max(
        abs(a - b) / max(1.0, *map(abs, one))
        for one, other in zip(runs[0][0][0], runs[0][1][0], strict=True)
        for a, b in zip(one, other, strict=True)
    )
    print(f"outputs differ by {apart:.1e} at most")


def generate(document: Path, folder: Path) -> None:
    """Write the classes of a document, with the transforms document beside it."""
    command = [
        sys.executable, "-m", "kindsl", "generate", f"{document}.kindsl",
        "--transforms", f"{document}.dtdsl", "--language", "robcogen", "-o", str(folder),
    ]  # fmt: skip
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "server")}
    subprocess.run(command, check=True, env=environment, capture_output=True)


def run(program: Path) -> tuple[list[list[float]], dict[str, float]]:
    """Return the rows of numbers that a program prints, and the times of its calls."""
    done = subprocess.run([program], check=True, capture_output=True, text=True)
    rows = [[float(x) for x in line.split()[2:]] for line in done.stdout.splitlines()]
    times = re.findall(r"(.+) ([\d.]+) us", done.stderr)
    return rows, {name: float(time) for name, time in times}


if __name__ == "__main__":
    main()
