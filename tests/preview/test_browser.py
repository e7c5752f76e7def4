"""The page in a real browser: what is drawn, moved, clicked, and kept."""

import asyncio
from dataclasses import replace

import numpy as np
import pytest
from tests.preview.browser import (
    PAINTED,
    PLACE,
    WORLD_POSES,
    eventually,
    opened,
    until,
    until_current,
    until_shown,
)
from tests.preview.robots import (
    ARM,
    BROKEN_ARM,
    PARAMETRIC_ARM,
    mechanics_of,
    plain_robot,
    skeleton_in,
    skeleton_of,
)
from tests.support.amount import usually
from tests.support.documents import all_documents

from kindsl.frontends.preview.server import PreviewServer
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.declarations import ValueKind
from kindsl.robots.mechanism.total_mass import unknown_bodies
from kindsl.robots.scene.messages import ParameterMessage
from kindsl.robots.scene.picture import picture

LONGER_ARM = ARM.replace("(0.4, 0.0, 0.0)", "(0.6, 0.0, 0.0)")


@pytest.fixture
async def revealed():
    return []


@pytest.fixture
async def server(address, revealed):
    running = await address.start(lambda key, span, chosen: revealed.append((key, span, chosen)))
    yield running
    await running.stop()


async def show(server, text, findings=(), key="arm.kindsl"):
    await server.show(key, analyse(text), findings)
    return server.url(key)


DRAWN_CATEGORIES = """() => {
  const { marks, bodies } = kindsl.scene;
  return [...marks.values(), ...bodies.pieces].map(({ category }) => category);
}"""


@pytest.mark.parametrize("file", all_documents()[:: usually(2, thoroughly=1)])
async def test_every_category_is_in_the_picture(browser, server, file):
    text = file.read_text()
    analysis = analyse(text)
    shown = picture(analysis.model, analysis.context.values, None).skeleton
    kinds = set(shown.joint_kinds)
    async with opened(browser, await show(server, text)) as page:
        await until_shown(page, str(analysis.model.name))
        painted = await page.evaluate(PAINTED)
        visible = await page.evaluate(DRAWN_CATEGORIES)
    assert painted.pop("nothing") == 0
    absent = {"revolute", "prismatic"} - kinds
    absent |= {"core", "bone", "drum", "doubtful", "impossible"} - set(visible)
    absent |= {"ghost"} | (set() if shown.frames else {"optional-frame"})
    # Of bodies that are not all known there is no centre of mass of the whole.
    is_known = not unknown_bodies(analysis.model, analysis.context.values)
    empty = {category for category, count in painted.items() if count < 10}
    assert empty - {"torque"} == absent | (set() if is_known else {"robot-com"})
    assert set(visible) == set(painted) - absent - {"ground"}


PART_AND_CHANGE = """() => {
  const { viewer, scene, camera } = kindsl, sizes = [camera.framedSize];
  const part = { ...scene.model, type: "model", size: 10 * scene.model.size };
  viewer.handle_command(part);
  viewer.render();
  sizes.push(camera.framedSize);
  viewer.handle_command({ type: "change", is_whole: false, parts: [part] });
  viewer.render();
  return [...sizes, camera.framedSize];
}"""


async def test_a_page_takes_whole_changes_only(browser, server):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        await until(page, "kindsl.camera.framedSize > 0")
        before, apart, after = await page.evaluate(PART_AND_CHANGE)
    assert apart == before
    assert after == pytest.approx(10 * before)


async def test_gravity_torques_are_in_the_picture(browser, server):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        await page.locator("[data-category=torque]").check()
        bars = page.locator("#joints .torque .amount")
        expected = mechanics_of(skeleton_of(ARM)).gravity_torque(np.zeros(2))
        await until(page, "document.querySelector('#joints .amount').textContent !== ''")
        assert [float(text.split()[0]) for text in await bars.all_text_contents()] == pytest.approx(
            np.asarray(expected).tolist(), abs=1e-3
        )
        assert (await page.evaluate(PAINTED))["torque"] > 20


