"""Handles in a real browser: a drag writes the one number that its handle stands for."""

import pytest
from tests.preview.browser import PLACE, eventually, opened, until_current, until_shown
from tests.preview.handles import (
    BARE,
    COMPONENTS,
    LINES,
    Owner,
    changed,
    drag,
    grasp,
    take_back,
    touch,
)
from tests.preview.robots import ARM, EXAMPLES

from kindsl.frontends.preview.server import PreviewServer
from kindsl.judgement.analysis.analysis import analyse


@pytest.fixture(scope="module")
async def opened_once(browser):
    """Yield one page for all tests, and who owns its document."""
    owner = Owner(ARM)
    await owner.server.start()
    async with opened(browser, await owner.show()) as page:
        await until_shown(page, "Arm")
        yield owner, page
    await owner.server.stop()


@pytest.fixture
async def arm(opened_once):
    """Yield the owner and the page as at first."""
    owner, page = opened_once
    await owner.show(ARM)
    await until_current(page, owner.server)
    await page.evaluate(AS_AT_FIRST)
    return owner, page


AS_AT_FIRST = """() => {
  kindsl.selection.choose(null);
  kindsl.editing.choose("move");
  kindsl.actions.zero();
  kindsl.history.begin();
}"""
PLACES = """() => {
  kindsl.viewer.render();
  return [...kindsl.scene.poses.robot.links.values()].map((pose) => [...pose]);
}"""
LIFTED = "() => kindsl.scene.q.get('lift') || 0"
QUADRUPED = (EXAMPLES / "quadruped.kindsl").read_text()
# x and the new z are one line, so two rings lie in one plane.
LOCKED = ARM.replace("rotation = (PI/2.0, 0.0, 0.0)", "rotation = (0.3, PI/2.0, 0.4)", 1)


@pytest.mark.parametrize(
    ("text", "name", "joint", "components"),
    [(QUADRUPED, "Quadruped", "LF_HFE", ("x", "ry")), (LOCKED, "Arm", "shoulder", COMPONENTS)],
    ids=["quadruped", "gimbal-lock"],
)
async def test_each_handle_writes_its_own_number_and_undo_restores(
    arm, text, name, joint, components
):
    owner, page = arm
    await owner.show(text)
    await until_shown(page, name)
    await grasp(page, "joint", joint)
    for component in components:
        assert await drag(page, component)
        await eventually(lambda: owner.text != owner.first)
        assert len(changed(owner.first, owner.text)) == 1, component
        assert owner.labels[-1] == f"Set {component} of joint '{joint}'"
        await take_back(page, owner)


async def test_escape_writes_nothing_and_puts_all_back(arm):
    owner, page = arm
    await grasp(page, "joint", "lift")
    before = await page.evaluate(PLACE, ["joints", "lift"])
    ((x0, y0), (x1, y1)), share = (await page.evaluate(LINES))["x"], 0.7
    await page.mouse.move(x0 + share * (x1 - x0), y0 + share * (y1 - y0))
    await page.mouse.down()
    await page.mouse.move(x1 + (x1 - x0), y1 + (y1 - y0))
    await page.wait_for_function(
        "() => document.querySelector('#editing output').textContent.includes('→')"
    )
    field = page.get_by_role("textbox", name="joint lift along x")
    await page.wait_for_function("() => !kindsl.editing.exchange.isWaiting")
    told = await page.locator("#editing output").text_content()
    assert told == f"x: 0.4 → {await field.input_value()}"
    await page.keyboard.press("Escape")
    await page.mouse.up()
    await page.wait_for_function("() => !kindsl.editing.exchange.isWaiting")
    assert await field.input_value() == "0.4"
    assert owner.text == ARM
    assert await page.evaluate(PLACE, ["joints", "lift"]) == pytest.approx(before, abs=0.5)


