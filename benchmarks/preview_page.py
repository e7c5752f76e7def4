"""What a picture costs in the browser, beside an earlier version of the project in the same run.

    python benchmarks/preview_page.py [--against FOLDER] [--quick]

Robots are exported by both versions and drawn by one Chromium, in software: draw calls, the median
time of a frame while the robot is turned, and the time from opening a page to its first picture.
Of 1,000 links also: a frame while it is turned, a step of scrolling through the tree, and how many
elements the page has.
"""

import argparse
import statistics
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from playwright.sync_api import Browser, sync_playwright

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.preview.browser import ARGUMENTS  # noqa: E402
from tests.support.models import Style, random_model  # noqa: E402

from kindsl.frontends.preview.screenshot import find_browser  # noqa: E402

SIZE = {"width": 1280, "height": 800}
MOST_CALLS = 25
MOST_ELEMENTS = 2000
LEAST_GAIN = 5.0
LINKS = {"frame": 200, "first picture": 1000}
FRAMES = """(count) => {
  const { viewer } = kindsl, gl = viewer.renderer.getContext(), times = [];
  const pixel = new Uint8Array(4), turn = () => {
    const { x, z } = viewer.camera.position, c = Math.cos(0.05), s = Math.sin(0.05);
    Object.assign(viewer.camera.position, { x: c * x - s * z, z: s * x + c * z });
    viewer.controls.update();
  };
  for (let i = 0; i <= count; i++) {
    turn();
    const start = performance.now();
    viewer.render();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    times.push(performance.now() - start);
  }
  return { times: times.slice(1), calls: viewer.renderer.info.render.calls };
}"""
SCROLL = """(steps) => {
  const tree = document.getElementById("tree"), times = [];
  for (let i = 1; i <= steps; i++) {
    const start = performance.now();
    tree.scrollTop = (i * tree.scrollHeight) / steps;
    tree.dispatchEvent(new Event("scroll"));
    tree.getBoundingClientRect();
    times.push(performance.now() - start);
  }
  return { times, elements: document.querySelectorAll("*").length };
}"""
IS_DRAWN = """() => typeof kindsl !== "undefined" && kindsl.scene.poses.robot
  && kindsl.scene.poses.robot.links.size > 0
  && [...document.querySelectorAll(".label")].some((label) => label.style.visibility === "visible")
  && performance.now()"""
EXPORT = "import sys; from kindsl.frontends.cli.main import main; sys.exit(main(sys.argv[1:]))"


class Picture(NamedTuple):
    """What was measured of a page: draw calls, milliseconds, elements."""

    calls: int
    frame: float
    first: float
    scroll: float
    elements: int


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--against", type=Path, help="a checkout of an earlier version")
    parser.add_argument("--quick", action="store_true", help="fewer frames")
    args = parser.parse_args()
    count = 3 if args.quick else 10
    with TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=find_browser(), args=[*ARGUMENTS, "--allow-file-access-from-files"]
        )
        versions = [ROOT] if args.against is None else [ROOT, args.against.resolve()]
        results = [measured(browser, Path(folder), version, count) for version in versions]
        browser.close()
    return tell(results)


def measured(browser: Browser, folder: Path, version: Path, count: int) -> dict[str, Picture]:
    """Draw robots by one version."""
    found = {}
    for what, links in LINKS.items():
        document, page = folder / "robot.kindsl", folder / "robot.html"
        document.write_text(random_model(links, 3, Style(has_expressions=False)))
        command = [sys.executable, "-c", EXPORT, "preview", str(document), "--export", str(page)]
        environment = {"PYTHONPATH": str(version / "server"), "PATH": "/usr/bin:/bin"}
        subprocess.run(command, check=True, env=environment, timeout=300)
        is_timed = what == "frame" or version == ROOT
        found[what] = drawn(browser, page, count if is_timed else 0)
    return found


def drawn(browser: Browser, file: Path, count: int) -> Picture:
    page = browser.new_page(viewport=SIZE)
    page.set_default_timeout(300_000)
    page.goto(file.as_uri())
    first = page.wait_for_function(IS_DRAWN, timeout=900_000).json_value()
    frames = page.evaluate(FRAMES, count) if count else {"calls": 0, "times": [0.0]}
    is_listed = page.evaluate("document.getElementById('tree') !== null")
    rows = page.evaluate(SCROLL, 20) if is_listed else {"times": [0.0], "elements": 0}
    page.close()
    medians = [statistics.median(each["times"]) for each in (frames, rows)]
    return Picture(frames["calls"], medians[0], first, medians[1], rows["elements"])


def tell(results: list[dict[str, Picture]]) -> int:
    ours = results[0]
    calls = ours["frame"].calls
    many = ours["first picture"]
    is_good = calls <= MOST_CALLS and many.elements < MOST_ELEMENTS
    print(f"draw calls of 200 links: {calls} (limit {MOST_CALLS})")
    print(f"frame of 200 links: {ours['frame'].frame:.0f} ms")
    print(f"first picture of 1,000 links: {many.first:.0f} ms, a frame {many.frame:.0f} ms in "
          f"{many.calls} draw calls, a scroll of the tree {many.scroll:.1f} ms, "
          f"{many.elements} elements (limit {MOST_ELEMENTS})")  # fmt: skip
    if len(results) == 2:
        other = results[1]
        gain = other["frame"].frame / ours["frame"].frame
        first = other["first picture"].first / ours["first picture"].first
        is_good &= gain >= LEAST_GAIN
        print(f"before: {other['frame'].calls} draw calls, {other['frame'].frame:.0f} ms a frame, "
              f"{other['first picture'].first:.0f} ms to the first picture")  # fmt: skip
        print(f"a frame is {gain:.1f} x faster (limit {LEAST_GAIN:g}), the first {first:.1f} x")
    return int(not is_good)


if __name__ == "__main__":
    sys.exit(main())
