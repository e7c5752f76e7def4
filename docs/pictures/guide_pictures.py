"""Draws docs/images/guide-*.png with our own preview: what the guide's documents look like.

Usage: python docs/pictures/guide_pictures.py [NAME ...]

Needs the extra `test` and a Chromium.
"""

import subprocess
import sys
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image
from playwright.sync_api import Browser, sync_playwright

from kindsl.frontends.preview.screenshot import find_browser

DOCS = Path(__file__).parents[1]
FLAGS = ("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic")
# In which the page has drawn itself, and again after each change.
PATIENCE = 700  # milliseconds


@dataclass(frozen=True, slots=True)
class Picture:
    """What to draw of a document.

    Attributes:
        document: Name of a file in docs/guide, without suffix.
        preset: What is shown to begin with.
        hidden: Keys of the kinds of things that are left out, as in the preview's legend.
        q: Joint positions, in rad or m; the others are zero.
        opacity: Opacity of some kinds of things, by key.
        target: The point that is in the middle, in the base frame, in metres; None: all of it.
        camera: From where it is seen, as a direction in the base frame; None: as the preview does.
        closeness: How much nearer than the preview the camera stands.
        has_panel: Whether the preview's panel is in the picture.
        size: Width and height in pixels.
    """

    document: str
    preset: str = "All"
    hidden: tuple[str, ...] = ()
    q: dict[str, float] = field(default_factory=dict)
    opacity: dict[str, float] = field(default_factory=dict)
    target: tuple[float, float, float] | None = None
    camera: tuple[float, float, float] | None = None
    closeness: float = 1.0
    has_panel: bool = False
    size: tuple[int, int] = (900, 560)


NAMES = ("link-names", "joint-names", "frame-names")
MASSES = ("com", "robot-com", "inertia")
BODIES = ("body", "base", "revolute", "prismatic", "axis")
FAINT = {"body": 0.3, "revolute": 0.3, "prismatic": 0.3, "joint-frame": 0.6}
PICTURES = {
    "frames-zero": Picture(
        "crane", hidden=MASSES, opacity=FAINT, target=(0.42, 0.0, 0.3), closeness=1.02
    ),
    "frames-moved": Picture(
        "crane", hidden=(*MASSES, "optional-frame"), opacity=FAINT, q={"luff": 0.5, "extend": 0.2},
        target=(0.45, 0.0, 0.55), closeness=1.5,
    ),
    "rotations": Picture(
        "rotations", hidden=(*MASSES, *BODIES, "link-frame", "joint-frame", *NAMES),
        target=(0.33, 0.0, 0.22), camera=(-0.2, -1.0, 0.35), closeness=1.9, size=(900, 240),
    ),
    "inertia": Picture(
        "crane", hidden=("link-frame", "joint-frame", "optional-frame", "axis"),
        target=(0.42, 0.0, 0.27), closeness=1.12,
    ),
    "signs": Picture(
        "signs", hidden=("joint-frame", "axis", "revolute", "robot-com"), camera=(0.0, -1.0, 0.12),
        size=(900, 420),
    ),
    "parameters": Picture(
        "reacher", preset="Kinematics", q={"shoulder": 0.6, "elbow": -0.9, "wrist": -0.5},
        has_panel=True, size=(1000, 580),
    ),
}  # fmt: skip

LOOK_FROM = """([target, direction, closeness]) => {
  const { viewer } = kindsl, { controls, camera } = viewer;
  const { toThree } = kindslModules["picture/camera.js"];
  const away = camera.getWorldPosition(new MeshCat.THREE.Vector3()).sub(controls.target);
  const length = away.length() / closeness;
  if (target) controls.target.copy(toThree(target));
  const ray = direction ? toThree(direction).normalize() : away.normalize();
  const place = controls.target.clone().addScaledVector(ray, length);
  camera.position.copy(kindsl.camera.fromWorld(place));
  controls.update();
  viewer.set_dirty();
}"""


def main(names: list[str]) -> None:
    """Draw the pictures of these names, or all."""
    with sync_playwright() as playwright, TemporaryDirectory() as folder:
        browser = playwright.chromium.launch(executable_path=find_browser(), args=list(FLAGS))
        for name in names or PICTURES:
            page = Path(folder, f"{name}.html")
            target = DOCS / "images" / f"guide-{name}.png"
            _export(PICTURES[name], page)
            _write(_drawn(browser, page, PICTURES[name]), target)
            print(f"{target.relative_to(DOCS.parent)}: {target.stat().st_size // 1000} kB")
        browser.close()


def _export(picture: Picture, page: Path) -> None:
    document = DOCS / "guide" / f"{picture.document}.kindsl"
    command = [sys.executable, "-m", "kindsl", "preview", str(document), "--export", str(page)]
    subprocess.run(command, check=True)


def _drawn(browser: Browser, file: Path, picture: Picture) -> bytes:
    width, height = picture.size
    page = browser.new_page(viewport={"width": width, "height": height})
    page.goto(file.as_uri() + ("" if picture.has_panel else "#picture"))
    page.wait_for_timeout(PATIENCE)
    page.evaluate("(name) => kindsl.presets.choose(name)", picture.preset)
    for key in picture.hidden:
        page.evaluate("(key) => kindsl.actions.setView(key, false, 1)", key)
    for key, opacity in picture.opacity.items():
        page.evaluate("([key, value]) => kindsl.actions.setView(key, true, value)", [key, opacity])
    for joint, value in picture.q.items():
        page.evaluate("([joint, value]) => kindsl.actions.setJoint(joint, value)", [joint, value])
    page.evaluate("() => { kindsl.viewer.render(); kindsl.camera.frame(); }")
    page.evaluate(LOOK_FROM, [picture.target, picture.camera, picture.closeness])
    page.wait_for_timeout(PATIENCE)
    png = page.screenshot()
    page.close()
    return png


def _write(png: bytes, target: Path) -> None:
    Image.open(BytesIO(png)).convert("RGB").save(target, optimize=True)


if __name__ == "__main__":
    main(sys.argv[1:])