async def test_a_number_is_typed_and_an_arrow_key_nudges(arm):
    owner, page = arm
    await grasp(page, "joint", "lift")
    await page.fill("#editing .number-row.x input >> nth=0", "55 cm")
    await page.keyboard.press("Enter")
    await eventually(lambda: "(0.55, 0.0, 0.0)" in owner.text)
    await page.wait_for_function("() => !kindsl.editing.exchange.isWaiting")
    await page.focus(".handle[data-component=y]")
    await page.keyboard.press("ArrowUp")
    await eventually(lambda: "(0.55, 0.01, 0.0)" in owner.text)
    await page.keyboard.press("r")
    await page.wait_for_selector(".handle[data-component=ry]", state="attached")
    await page.click("[data-mode=move]")
    await page.wait_for_selector(".handle[data-component=ry]", state="detached")


async def write_x_of_lift(page, owner):
    """Type 0.55 for the lift's x and wait until that is written and answered."""
    await grasp(page, "joint", "lift")
    await page.fill("#editing .number-row.x input >> nth=0", "0.55")
    await page.keyboard.press("Enter")
    await eventually(lambda: "(0.55, 0.0, 0.0)" in owner.text)
    await page.wait_for_function("() => !kindsl.editing.exchange.isWaiting")


async def test_the_key_takes_back_what_was_done_last_edit_or_pose(arm):
    owner, page = arm
    await write_x_of_lift(page, owner)
    await page.evaluate("() => kindsl.actions.setJoint('lift', 0.25)")
    await page.focus("#pane")
    await page.keyboard.press("Control+z")
    assert await page.evaluate(LIFTED) == 0.0
    assert "(0.55, 0.0, 0.0)" in owner.text
    await page.keyboard.press("Control+z")
    await eventually(lambda: owner.text == ARM)
    await page.wait_for_function("() => !kindsl.editing.exchange.isWaiting")
    await page.keyboard.press("Control+y")
    await eventually(lambda: "(0.55, 0.0, 0.0)" in owner.text)
    await page.wait_for_function("() => !kindsl.editing.exchange.isWaiting")
    await page.keyboard.press("Control+y")
    assert await page.evaluate(LIFTED) == 0.25
    assert "(0.55, 0.0, 0.0)" in owner.text


async def test_the_key_waits_for_what_is_being_written(arm):
    owner, page = arm
    await grasp(page, "joint", "lift")
    before = len(owner.labels)
    await page.evaluate("() => { kindsl.editing.set('x', 0.55); kindsl.history.undo(); }")
    await eventually(lambda: len(owner.labels) == before + 2)
    assert owner.labels[-1] == f"Undo: {owner.labels[-2]}"
    assert owner.text == ARM


async def test_what_somebody_typed_since_is_not_tried_twice_by_the_key(arm):
    owner, page = arm
    await write_x_of_lift(page, owner)
    typed, revision = owner.text + "\n", await page.evaluate("kindsl.editing.exchange.revision")
    await owner.show(typed)
    await page.wait_for_function("(old) => kindsl.editing.numbers?.revision > old", arg=revision)
    await page.focus("#pane")
    await page.keyboard.press("Control+z")
    await page.wait_for_function(
        "() => document.querySelector('#editing output').textContent.includes('has changed')"
    )
    assert await page.evaluate("() => kindsl.history.past.includes('written')") is False
    assert owner.text == typed


async def test_a_finger_drags_a_handle(arm):
    owner, page = arm
    await grasp(page, "joint", "lift")
    (x0, y0), (x1, y1) = (await page.evaluate(LINES))["x"]
    eye = await page.evaluate("kindslModules['address.js'].eyeText(kindsl.camera.state())")
    shares = (0.7, 0.8, 1.0, 1.3)
    await touch(page, [(x0 + s * (x1 - x0), y0 + s * (y1 - y0)) for s in shares])
    await eventually(lambda: owner.text != ARM)
    ((old, _),) = changed(ARM, owner.text)
    assert old == "0.4"
    assert await page.evaluate("kindslModules['address.js'].eyeText(kindsl.camera.state())") == eye


