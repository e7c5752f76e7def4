"""What a robot looks like at first sight, and what presets show: by what is in the scene."""

from itertools import pairwise

import pytest
from tests.preview.browser import opened, resize, until, until_shown
from tests.preview.robots import ARM, EXAMPLES, plain_robot
from tests.support.published import CORPUS, published

from kindsl.judgement.analysis.analysis import analyse

SHOWN_LABELS = """() => {
  kindsl.viewer.render();
  return [...kindsl.labels.byKey.values()].filter((label) => label.isShown).map(({ name }) => name);
}"""
VISIBLE = (
    """() => [...kindsl.scene.view].filter(([, { visible }]) => visible).map(([key]) => key)"""
)
# How far the bars begin from the left ends of their tracks.
INDENTS = """(bars) => bars.map((bar) =>
  bar.getBoundingClientRect().left - bar.parentElement.getBoundingClientRect().left)"""
BOXES = """() => [...document.querySelectorAll(".label")]
  .filter((label) => label.style.visibility === "visible")
  .map((label) => label.getBoundingClientRect())
  .map((box) => [box.left, box.top, box.right, box.bottom])"""
# Names in any of so many pictures around the robot that lie on the scale or the compass.
NAMES_ON_CORNER = """(count) => {
  const boxOf = (element) => element.getBoundingClientRect(), found = new Set();
  for (let i = 0; i < count; i += 1) {
    kindsl.camera.turn(2 * Math.PI / count, 0);
    kindsl.viewer.render();
    const corner = [...document.querySelectorAll("#scale, #compass")].map(boxOf);
    for (const label of document.querySelectorAll(".label")) {
      const a = boxOf(label), isShown = label.style.visibility === "visible";
      const isLevel = (b) => a.top < b.bottom && b.top < a.bottom;
      const isOn = (b) => isLevel(b) && a.left < b.right && b.left < a.right;
      if (isShown && corner.some(isOn)) found.add(label.textContent);
    }
  }
  return [...found];
}"""
LETTER_POINTS = 16  # of the strokes of X, Y and Z
# Of the names that are shown, how many stand for things within 110 pixels of one of these.
MOST_NAMES_NEAR = """() => {
  const { labels } = kindsl;
  labels.place();
  const shown = labels.seen().filter(({ thing }) => labels.byKey.get(thing.key)?.isShown);
  const ends = shown.map(({ at }) => at);
  const near = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) < 110;
  return Math.max(...ends.map((a, i) => ends.slice(0, i + 1).filter((b) => near(a, b)).length));
}"""
CALLS = """() => {
  kindsl.viewer.render();
  return kindsl.viewer.renderer.info.render.calls;
}"""
# WCAG's contrast of each colour against the pane's two ends, the lesser one.
CONTRASTS = """() => {
  const { cssColor, luminance } = kindslModules["picture/palette.js"], contrasts = {};
  const style = getComputedStyle(document.documentElement);
  const parts = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
  const grounds = ["sky", "floor"].map(
    (name) => luminance(parts(style.getPropertyValue(`--${name}`).trim())));
  for (const [name, color] of Object.entries(kindsl.scene.colors)) {
    const own = luminance(parts(cssColor(color)));
    contrasts[name] = Math.min(...grounds.map((ground) =>
      (Math.max(own, ground) + 0.05) / (Math.min(own, ground) + 0.05)));
  }
  return contrasts;
}"""
# Of each kind, drawn alone: the median contrast of its pixels with what is behind them.
DRAWN_CONTRASTS = """() => {
  const { viewer, scene, presets } = kindsl, gl = viewer.renderer.getContext(), contrasts = {};
  const { luminance } = kindslModules["picture/palette.js"];
  const style = getComputedStyle(document.documentElement);
  const parts = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
  const ground = (name) => parts(style.getPropertyValue(`--${name}`).trim());
  const [sky, floor] = [ground("sky"), ground("floor")];
  const [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
  const pixels = new Uint8Array(4 * w * h);
  presets.choose("All");
  for (const key of scene.view.keys()) presets.set(key, false, 1);
  for (const key of [
    "core", "bone", "drum", "body", "base", "revolute", "axis", "com", "robot-com", "link-frame",
  ]) {
    presets.set(key, true, 1);
    viewer.render();
    gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const found = [];
    for (let i = 0; i < pixels.length; i += 4) {
      if (pixels[i + 3] < 255) continue;
      const share = Math.floor(i / 4 / w) / h;
      const behind = sky.map((c, k) => floor[k] + share * (c - floor[k]));
      const a = luminance([...pixels.slice(i, i + 3)]);
      const b = luminance(behind);
      found.push((Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05));
    }
    contrasts[key] = found.sort((x, y) => x - y)[found.length >> 1];
    presets.set(key, false, 1);
  }
  presets.reset();
  presets.choose("Bodies");
  return contrasts;
}"""


