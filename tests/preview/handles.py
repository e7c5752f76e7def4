"""A hand on the handles of a page: it grasps things, drags what it sees, and takes it back."""

import re
from math import dist
from typing import Any

from playwright.async_api import Page
from tests.preview.browser import eventually

from kindsl.frontends.preview.server import PreviewServer
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits

Line = list[tuple[float, float]]
COMPONENTS = ("x", "y", "z", "rx", "ry", "rz")
NUMBERS = re.compile(r"-?[\w.]+(?:/[\w.]+)?")
STEP = 45.0  # pixels that a ring is turned by
# The handles that can be dragged now, by component: the points of their lines on the page.
LINES = """() => {
  kindsl.viewer.render();
  const box = document.getElementById("pane").getBoundingClientRect(), lines = {};
  for (const [name, { group, places }] of kindsl.editing.handles.shapes) {
    if (group.classList.contains("end-on") || group.classList.contains("locked")) continue;
    lines[name] = places.map(([x, y]) => [x + box.left, y + box.top]);
  }
  return lines;
}"""
# Which of points on the page would take a handle.
ARE_FREE = """([component, points]) => points.map(([x, y]) => {
  const hit = document.elementFromPoint(x, y);
  return Boolean(hit && hit.closest(".handle"))
    && kindsl.editing.handles.nearest({ clientX: x, clientY: y }) === component;
})"""
# A place on a link where nothing lies over it.
BARE = """(link) => {
  kindsl.viewer.render();
  const canvas = kindsl.viewer.renderer.domElement, box = canvas.getBoundingClientRect();
  const [from, ...ends] = kindsl.camera.pointsOf({ kind: "link", name: link });
  for (const to of ends) for (let share = 0.05; share < 1; share += 0.04) {
    const place = kindsl.labels.project(from.map((value, i) => value + share * (to[i] - value)));
    if (!place) continue;
    const [x, y] = [place[0] + box.left, place[1] + box.top];
    const hit = kindsl.picking.at({ clientX: x, clientY: y });
    if (document.elementFromPoint(x, y) === canvas && hit && hit.kind === "link" && hit.name === link) {
      return [x, y];
    }
  }
  return null;
}"""  # noqa: E501
IS_GRASPED = """([kind, name]) => {
  const { shown, shapes } = kindsl.editing.handles;
  return shown && shown.kind === kind && shown.name === name && shapes.size > 0
    && !kindsl.editing.exchange.isWaiting;
}"""
SMALL = {"width": 720, "height": 420}  # quickly drawn
IS_FRAMED = """(height) =>
  kindsl.camera.framedSize > 0 && kindsl.viewer.renderer.domElement.clientHeight === height"""
IS_ANSWERED = "() => !kindsl.editing.exchange.isWaiting"


class Owner:
    """Owns one document and shows it."""

    def __init__(self, text: str) -> None:
        self.text = self.first = text
        self.labels: list[str] = []
        self.server = PreviewServer(on_edit=self._edit)

    async def show(self, text: str | None = None) -> str:
        """Show the document, or another one from now on; return the page's address."""
        if text is not None:
            self.text = self.first = text
        await self.server.show("robot", analyse(self.text), ())
        return self.server.url("robot")

    async def _edit(self, _key: str, writing: Any) -> str:
        assert writing.text == self.text
        self.text = apply_edits(writing.text, writing.edits)
        self.labels.append(writing.label)
        await self.show()
        return ""


async def grasp(page: Page, kind: str, name: str) -> None:
    """Choose a thing, seen from where the camera stands at first."""
    await page.set_viewport_size(SMALL)
    await page.wait_for_function(IS_FRAMED, arg=SMALL["height"])
    await page.evaluate(
        "(thing) => kindsl.selection.choose(thing)",
        {"kind": "link" if kind == "com" else kind, "name": name},
    )
    await page.wait_for_function(IS_GRASPED, arg=[kind, name])
    await page.keyboard.press("7")


async def drag(page: Page, component: str, share: float = 0.6) -> bool:
    """Move a handle along its arrow by a share of it, or round its ring; False if it cannot."""
    mode = "turn" if component[0] == "r" else "move"
    await page.evaluate("(mode) => kindsl.editing.handles.choose(mode)", mode)
    line = (await page.evaluate(LINES)).get(component)
    path = None
    if line:
        path = await (_round if mode == "turn" else _along)(page, component, line, share)
    if path is None:
        return False
    await page.mouse.move(*path[0])
    await page.mouse.down()
    for place in path[1:]:
        await page.mouse.move(*place)
    await page.mouse.up()
    return True


async def touch(page: Page, *fingers: Line) -> None:
    """Move fingers over the page, each along its places, all at once."""
    line = await page.context.new_cdp_session(page)
    told = [[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(at)]
            for at in zip(*fingers, strict=True)]  # fmt: skip
    for kind, points in zip(["touchStart", *["touchMove"] * len(told)], told, strict=False):
        await line.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    await line.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    await line.detach()


async def take_back(page: Page, owner: Owner) -> None:
    """Undo the last edit from the page."""
    await page.click("[data-gesture=undo]")
    await eventually(lambda: owner.text == owner.first)
    await page.wait_for_function(IS_ANSWERED)


def changed(old: str, new: str) -> list[tuple[str, str]]:
    """Return the numbers that differ."""
    pairs = zip(NUMBERS.findall(old), NUMBERS.findall(new), strict=True)
    return [(before, after) for before, after in pairs if before != after]


async def _along(page: Page, component: str, line: Line, share: float) -> Line | None:
    (x0, y0), (x1, y1) = line
    points = [(x0 + s * (x1 - x0), y0 + s * (y1 - y0)) for s in (0.95, 0.8, 0.65, 0.5)]
    free = await page.evaluate(ARE_FREE, [component, points])
    if True not in free:
        return None
    x, y = points[free.index(True)]
    steps = (s * share for s in (0.0, 0.4, 0.7, 1.0))
    return [(x + s * (x1 - x0), y + s * (y1 - y0)) for s in steps]


async def _round(page: Page, component: str, line: Line, _share: float) -> Line | None:
    """Follow a ring for a while, from where nothing else is nearer."""
    free = await page.evaluate(ARE_FREE, [component, line])
    if True not in free:
        return None
    first, length, path = free.index(True), 0.0, [line[free.index(True)]]
    for k in range(1, len(line)):
        path.append(line[(first + k) % (len(line) - 1)])
        length += dist(path[-2], path[-1])
        if length > STEP:
            break
    return path
