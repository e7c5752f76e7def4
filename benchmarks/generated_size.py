"""The room that generated C takes of a microcontroller: flash and stack on a Cortex-M4F, floats.

    python benchmarks/generated_size.py

Needs Debian's `gcc-arm-none-eabi` and `libnewlib-arm-none-eabi`. Prints for robots of 2, 6 and 12
links what inverse dynamics, forward dynamics and M take with `-Os`: flash, and the largest frame on
the stack; then the flash and static RAM of a program that calls both dynamics, libm included.
"""

import shutil
import subprocess
import tempfile
from pathlib import Path

import kindsl
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.library import Options

ROOT = Path(__file__).resolve().parents[1]
ROBOTS = ("docs/guide/reacher", "examples/industrial_arm", "examples/quadruped")
QUANTITIES = ("inverse_dynamics", "forward_dynamics", "joint_space_inertia")
CPU = ("-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16")
COMPILE = ("arm-none-eabi-gcc", "-std=c11", "-Os", *CPU, "-ffunction-sections", "-fdata-sections")
LINK = ("-Wl,--gc-sections", "--specs=nano.specs", "--specs=nosys.specs")
PROGRAM = """\
#include "r.h"
static r_real q[R_NJ], v[6], g[3], t[R_NV], a[6];
volatile r_real sink;
int main(void)
{
    r_parameters parameters = r_default_parameters();
    static r_model m;
    r_model_init(&m, &parameters);
    r_inverse_dynamics(@GIVEN@);
    r_forward_dynamics(@GIVEN@);
    sink = t[0] + a[0] + v[0];
    return 0;
}
"""


def main() -> None:
    if shutil.which(COMPILE[0]) is None:
        print(f"there is no {COMPILE[0]}")
        return
    for name in ROBOTS:
        document = ROOT / f"{name}.kindsl"
        analysis = kindsl.load(document)
        options = Options("c", QUANTITIES, "float", False, "unbound", "r")
        _, files = generate(Source(document.name, analysis, {}), options)
        is_floating = analysis.model.floating
        with tempfile.TemporaryDirectory() as temporary:
            place = Path(temporary)
            for file, text in files.items():
                (place / file).write_text(text, encoding="utf-8")
            for quantity in QUANTITIES:
                run(place, *COMPILE, "-fstack-usage", "-c", f"r_{quantity}.c")
                frames = (place / f"r_{quantity}.su").read_text(encoding="utf-8").splitlines()
                stack = max(int(line.split("\t")[1]) for line in frames)
                text, data, _ = sizes(place, f"r_{quantity}.o")
                print(f"{name:24} {quantity:20} {text + data:6} B flash, {stack:5} B frame")
            given = "&m, q, q, q, v, g, 0, t, a" if is_floating else "&m, q, q, q, g, 0, t"
            (place / "main.c").write_text(PROGRAM.replace("@GIVEN@", given), encoding="utf-8")
            sources = ["main.c", "r_model.c", *(f"r_{q}.c" for q in QUANTITIES)]
            run(place, *COMPILE, *LINK, *sources, "-lm", "-o", "main.elf")
            text, data, bss = sizes(place, "main.elf")
            print(f"{name:24} {'program':20} {text + data:6} B flash, {data + bss:5} B static RAM")


def sizes(place: Path, file: str) -> list[int]:
    """Return the bytes of code with constants, of data, and of what is zero at first."""
    lines = run(place, "arm-none-eabi-size", file).splitlines()
    return [int(word) for word in lines[1].split()[:3]]


def run(place: Path, *command: str) -> str:
    """Run a tool; return what it prints."""
    done = subprocess.run(command, cwd=place, check=True, capture_output=True, text=True)
    return done.stdout


if __name__ == "__main__":
    main()