async def test_sliders_move_links_by_our_kinematics(browser, server):
    analysis = plain_robot(9, 4)
    mechanics = mechanics_of(skeleton_in(analysis))
    rng = np.random.default_rng(3)
    await server.show("robot", analysis, ())
    async with opened(browser, server.url("robot")) as page:
        await until_shown(page, str(analysis.model.name))
        await until(page, "document.querySelectorAll('#joints .number').length === 9")
        numbers = page.locator("#joints .number")
        for q in (np.zeros(9), *rng.uniform(-2.0, 2.0, (3, 9))):
            for index, value in enumerate(q.tolist()):
                await numbers.nth(index).fill(repr(value))
                await numbers.nth(index).press("Enter")
            drawn = await page.evaluate(WORLD_POSES)
            joints = mechanics.joint_poses(q)
            ours = {
                **mechanics.forward_kinematics(q),
                **{f"joint {name}": pose for name, pose in joints.items()},
            }
            for name, pose in drawn.items():
                group, _, thing = name.partition(" ")
                wanted = ours.get(f"joint {thing}" if group == "joints" else thing, np.eye(4))
                np.testing.assert_allclose(np.reshape(pose, (4, 4)), wanted, atol=1e-6)
        names, told = mechanics.bodies.joint_names, server.at("robot")._joints
        await eventually(lambda: [told.get(name) for name in names] == q.tolist())


async def test_dragging_a_slider_moves_its_link_alone(browser, server):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        before = await page.evaluate(WORLD_POSES)
        slider = page.get_by_label("lift", exact=True)
        box = await slider.bounding_box()
        place = {"x": 0.8 * box["width"], "y": box["height"] / 2}
        await slider.click(position=place)
        after = await page.evaluate(WORLD_POSES)
        moved = {name for name in before if not np.allclose(before[name], after[name])}
        assert moved == {"links slider", "frames tool"}
        await page.get_by_text("Zero joints").click()
        assert await page.evaluate(WORLD_POSES) == before


async def test_an_edit_moves_things_without_drawing_them_anew(browser, server):
    meshes = "[...kindsl.scene.batches.byKey.values()].map((batch) => batch.mesh.uuid)"
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        await page.get_by_label("shoulder, typed").fill("0.5")
        await page.get_by_label("shoulder, typed").press("Enter")
        before = await page.evaluate(meshes)
        await show(server, LONGER_ARM)
        await until(page, "kindsl.scene.trees.robot.joints.get('lift').placement[12] === 0.6")
        assert await page.evaluate(meshes) == before
        pose = mechanics_of(skeleton_of(LONGER_ARM)).forward_kinematics([0.5, 0.0])["slider"]
        drawn = (await page.evaluate(WORLD_POSES))["links slider"]
        np.testing.assert_allclose(np.reshape(drawn, (4, 4)), pose, atol=1e-6)


async def test_a_broken_edit_dims_the_last_good_model_under_the_findings(browser, server, revealed):
    finding = Diagnostic("KD001", "syntax-error", Severity.ERROR, "a name is missing", 70, 75)
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        before = await page.evaluate(WORLD_POSES)
        bright = await page.locator("#pane").screenshot()
        await show(server, BROKEN_ARM, [finding])
        await page.locator("#notice.broken").wait_for()
        notice = page.locator("#notice button")
        assert "the last complete version is shown" in await notice.inner_text()
        assert await page.evaluate(WORLD_POSES) == before
        assert await page.locator("#pane.stale").count() == 1
        assert await page.locator("#state").inner_text() == "stale"
        assert await page.locator("#dof").inner_text() == "2 joints, 3 kg (stale)"
        assert await page.locator("#pane").screenshot() != bright
        assert not await page.get_by_text("a name is missing").is_visible()
        await notice.click()
        await page.get_by_text("a name is missing").click()
        await eventually(lambda: revealed)
        assert revealed[0][1] == (70, 75)
        await show(server, LONGER_ARM)
        await page.locator("#notice").wait_for(state="hidden")
        assert await page.locator("#pane.stale").count() == 0
        assert await page.locator("#state").inner_text() == "live"
        assert await page.locator("#dof").inner_text() == "2 joints, 3 kg"
        await until(page, "kindsl.scene.trees.robot.joints.get('lift').placement[12] === 0.6")