async def url_of(server, text):
    await server.show("robot", analyse(text), ())
    return server.url("robot")


@published
async def test_the_first_picture_is_calm_and_its_names_do_not_flicker(browser, server):
    text = next(CORPUS.glob("*__ANYmal__*")).read_text()
    async with opened(browser, await url_of(server, text)) as page:
        await until_shown(page, "ANYmal")
        await resize(page, 1280, 800)
        await until(page, "kindsl.camera.framedSize > 0 && kindsl.history.present !== null")
        assert set(await page.evaluate(VISIBLE)) == {
            "core", "bone", "drum", "doubtful", "impossible", "ghost", "ground", "link-names",
        }  # fmt: skip
        shown = [set(await page.evaluate(SHOWN_LABELS))]
        assert 8 < len(shown[0]) <= 25
        for _ in range(15):
            await page.evaluate("kindsl.camera.turn(Math.PI / 90, 0)")
            shown.append(set(await page.evaluate(SHOWN_LABELS)))
        assert sum(len(a ^ b) for a, b in pairwise(shown)) <= 2
        assert await page.evaluate(CALLS) <= 9
        boxes = await page.evaluate(BOXES)
        for i, a in enumerate(boxes):
            for b in boxes[:i]:
                assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


async def test_presets_show_what_they_are_called_and_keep_own_choices(browser, server):
    text = (EXAMPLES / "quadruped.kindsl").read_text()
    async with opened(browser, await url_of(server, text)) as page:
        await until_shown(page, "Quadruped")
        await page.locator("[data-preset=Inertia]").click()
        await until(page, "kindsl.lineArt.circles.visible && kindsl.lineArt.outlines.visible")
        shown = set(await page.evaluate(VISIBLE))
        assert {"com", "robot-com", "inertia"} <= shown
        assert not shown & {"link-frame", "joint-frame", "axis"}
        assert not await page.evaluate("kindsl.lineArt.letters.visible")
        await page.locator("[data-category=axis]").check()
        await page.locator("[data-preset=Frames]").click()
        await until(page, "kindsl.lineArt.letters.visible")
        shown = set(await page.evaluate(VISIBLE))
        assert {"link-frame", "joint-frame", "optional-frame", "joint-names"} <= shown
        assert not shown & {"axis", "inertia"}
        letters = "kindsl.lineArt.letters.geometry.attributes.position.count"
        at_zero = await page.evaluate(letters)
        await page.evaluate("kindsl.actions.setJoint('LF_KFE', 0.5)")
        await until(page, f"{letters} > {at_zero}")
        assert await page.evaluate(letters) == at_zero + LETTER_POINTS
        await page.evaluate("kindsl.actions.zero()")
        await page.locator("[data-preset=Inertia]").click()
        assert "axis" in await page.evaluate(VISIBLE)
        await page.get_by_text("Back to Inertia as it was").click()
        assert "axis" not in await page.evaluate(VISIBLE)


# From now on a picture is drawn after each message, as slow lines and slow machines bring it about.
DRAW_BETWEEN = """() => {
  const { socket } = kindsl.connection, take = socket.onmessage;
  socket.onmessage = (event) => { take(event); kindsl.viewer.render(); };
}"""
BALL = ARM.replace("Ix = 0.02", "Ix = 90.0").replace("Iy = 0.02", "Iy = 90.0")


async def test_an_ellipsoid_larger_than_the_robot_is_left_out_until_asked_for(browser, server):
    drawn = """() => {
      kindsl.scene.update();
      const matrix = new MeshCat.THREE.Matrix4();
      return [...kindsl.scene.marks.values()].filter((mark) => mark.category === "inertia")
        .map((mark) => {
          kindsl.scene.placeMark(mark, matrix);
          return matrix.getMaxScaleOnAxis();
        });
    }"""
    async with opened(browser, await url_of(server, ARM)) as page:
        await until_shown(page, "Arm")
        await until(page, "kindsl.camera.framedSize > 0")
        await page.locator("[data-preset=Inertia]").click()
        await page.locator("#frame").click()
        distance = await page.evaluate("kindsl.camera.offset().length()")
        await page.evaluate(DRAW_BETWEEN)
        await server.show("robot", analyse(BALL.replace("Iz = 0.005", "Iz = 90.0")), ())
        await page.get_by_text("Show 1 oversized ellipsoid").wait_for()
        await page.locator("#frame").click()
        assert await page.evaluate("kindsl.camera.offset().length()") == pytest.approx(distance)
        assert min(await page.evaluate(drawn)) == 0.0
        await page.get_by_text("Show 1 oversized ellipsoid").click()
        assert max(await page.evaluate(drawn)) > 2.0


