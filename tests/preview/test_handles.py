"""Handles in a real browser: a drag writes the one number that its handle stands for."""

import re

import pytest
from tests.preview.browser import PLACE, chromium, eventually, opened, until_shown
from tests.preview.robots import ARM, EXAMPLES

from kindsl.analysis.analysis import analyse
from kindsl.preview.server import PreviewServer
from kindsl.text.edits import apply_edits

NUMBERS = re.compile(r"-?[\w.]+(?:/[\w.]+)?")
# The points of a handle's line on the page.
LINE = """(component) => {
  const line = document.querySelector(`.handle[data-component=${component}] .line`);
  const box = document.getElementById("pane").getBoundingClientRect();
  const numbers = line.getAttribute("d").match(/-?[0-9.]+/g).map(Number);
  return numbers.map((value, i) => value + (i % 2 ? box.top : box.left));
}"""
# Where on a ring nothing but it is under the mouse: the number of the point.
FREE = """([component, line]) => {
  for (let k = 0; 2 * k + 8 < line.length; k++) {
    const hit = document.elementFromPoint(line[2 * k], line[2 * k + 1]);
    const handle = hit && hit.closest(".handle");
    if (handle && handle.dataset.component === component) return k;
  }
  return 0;
}"""
# A place on a link, between two joints, where nothing lies over it.
BARE = """([link, from, to]) => {
  const place = (name) => kindsl.labels.project(KindslKinematics.origin(kindsl.scene.poses.robot.joints.get(name)));
  const box = kindsl.viewer.renderer.domElement.getBoundingClientRect(), [a, b] = [place(from), place(to)];
  for (let share = 0.05; share < 1; share += 0.02) {
    const [x, y] = [0, 1].map((i) => a[i] + share * (b[i] - a[i]) + (i ? box.top : box.left));
    const top = document.elementFromPoint(x, y), hit = kindsl.picking.at({ clientX: x, clientY: y });
    if (top === kindsl.viewer.renderer.domElement && hit && hit.kind === "link" && hit.name === link) return [x, y];
  }
  return null;
}"""  # noqa: E501
IS_TOLD = "() => document.querySelector('#editing output').textContent.includes('→')"
IS_GRASPED = """(name) => {
  const { shown } = kindsl.editing.handles, line = document.querySelector(".handle .line");
  return shown && shown.name === name && line && line.getAttribute("d");
}"""


@pytest.fixture(scope="module")
async def browser():
    async with chromium() as running:
        yield running


class Owner:
    """Owns one document and shows it."""

    def __init__(self, text: str) -> None:
        self.text = self.first = text
        self.labels: list[str] = []
        self.server = PreviewServer(on_edit=self._edit)

    async def show(self) -> str:
        await self.server.show("robot", analyse(self.text), ())
        return self.server.url("robot")

    async def _edit(self, _key, writing) -> str:
        assert writing.text == self.text
        self.text = apply_edits(writing.text, writing.edits)
        self.labels.append(writing.label)
        await self.show()
        return ""


@pytest.fixture
async def owner(request):
    owner = Owner(request.param)
    await owner.server.start()
    yield owner
    await owner.server.stop()


async def grasp(page, kind, name):
    await page.keyboard.press("7")
    await page.evaluate("(thing) => kindsl.selection.choose(thing)", {"kind": kind, "name": name})
    await page.wait_for_function(IS_GRASPED, arg=name)
    await page.evaluate(
        "() => new Promise((go) => requestAnimationFrame(() => setTimeout(go, 50)))"
    )


async def drag(page, component, share=0.6):
    """Move a handle: along its arrow by a share of it, or a few pieces round its ring."""
    await page.evaluate(
        "(mode) => kindsl.editing.handles.choose(mode)", "turn" if component[0] == "r" else "move"
    )
    line = await page.evaluate(LINE, component)
    if component[0] == "r":
        first = await page.evaluate(FREE, [component, line])
        path = [line[2 * k : 2 * k + 2] for k in (first, first + 2, first + 4)]
    else:
        (x0, y0), (x1, y1) = line[:2], line[2:4]
        path = [(x1 + s * (x1 - x0), y1 + s * (y1 - y0)) for s in (-0.3, 0.0, share / 2, share)]
    await page.mouse.move(*path[0])
    await page.mouse.down()
    for place in path[1:]:
        await page.mouse.move(*place)
    await page.mouse.up()


def changed(old: str, new: str) -> list[tuple[str, str]]:
    """Return the numbers that differ."""
    pairs = zip(NUMBERS.findall(old), NUMBERS.findall(new), strict=True)
    return [(before, after) for before, after in pairs if before != after]


QUADRUPED = (EXAMPLES / "quadruped.kindsl").read_text()