async def test_a_part_of_the_mass_never_reads_like_the_whole(browser, server):
    dof, paints = "kindsl.viewer.render(), document.getElementById('dof').textContent", PAINTED
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        assert (await page.evaluate(paints))["robot-com"]
        for mass in ("x", "1.0 *", ""):
            await show(server, ARM.replace("mass = 1.0", f"mass = {mass}"))
            await until(page, f"({dof}) === '2 joints, at least 2 kg'")
            painted = await page.evaluate(paints)
            assert painted["robot-com"] == painted["nothing"]
            await page.evaluate("kindsl.selection.choose({ kind: 'joint', name: 'lift' })")
            await until(page, "document.getElementById('selection').innerText.includes('unknown')")
            await show(server, ARM)
            await until(page, f"({dof}) === '2 joints, 3 kg'")
        assert await page.locator("#state").inner_text() == "live"


async def test_the_rest_of_a_robot_is_not_called_live(browser, server):
    text = ARM.replace("link slider", "link other")
    async with opened(browser, await show(server, text)) as page:
        await until(page, "document.getElementById('state').textContent === 'incomplete'")
        await until(page, "document.getElementById('dof').textContent.includes('at least 3 kg')")


@pytest.mark.parametrize(
    ("group", "name", "kind"),
    [("joints", "shoulder", "joint"), ("frames", "tool", "frame"), ("links", "upper", "link")],
)
async def test_a_click_in_the_picture_means_a_place_in_the_text(
    browser, server, revealed, group, name, kind
):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        if group != "links":
            await page.locator("[data-preset=Kinematics]").click()
        for category in (
            "link-names",
            "frame-names",
            "inertia",
            "com",
            "link-frame",
            "axis",
            "joint-frame",
            "base",
        ):
            await page.locator(f"[data-category={category}]").uncheck()
        if group != "joints":
            await page.locator("[data-category=revolute]").uncheck()
            await page.locator("[data-category=prismatic]").uncheck()
        place = await page.evaluate(PLACE, [group, name])
        await page.mouse.move(*place)
        await page.locator(".tip").wait_for()
        assert await page.locator(".tip").inner_text() == f"{kind} {name}"
        await page.mouse.click(*place)
        await eventually(lambda: revealed)
        key, span, chosen = revealed[0]
        assert (key, ARM[slice(*span)], chosen.kind) == ("arm.kindsl", name, kind)
        await page.locator("#selection h3", has_text=f"{kind} {name}").wait_for()


async def test_turning_the_view_is_no_click(browser, server, revealed):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        await page.locator("[data-category=link-names]").uncheck()
        x, y = await page.evaluate(PLACE, ["joints", "shoulder"])
        before = await page.evaluate("kindsl.viewer.camera.position.toArray()")
        await page.mouse.move(x, y)
        await page.mouse.down()
        await page.mouse.move(x + 80, y + 10, steps=4)
        await page.mouse.up()
        await until(page, "b => kindsl.viewer.camera.position.toArray()[0] !== b[0]", before)
        assert revealed == []


async def test_a_label_is_a_link_too(browser, server, revealed):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        await page.locator(".label.link", has_text="upper").click()
        await eventually(lambda: revealed)
        assert ARM[slice(*revealed[0][1])] == "upper"
        await page.locator("#selection dl", has_text="shoulder (revolute)").wait_for()
        rows = await page.locator("#selection dl").inner_text()
        assert "2 kg" in rows
        assert "shoulder (revolute)" in rows