async def test_dragging_a_link_moves_its_joint_and_never_the_text(arm):
    owner, page = arm
    await grasp(page, "com", "upper")
    x, y = await page.evaluate(BARE, "upper")
    await page.mouse.move(x, y)
    await page.mouse.down()
    for step in range(1, 6):
        await page.mouse.move(x, y - 12 * step)
    await page.mouse.up()
    assert abs(await page.evaluate("() => kindsl.scene.q.get('shoulder') || 0")) > 0.05
    assert owner.text == ARM


async def test_a_child_is_a_ghost_until_it_is_accepted(arm):
    owner, page = arm
    await page.evaluate("() => kindsl.selection.choose({ kind: 'link', name: 'slider' })")
    await page.click("[data-gesture=add-child]")
    await page.wait_for_function("() => kindsl.scene.trees.ghost.links.size > 0")
    assert owner.text == ARM
    await page.click("#editing output button:text('Accept')")
    await eventually(lambda: "link link1" in owner.text)
    await page.wait_for_function("() => kindsl.scene.trees.robot.links.has('link1')")


async def test_a_pose_that_becomes_zero_is_asked_for_without_a_ghost(arm):
    owner, page = arm
    await page.evaluate("() => kindsl.actions.setJoint('shoulder', 0.5)")
    await page.evaluate("() => kindsl.selection.choose({ kind: 'joint', name: 'shoulder' })")
    before = await page.evaluate(PLACES)
    assert any(pose[0] < 0.9 for pose in before)
    await page.click("[data-gesture=pose-as-zero]")
    accept = page.locator("#editing output button:text('Accept')")
    await accept.wait_for()
    assert "stays as it stands" in await page.locator("#editing output").text_content()
    assert await page.evaluate("() => kindsl.scene.trees.ghost.links.size") == 0
    await accept.click()
    await eventually(lambda: owner.text != ARM)
    await page.wait_for_function("() => kindsl.scene.q.get('shoulder') === 0")
    assert await page.evaluate(PLACES) == [pytest.approx(place) for place in before]


async def test_a_leg_is_mirrored_only_where_its_name_tells_a_side(opened_once):
    owner, page = opened_once
    legs = QUADRUPED.replace("        RF_hip via RF_HAA\n", "").replace("RF_", "spare_")
    await owner.show(legs)
    await until_shown(page, "Quadruped")
    button = page.locator("[data-gesture=mirror-leg]")
    for link, count in (("LF_hip", 1), ("trunk", 0), ("LH_hip", 0)):
        await page.evaluate("(name) => kindsl.selection.choose({ kind: 'link', name })", link)
        await page.wait_for_function("(name) => kindsl.editing.numbers?.name === name", arg=link)
        assert await button.count() == count, link


COVERED = """() => {
  kindsl.viewer.render();
  const labels = [...document.querySelectorAll(".label")];
  const names = labels.filter((each) => each.style.visibility === "visible");
  const covered = names.filter((element) => {
    const box = element.getBoundingClientRect();
    return [...document.querySelectorAll(".handle .line")].some((line) => {
      const length = line.getTotalLength(), place = line.getScreenCTM();
      return Array.from({ length: 60 }, (_, i) => line.getPointAtLength((length * i) / 59))
        .map((point) => point.matrixTransform(place))
        .some(({ x, y }) => x > box.left && x < box.right && y > box.top && y < box.bottom);
    });
  });
  return [names.length, covered.map((element) => element.textContent)];
}"""


@pytest.mark.parametrize("mode", ["move", "turn"])
async def test_no_handle_lies_on_a_name(opened_once, mode):
    owner, page = opened_once
    await owner.show(QUADRUPED)
    await until_shown(page, "Quadruped")
    await grasp(page, "joint", "LF_HFE")
    await page.evaluate("(mode) => kindsl.editing.choose(mode)", mode)
    shown, covered = await page.evaluate(COVERED)
    assert shown > 4 and covered == []


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
