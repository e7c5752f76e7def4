"""A real browser on the preview's page."""

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from weakref import WeakKeyDictionary

from playwright.async_api import Browser, Error, Page, async_playwright
from tests.delays import injected
from tests.vscode.browser import ARGUMENTS, BROWSERS, require

from kindsl.frontends.preview.assets import PreviewUnavailableError
from kindsl.frontends.preview.documents import OnReveal
from kindsl.frontends.preview.server import PreviewServer
from kindsl.robots.scene.encoding import as_json

TIMEOUT = 60_000  # milliseconds
SIZE = {"width": 960, "height": 640}

# Of each category, shown alone: how many pixels it paints.
PAINTED = """() => {
  const { viewer, scene } = kindsl, gl = viewer.renderer.getContext();
  const paint = () => {
    viewer.render();
    const [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const pixels = new Uint8Array(4 * w * h);
    gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let count = 0;
    for (let i = 3; i < pixels.length; i += 4) if (pixels[i]) count++;
    return count;
  };
  const views = new Map(scene.view);
  const keys = [...views.keys()].filter((key) => !key.endsWith("-names"));
  kindsl.actions.showOversized(true);
  const show = (key, visible) => {
    kindsl.actions.setView(key, visible, Math.max(0.3, views.get(key).opacity));
  };
  keys.forEach((key) => show(key, false));
  const counts = { nothing: paint() };
  for (const key of keys) { show(key, true); counts[key] = paint(); show(key, false); }
  for (const [key, view] of views) kindsl.actions.setView(key, view.visible, view.opacity);
  return counts;
}"""

# base_T_x of every link, joint and frame, as its triad is drawn, row by row.
WORLD_POSES = """() => {
  const { scene, presets } = kindsl, before = presets.name, poses = {};
  presets.choose("All");
  scene.update();
  for (const { mesh, marks } of scene.batches.byKey.values()) {
    if (!["link-frame", "joint-frame", "optional-frame"].includes(marks[0].category)) continue;
    marks.forEach(({ group, name }, i) => {
      const drawn = Array.from(mesh.instanceMatrix.array.slice(16 * i, 16 * i + 16));
      const pose = drawn.map((value, k) => (k < 12 ? value / scene.model.unit : value));
      pose[15] = 1;
      const rows = [0, 1, 2, 3].map((row) => [0, 4, 8, 12].map((column) => pose[column + row]));
      poses[group + " " + name] = rows.flat();
    });
  }
  presets.choose(before);
  return poses;
}"""

# Where on the page the origin of a link, joint or frame is.
PLACE = """([group, name]) => {
  kindsl.scene.update();
  const pose = kindsl.scene.poses.robot[group].get(name);
  const box = kindsl.viewer.renderer.domElement.getBoundingClientRect();
  const [x, y] = kindsl.labels.project(kindslModules["picture/kinematics.js"].originOf(pose));
  return [box.left + x, box.top + y];
}"""


# Drawn, and the camera stands where it stays: a place on the page is one from now on.
IS_SHOWN = """(name) => {
  const { model, poses, paths } = kindsl.scene;
  const isDrawn = model.name === name && poses.robot && paths.size > 0;
  return isDrawn && kindsl.camera.framedSize > 0;
}"""


TWO_FRAMES = "() => new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)))"
# Whether a page has that size, and the picture that of its pane.
IS_FILLED = """([width, height]) => {
  const pane = document.getElementById("pane"), canvas = kindsl.viewer.renderer.domElement;
  return innerWidth === width && innerHeight === height
    && canvas.clientWidth === pane.clientWidth && canvas.clientHeight === pane.clientHeight;
}"""


# Whether a page has the links, joints and frames of a state, no others, and its revision.
HAS = """(messages) => {
  const { robot } = kindsl.scene.trees, groups = ["link", "joint", "frame"];
  const state = messages.map((message) => JSON.parse(message));
  const editing = state.find(({ type }) => type === "editing");
  if (editing?.revision !== kindsl.editing.exchange.revision) return false;
  const told = state.filter(({ type, path }) =>
    groups.includes(type) && path.startsWith("/kindsl/robot/"));
  const known = groups.flatMap((group) => [...robot[`${group}s`].values()]);
  const sorted = (list) => list.map((one) => JSON.stringify(one)).sort().join();
  return sorted(known) === sorted(told);
}"""


@asynccontextmanager
async def chromium() -> AsyncIterator[Browser]:
    path = require(*BROWSERS)
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=path, args=list(ARGUMENTS))
        yield browser
        await browser.close()


class Address:
    """Where servers listen one after another: a browser keeps what it compiled of their page."""

    def __init__(self) -> None:
        self._last: PreviewServer | None = None

    async def start(self, *callbacks: OnReveal) -> PreviewServer:
        """Return a new server that listens where the last one did, unless somebody else does."""
        if self._last is not None:
            server = PreviewServer(*callbacks, port=self._last.port, token=self._last.token)
            with suppress(PreviewUnavailableError):
                await server.start()
                return server
        self._last = server = PreviewServer(*callbacks)
        await server.start()
        return server


@asynccontextmanager
async def opened(browser: Browser, url: str) -> AsyncIterator[Page]:
    """Open a page; any error in it fails the test."""
    page = await _blank_page(browser)
    errors: list[str] = []

    def keep(error: Error) -> None:
        errors.append(str(error))

    page.on("pageerror", keep)
    await page.goto(url)
    await until(page, "typeof kindsl !== 'undefined'")
    try:
        yield page
    except BaseException:
        await page.close()  # else it would find the next server of its address
        raise
    await page.goto("about:blank")
    page.remove_listener("pageerror", keep)
    _spare.setdefault(browser, []).append(page)
    assert errors == []


# Blank pages of each browser: what was loaded into one before is loaded again in half of the time.
_spare: WeakKeyDictionary[Browser, list[Page]] = WeakKeyDictionary()


async def _blank_page(browser: Browser) -> Page:
    """Return a page that shows nothing yet, as a new one is: in front, its mouse in the corner."""
    if not _spare.get(browser):
        page = await browser.new_page(viewport=SIZE)
        page.set_default_timeout(TIMEOUT)
        if injected.ON_PAGE is not None:
            await page.add_init_script(injected.ON_PAGE)
        return page
    page = _spare[browser].pop()
    await page.set_viewport_size(SIZE)
    await page.mouse.move(0, 0)
    await page.bring_to_front()
    return page


async def until(page: Page, condition: str, argument: object = None) -> None:
    """Wait until a condition holds; with an argument it is a function of it.

    As a function always: the page's policy forbids what evaluates an expression again and again.
    """
    function = condition if argument is not None else f"() => ({condition})"
    await page.wait_for_function(function, arg=argument, timeout=TIMEOUT)


async def until_shown(page: Page, robot: str) -> None:
    """Wait until the whole state has come and a robot is drawn, all of it in the picture."""
    await until(page, IS_SHOWN, robot)


async def resize(page: Page, width: int, height: int) -> None:
    """Give a page another size, and wait until all that follows its size has followed."""
    await page.set_viewport_size({"width": width, "height": height})
    await page.evaluate(TWO_FRAMES)
    await until(page, IS_FILLED, [width, height])


async def until_current(page: Page, server: PreviewServer, key: str = "robot") -> None:
    """Wait until a page has heard of the robot that its server shows."""
    state = server._documents[key].channel.state
    await until(page, HAS, [as_json(message) for message in state])


async def eventually(condition: Callable[[], object], patience: float = 60.0) -> None:
    """Wait until a condition holds on our side."""
    async with asyncio.timeout(patience):
        while not condition():
            await asyncio.sleep(0.01)