async def test_a_turn_may_begin_on_a_label(browser, server, revealed):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        before = await page.evaluate("() => kindsl.viewer.camera.position.toArray()")
        await page.locator(".label.link", has_text="upper").hover()
        await page.mouse.down()
        await page.mouse.move(20, 300, steps=4)
        await page.mouse.up()
        await until(page, "b => kindsl.viewer.camera.position.toArray()[0] !== b[0]", before)
        await page.locator(".label.link", has_text="upper").click()
        await eventually(lambda: revealed)
        assert len(revealed) == 1


async def test_the_cursor_lights_up_what_it_is_on(browser, server):
    lit = """[...kindsl.scene.marks.values()].filter((mark) => kindsl.scene.isLit(mark))
             .map((mark) => mark.name)"""
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        server.at("arm.kindsl").highlight("link", "slider")
        await until(page, f"{lit}.length > 0")
        assert set(await page.evaluate(lit)) == {"slider"}
        assert await page.locator(".label.highlighted").inner_text() == "slider"
        server.at("arm.kindsl").highlight("joint", "shoulder")
        await until(page, f"{lit}.includes('shoulder')")
        server.at("arm.kindsl").highlight("", "")
        await until(page, f"{lit}.length === 0")


async def test_two_tabs_agree(browser, server):
    url = await show(server, PARAMETRIC_ARM)
    async with opened(browser, url) as one, opened(browser, url) as other:
        await until_shown(one, "Arm")
        await until_shown(other, "Arm")
        await one.bring_to_front()
        await one.get_by_label("shoulder, typed").fill("0.7")
        await one.get_by_label("shoulder, typed").press("Enter")
        await one.get_by_label("reach, typed").fill("0.25")
        await one.get_by_label("reach, typed").press("Enter")
        for page in (other, one):
            await page.bring_to_front()
            await until(page, "kindsl.scene.trees.robot.joints.get('lift').placement[12] === 0.25")
            await until(page, "kindsl.scene.q.get('shoulder') === 0.7")
            await until(
                page, "document.querySelector('[aria-label=\"shoulder, typed\"]').value === '0.7'"
            )
        assert await one.evaluate(WORLD_POSES) == await other.evaluate(WORLD_POSES)


async def test_documents_have_pages_of_their_own(browser, server):
    first = await show(server, ARM, key="a")
    second = await show(server, ARM.replace("Robot Arm", "Robot Leg"), key="b")
    async with opened(browser, first) as one, opened(browser, second) as other:
        await until_shown(one, "Arm")
        await until_shown(other, "Leg")


async def test_a_parameter_without_a_value_is_drawn_at_a_guess_and_can_be_typed(browser, server):
    lift = "kindsl.scene.trees.robot.joints.get('lift').placement[12]"
    async with opened(browser, await show(server, PARAMETRIC_ARM)) as page:
        await until_shown(page, "Arm")
        await page.locator("#parameters .guess").wait_for()
        assert await page.locator("#pane.stale").count() == 0
        assert "drawn at a guess" in await page.locator("#notice").inner_text()
        assert await page.evaluate(lift) == pytest.approx(0.5)
        assert await page.get_by_label("reach", exact=True).is_enabled()
        guessed = "[...kindsl.scene.marks.values()].filter((m) => kindsl.scene.isGuess(m)).length"
        assert await page.evaluate(guessed) == 2
        await page.get_by_label("reach, typed").fill("30 cm + 5 cm")
        await page.get_by_label("reach, typed").press("Enter")
        await page.locator("#notice").wait_for(state="hidden")
        await until(page, f"{lift} === 0.35")
        await page.locator("#parameters .guess").wait_for(state="detached")
        await until(page, f"{guessed} === 0")