@pytest.mark.parametrize(
    ("owner", "name", "joint"),
    [(QUADRUPED, "Quadruped", "LF_HFE")],
    indirect=["owner"],
    ids=["quadruped"],
)
async def test_each_handle_writes_its_own_number_and_undo_restores(browser, owner, name, joint):
    model = analyse(owner.first).model
    async with opened(browser, await owner.show()) as page:
        await until_shown(page, str(model.name))
        await grasp(page, "joint", joint)
        for component in ("x", "y", "z", "rx", "ry", "rz"):
            await drag(page, component)
            await eventually(lambda: owner.text != owner.first)
            assert len(changed(owner.first, owner.text)) == 1, component
            assert owner.labels[-1] == f"Set {component} of joint '{joint}'"
            await page.wait_for_function("() => !kindsl.editing.isWaiting")
            await page.click("[data-gesture=undo]")
            await eventually(lambda: owner.text == owner.first)
            await page.wait_for_function(IS_GRASPED, arg=joint)


@pytest.mark.parametrize("owner", [ARM], indirect=True)
async def test_escape_writes_nothing_and_puts_all_back(browser, owner):
    async with opened(browser, await owner.show()) as page:
        await until_shown(page, "Arm")
        await grasp(page, "joint", "lift")
        before = await page.evaluate(PLACE, ["joints", "lift"])
        (x0, y0, x1, y1), share = (await page.evaluate(LINE, "x"))[:4], 0.7
        await page.mouse.move(x0 + share * (x1 - x0), y0 + share * (y1 - y0))
        await page.mouse.down()
        await page.mouse.move(x1 + (x1 - x0), y1 + (y1 - y0))
        await page.wait_for_function(
            "() => document.querySelector('#editing output').textContent.includes('→')"
        )
        await page.keyboard.press("Escape")
        await page.mouse.up()
        await page.wait_for_function("() => !kindsl.editing.isWaiting")
        assert owner.text == ARM
        assert await page.evaluate(PLACE, ["joints", "lift"]) == pytest.approx(before, abs=0.5)


@pytest.mark.parametrize("owner", [ARM], indirect=True)
async def test_a_number_is_typed_and_an_arrow_key_nudges(browser, owner):
    async with opened(browser, await owner.show()) as page:
        await until_shown(page, "Arm")
        await grasp(page, "joint", "lift")
        await page.fill("#editing .number-row.x input >> nth=0", "55 cm")
        await page.keyboard.press("Enter")
        await eventually(lambda: "(0.55, 0.0, 0.0)" in owner.text)
        await page.wait_for_function("() => !kindsl.editing.isWaiting")
        await page.focus(".handle[data-component=y]")
        await page.keyboard.press("ArrowUp")
        await eventually(lambda: "(0.55, 0.01, 0.0)" in owner.text)


@pytest.mark.parametrize("owner", [ARM], indirect=True)
async def test_dragging_a_link_moves_its_joint_and_never_the_text(browser, owner):
    async with opened(browser, await owner.show()) as page:
        await until_shown(page, "Arm")
        await grasp(page, "link", "upper")
        x, y = await page.evaluate(BARE, ["upper", "shoulder", "lift"])
        await page.mouse.move(x, y)
        await page.mouse.down()
        for step in range(1, 6):
            await page.mouse.move(x, y - 12 * step)
        await page.mouse.up()
        assert abs(await page.evaluate("() => kindsl.scene.q.get('shoulder') || 0")) > 0.05
        assert owner.text == ARM


@pytest.mark.parametrize("owner", [ARM], indirect=True)
async def test_a_child_is_a_ghost_until_it_is_accepted(browser, owner):
    async with opened(browser, await owner.show()) as page:
        await until_shown(page, "Arm")
        await page.evaluate("() => kindsl.selection.choose({ kind: 'link', name: 'slider' })")
        await page.click("[data-gesture=add-child]")
        await page.wait_for_function("() => kindsl.scene.trees.ghost.links.size > 0")
        assert owner.text == ARM
        await page.click("#editing output button:text('Accept')")
        await eventually(lambda: "link link1" in owner.text)
        await page.wait_for_function("() => kindsl.scene.trees.robot.links.has('link1')")


async def test_without_an_owner_there_are_no_handles(browser):
    server = PreviewServer()
    await server.start()
    await server.show("robot", analyse(ARM), ())
    async with opened(browser, server.url("robot")) as page:
        await until_shown(page, "Arm")
        await page.evaluate("() => kindsl.selection.choose({ kind: 'joint', name: 'lift' })")
        assert await page.evaluate("() => document.querySelectorAll('.handle').length") == 0
        assert await page.is_hidden("#editing")
    await server.stop()
