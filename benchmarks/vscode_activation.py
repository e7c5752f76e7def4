"""How long the VS Code extension takes to activate, as a multiple of the least one possible.

Both are loaded in the same installation of VS Code, alternately, each in a window of its own: the
packaged extension with its bundled libraries, and a client of a few lines with a trivial pygls
server in the same interpreter. Then, without any Python: from a click
on a file to its first squiggle.

Usage: python benchmarks/vscode_activation.py [ROUNDS]
"""

import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from playwright.sync_api import Browser

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.vscode import browser, code_server, models  # noqa: E402
from tests.vscode.extension_host import run_suite  # noqa: E402
from tests.vscode.test_vscode_built_in import BUILT_IN, host_processes  # noqa: E402
from tests.vscode.workbench import Workbench  # noqa: E402

CLIENTS = ROOT / "benchmarks" / "vscode_clients"
SUBJECTS = ("kindsl", "minimal")
LIMIT = 1.5


def main(rounds: int) -> int:
    """Print the medians and their ratio; return 1 if it is above the limit."""
    package = code_server.package_extension()
    _compile_minimal()
    # Compiled modules are kept, as users have them.
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ["KINDSL_BENCHMARK_PYTHON"] = sys.executable
    os.environ["KINDSL_BENCHMARK_SERVER"] = str(CLIENTS / "minimal" / "server.py")
    times: dict[str, list[float]] = {name: [] for name in SUBJECTS}
    with tempfile.TemporaryDirectory() as work, browser.chromium() as window:
        settings = {"kindsl.interpreter": [sys.executable]}
        with code_server.running(Path(work) / "data", settings, package) as server:
            for number in range(-1, rounds):
                for name in SUBJECTS if number % 2 else reversed(SUBJECTS):
                    milliseconds = _measure(window, server, Path(work) / name, name)
                    # The first round fills the caches of compiled modules.
                    times[name] += [milliseconds] if number >= 0 else []
    medians = {name: statistics.median(values) for name, values in times.items()}
    ratio = medians["kindsl"] / medians["minimal"]
    for name, median in medians.items():
        spread = ", ".join(f"{value:.0f}" for value in sorted(times[name]))
        print(f"{name:8} {median:5.0f} ms  ({spread})")
    print(f"ratio    {ratio:.2f}  (limit {LIMIT})")
    with tempfile.TemporaryDirectory() as work, browser.chromium() as window:
        squiggles, memory = _first_squiggles(window, package, Path(work), rounds)
    load, spread = os.getloadavg()[0], ", ".join(f"{value:.1f}" for value in sorted(squiggles))
    print(f"squiggle {statistics.median(squiggles):5.1f} s  ({spread}), at a load of {load:.1f}")
    print(f"memory   {memory:5.0f} MB")
    return int(ratio > LIMIT)


def _first_squiggles(
    window: Browser, package: Path, work: Path, rounds: int
) -> tuple[list[float], float]:
    """Return the seconds from a click to a squiggle, of each window, and the host's most MB."""
    folder, seconds, memory = work / "robots", list[float](), 0.0
    folder.mkdir()
    (folder / "broken.kindsl").write_text(models.BROKEN)
    with code_server.running(work / "data", BUILT_IN, package) as server:
        for _ in range(rounds):
            page = window.new_page()
            Workbench(page, server, folder)
            file = page.get_by_role("treeitem", name="broken.kindsl", exact=True)
            file.wait_for()
            # What a window does when it opens is over.
            time.sleep(5.0)
            begin = time.perf_counter()
            file.click()
            page.wait_for_selector(".squiggly-error")
            seconds.append(time.perf_counter() - begin)
            for process in host_processes(work):
                status = Path(f"/proc/{process}/status").read_text()
                memory = max(memory, int(status.partition("VmHWM:")[2].split()[0]) / 1024)
            page.close()
    return seconds, memory


def _measure(window: Browser, server: code_server.CodeServer, folder: Path, name: str) -> float:
    folder.mkdir(exist_ok=True)
    outcome = run_suite(window, server, folder, CLIENTS / "measure.js", [CLIENTS / "minimal"])
    found = re.search(rf"TEST {name} ([\d.]+)", str(outcome))
    if found is None:
        raise RuntimeError(f"no measurement of {name}:\n{outcome}")
    return float(found.group(1))


def _compile_minimal() -> None:
    esbuild = code_server.EXTENSION / "node_modules" / ".bin" / "esbuild"
    options = ["--bundle", "--platform=node", "--format=cjs", "--external:vscode", "--minify"]
    source = CLIENTS / "minimal" / "extension.ts"
    target = CLIENTS / "minimal" / "out" / "extension.js"
    modules = {**os.environ, "NODE_PATH": str(code_server.EXTENSION / "node_modules")}
    command = [esbuild, source, *options, f"--outfile={target}"]
    subprocess.run(command, check=True, capture_output=True, env=modules)


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 7))