async def test_all_guesses_are_taken_at_once(browser, server):
    text = PARAMETRIC_ARM.replace("(0.0, 0.0, 0.5)", "(0.0, drop, height)")
    async with opened(browser, await show(server, text)) as page:
        await until_shown(page, "Arm")
        await page.get_by_text("3 parameters have no value: lengths").wait_for()
        await page.get_by_text("Use guesses as values").click()
        await page.locator("#notice").wait_for(state="hidden")
        assert server.at("arm.kindsl")._parameters == dict.fromkeys(
            ("reach", "drop", "height"), 0.3
        )


async def test_the_page_comes_back_after_a_restart_and_brings_its_values(browser, server):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        await page.get_by_label("shoulder, typed").fill("0.7")
        await page.get_by_label("shoulder, typed").press("Enter")
        await eventually(lambda: server.at("arm.kindsl")._joints)
        await server.stop()
        await page.locator("[data-state=reconnecting]").wait_for()
        again = PreviewServer(port=server.port, token=server.token)
        await again.start()
        await show(again, LONGER_ARM.replace("tool {", "gripper {"))
        await page.locator("[data-state=live]").wait_for()
        await until_current(page, again, "arm.kindsl")
        assert await page.evaluate("kindsl.scene.trees.robot.frames.has('gripper')")
        assert not await page.evaluate("kindsl.scene.trees.robot.frames.has('tool')")
        assert not await page.evaluate("[...kindsl.scene.paths].some((p) => p.includes('tool'))")
        await eventually(lambda: again.at("arm.kindsl")._joints)
        assert again.at("arm.kindsl")._joints == {"shoulder": 0.7}
        await again.stop()


async def test_the_saved_version_is_a_ghost_behind_the_edited_one(browser, server):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        server.at("arm.kindsl").keep_as_ghost()
        await show(server, LONGER_ARM)
        await until(page, "kindsl.scene.trees.ghost.links.size === 3")
        async with asyncio.timeout(60):
            while (await page.evaluate(PAINTED))["ghost"] <= 50:
                await asyncio.sleep(0.05)
        ghost = await page.evaluate("kindsl.scene.poses.ghost.links.get('slider')[12]")
        assert ghost == pytest.approx(0.4)
        server.at("arm.kindsl").keep_as_ghost()
        await until(page, "kindsl.scene.trees.ghost.links.size === 0")
        assert (await page.evaluate(PAINTED))["ghost"] == 0


MARKUP = "<img src=x onerror='window.hacked=1'><script>window.hacked=1</script>"


PARAMETER = ParameterMessage(
    path="/kindsl/parameters/x",
    index=0,
    name=MARKUP,
    kind=ValueKind.LENGTH,
    value=1.0,
    is_guess=False,
    is_bound=False,
    minimum=0.0,
    maximum=2.0,
    has_range=False,
    is_overridden=False,
)


async def test_names_and_messages_with_markup_do_nothing(browser, server):
    finding = Diagnostic("KD001", MARKUP, Severity.ERROR, MARKUP, 0, 1)
    async with opened(browser, await show(server, BROKEN_ARM, [finding])) as page:
        await until_shown(page, "Arm")
        channel = server.at("arm.kindsl").channel
        link = next(m for m in channel.state if m.type == "link" and m.index == 1)
        joint = next(m for m in channel.state if m.type == "joint" and m.index == 1)
        channel.put("x", replace(link, name=MARKUP, path="/kindsl/robot/links/x"))
        path = "/kindsl/robot/joints/x"
        channel.put("x", replace(joint, name=MARKUP, successor=MARKUP, path=path))
        channel.put("x", PARAMETER)
        model = next(m for m in channel.state if m.type == "model")
        channel.put("x", replace(model, name=MARKUP))
        await page.locator("#robot", has_text=MARKUP).wait_for()
        await page.locator("#joints", has_text=MARKUP).wait_for()
        await page.locator("#parameters", has_text=MARKUP).wait_for()
        await page.locator("#summary").click()
        await page.locator("#findings", has_text=MARKUP).wait_for()
        await page.locator("#joints .name", has_text=MARKUP).click()
        assert await page.locator("img, #pane script, #panel script").count() == 0
        assert await page.evaluate("window.hacked") is None