async def test_an_ellipsoid_that_alone_became_larger_is_told(browser, server):
    large = BALL.replace("Iz = 0.005", "Iz = 90.0")
    async with opened(browser, f"{await url_of(server, large)}#preset=Inertia") as page:
        await page.get_by_text("Show 1 oversized ellipsoid").wait_for()
        await server.show("robot", analyse(ARM), ())
        await page.get_by_text("oversized").wait_for(state="detached")


async def test_a_robot_of_another_size_is_framed_whole(browser, server):
    longer = ARM.replace("(0.4, 0.0, 0.0)", "(4.0, 0.0, 0.0)")
    async with opened(browser, await url_of(server, ARM)) as page:
        await until_shown(page, "Arm")
        await page.evaluate(DRAW_BETWEEN)
        await server.show("robot", analyse(longer), ())
        await until(page, "kindsl.scene.trees.robot.joints.get('lift').placement[12] === 4")
        await until(page, "kindsl.camera.framedSize > 3")
        distance = await page.evaluate("kindsl.camera.offset().length()")
        await page.locator("#frame").click()
        assert await page.evaluate("kindsl.camera.offset().length()") == pytest.approx(distance)


async def test_sliders_fill_from_zero_and_torques_from_one_side(browser, server):
    fill = """(name) => {
      const { style } = document.querySelector(`[aria-label="${name}"]`);
      return ["--from", "--to"].map((part) => parseFloat(style.getPropertyValue(part)));
    }"""
    async with opened(browser, await url_of(server, ARM)) as page:
        await until_shown(page, "Arm")
        await page.get_by_label("shoulder, typed").fill("-PI/2")
        await page.get_by_label("shoulder, typed").press("Enter")
        assert await page.evaluate(fill, "shoulder") == pytest.approx([25.0, 50.0])
        await page.locator("[data-category=torque]").check()
        bars = page.locator("#joints .bar")
        await bars.first.wait_for(state="attached")
        assert await bars.evaluate_all(INDENTS) == [0, 0]
        told = await page.locator("#joints .amount").all_text_contents()
        classes = await bars.evaluate_all("all => all.map((b) => b.classList.contains('negative'))")
        assert classes == [text.startswith("-") for text in told]


@pytest.mark.parametrize("theme", ["light", "dark"])
async def test_all_marks_stand_out_of_their_surroundings(browser, server, theme):
    text = (EXAMPLES / "quadruped.kindsl").read_text()
    async with opened(browser, f"{await url_of(server, text)}#theme={theme}") as page:
        await until(page, "kindsl.scene.poses.robot.links.size")
        await until(page, f"document.documentElement.dataset.theme === '{theme}'")
        contrasts = await page.evaluate(CONTRASTS)
        for name in ("ground", "outline"):
            contrasts.pop(name)
        assert {name: c for name, c in contrasts.items() if c < 3.0} == {}
        drawn = await page.evaluate(DRAWN_CONTRASTS)
        assert {name: c for name, c in drawn.items() if c < 3.0} == {}


async def test_a_judged_body_is_told_by_its_name_wherever_it_is(browser, server):
    text = ARM.replace("CoM = (0.2, 0.0, 0.0)", "CoM = (4.0, 0.0, 0.0)")
    analysis = analyse(text)
    await server.show("robot", analysis, analysis.findings)
    async with opened(browser, server.url("robot")) as page:
        await until_shown(page, "Arm")
        await page.locator(".label[data-verdict=impossible]").wait_for()
        judged = page.locator("[data-verdict=impossible] .start")
        assert set(await judged.all_text_contents()) == {"upper"}
        await page.locator(".branch[data-verdict=impossible] .name", has_text="upper").wait_for()
        await server.show("robot", analysis, ())
        await page.locator(".branch[data-verdict=''] .name", has_text="upper").wait_for()
        await server.show("robot", analysis, analysis.findings)
        await page.locator(".branch[data-verdict=impossible] .name", has_text="upper").wait_for()


async def test_large_robots_take_few_draw_calls_and_elements(browser, server):
    analysis = plain_robot(200, 3)
    await server.show("robot", analysis, ())
    async with opened(browser, server.url("robot")) as page:
        await until_shown(page, str(analysis.model.name))
        await until(page, "kindsl.tree.list.items.length > 200")
        assert await page.evaluate(CALLS) <= 12
        assert await page.evaluate(MOST_NAMES_NEAR) <= 4
        await page.evaluate("kindsl.presets.choose('All')")
        assert await page.evaluate(CALLS) <= 25
        await page.evaluate("kindsl.camera.zoom(0.4)")
        assert await page.evaluate(NAMES_ON_CORNER, 24) == []
        assert await page.evaluate("document.querySelectorAll('*').length") < 2000
        last = await page.evaluate("kindsl.tree.list.items.at(-1).name")
        await page.evaluate("document.getElementById('tree').scrollTop = 1e6")
        await page.locator("#tree .name", has_text=last).first.wait_for()