# In a turn of its own: what the driver itself runs is not bound by the page's policy.
EVALUATES = """() => new Promise((done) => setTimeout(() => {
  try { done((0, eval)("1")) } catch (error) { done(error.name) }
}))"""


async def test_no_text_is_ever_evaluated(browser, server):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        control = {"type": "set_control", "name": "x", "callback": "window.hacked = 1"}
        elsewhere = {"type": "set_object", "path": "/Elsewhere", "object": {}}
        change = {"type": "change", "is_whole": False, "parts": [control, elsewhere]}
        for message in (control, elsewhere, change):
            await page.evaluate("(message) => kindsl.viewer.handle_command(message)", message)
        server.at("arm.kindsl").set_joint("lift", 0.1)
        await until(page, "kindsl.scene.q.get('lift') === 0.1")
        assert await page.evaluate("window.hacked") is None
        assert await page.evaluate(EVALUATES) == "EvalError"
        assert await page.evaluate("'Elsewhere' in kindsl.viewer.scene_tree.children") is False


async def test_long_robots_are_drawn(browser, server):
    analysis = plain_robot(120, 5)
    await server.show("robot", analysis, ())
    async with opened(browser, server.url("robot")) as page:
        await until_shown(page, str(analysis.model.name))
        await until(page, "kindsl.scene.trees.robot.links.size === 121")
        await until(page, "kindsl.joints.list.items.length === 120")
        assert await page.evaluate("document.querySelectorAll('*').length") < 2000


async def test_a_prismatic_joint_shows_how_far_it_has_slid(browser, server):
    rail = """() => {
      kindsl.scene.update();
      const mark = kindsl.scene.marks.byPath.get("/kindsl/robot/joints/lift/prismatic/rail");
      const joint = kindsl.scene.poses.robot.joints.get("lift");
      const matrix = new MeshCat.THREE.Matrix4();
      kindsl.scene.placeMark(mark, matrix);
      const middle = [12, 13, 14].map((i) => matrix.elements[i] - joint[i]);
      return [matrix.getMaxScaleOnAxis(), Math.hypot(...middle)];
    }"""
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        await page.get_by_label("lift, typed").fill("0.3")
        await page.get_by_label("lift, typed").press("Enter")
        assert await page.evaluate(rail) == pytest.approx([0.3, 0.15])


async def test_a_click_beside_everything_forgets_the_selection(browser, server):
    async with opened(browser, await show(server, ARM)) as page:
        await until_shown(page, "Arm")
        await page.locator("#joints .name", has_text="shoulder").click()
        await page.locator("#selection").wait_for()
        await page.mouse.click(20, 300)
        await page.locator("#selection").wait_for(state="hidden")


async def test_findings_of_a_good_document_are_a_click_away_and_their_count_is_true(
    browser, server
):
    finding = Diagnostic("KD701", "style", Severity.WARNING, "links are not in order", 0, 5)
    async with opened(browser, await show(server, ARM, [finding] * 54)) as page:
        await until_shown(page, "Arm")
        assert not await page.locator("#findings li").first.is_visible()
        await page.get_by_text("54 warnings").click()
        assert await page.get_by_text("links are not in order").count() == 40
        assert await page.locator("#findings p").inner_text() == "and 14 more"
        assert await page.locator("#pane.stale").count() == 0
        await page.get_by_text("54 warnings").click()
        await page.locator("#findings li").first.wait_for(state="hidden")


async def test_without_webgl_the_page_says_so(browser, server):
    url = await show(server, ARM)
    page = await browser.new_page()
    await page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null")
    await page.goto(url)
    await page.get_by_text("The preview needs WebGL").wait_for()
    await page.close()
