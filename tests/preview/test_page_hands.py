"""What hands do on the page: keys, fields, undo, measuring, the tree, the address."""

import asyncio
import math

import pytest
from tests.preview.browser import eventually, opened, resize, until, until_shown
from tests.preview.handles import touch
from tests.preview.robots import ARM, EXAMPLES, PARAMETRIC_ARM

from kindsl.frontends.preview.requests import KeepPose, WriteParameters
from kindsl.frontends.preview.server import PreviewServer
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import JointProperties

EYE = "kindslModules['address.js'].eyeText(kindsl.camera.state())"


async def url_of(server, text=ARM, settings=None):
    await server.show("robot", analyse(text, settings or Settings()), ())
    return server.url("robot")


async def typed(page, joint, text):
    await page.get_by_label(f"{joint}, typed").fill(text)
    await page.get_by_label(f"{joint}, typed").press("Enter")
    return await page.evaluate(f"kindsl.scene.q.get('{joint}')")


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("45deg", math.pi / 4), ("90°", math.pi / 2), ("PI/4", math.pi / 4), ("0,5", 0.5),
        ("2*(0.1 + 0.2)", 0.6), ("-1.5e-1", -0.15), ("2 PI / 3", 2 * math.pi / 3),
    ],
)  # fmt: skip
async def test_fields_take_units_and_arithmetic(page_of_arm, text, value):
    assert await typed(page_of_arm, "shoulder", text) == pytest.approx(value)


@pytest.fixture(scope="module")
async def page_of_arm(browser):
    running = PreviewServer()
    await running.start()
    async with opened(browser, await url_of(running)) as page:
        await until_shown(page, "Arm")
        await until(page, "kindsl.camera.framedSize > 0")
        yield page
    await running.stop()


@pytest.mark.parametrize("text", ["", "abc", "1 2", "(1", "1/0", "3 kg m stone", "(" * 99, "1;2"])
async def test_what_is_no_value_changes_nothing(page_of_arm, text):
    before = await typed(page_of_arm, "lift", "30 mm")
    assert before == pytest.approx(0.03)
    assert await typed(page_of_arm, "lift", text) == before
    assert await page_of_arm.locator(".number:invalid").count() == 1


async def test_a_unit_of_another_quantity_is_refused_with_the_reason(page_of_arm):
    before = await typed(page_of_arm, "shoulder", "0.25")
    assert await typed(page_of_arm, "shoulder", "300 mm") == before
    field = page_of_arm.get_by_label("shoulder, typed")
    told = await field.evaluate("(field) => field.validationMessage")
    assert told == "'mm' is not a unit of an angle: use rad, deg, °"
    assert await field.get_attribute("title") == told
    assert await typed(page_of_arm, "shoulder", "10 deg") == pytest.approx(math.radians(10.0))
    assert await field.evaluate("(field) => field.validity.valid")
    assert await typed(page_of_arm, "shoulder", "0") == 0


async def test_a_search_without_a_hit_says_so(page_of_arm):
    await page_of_arm.get_by_label("Search links").fill("wheel")
    await page_of_arm.get_by_text("No link, joint or frame has 'wheel' in its name").wait_for()
    await page_of_arm.get_by_label("Search links").fill("")
    assert await page_of_arm.locator("#nothing-found").is_hidden()


async def test_degrees_are_read_and_shown(page_of_arm):
    page = page_of_arm
    await page.locator("#angle-unit").click()
    assert await typed(page, "shoulder", "45") == pytest.approx(math.pi / 4)
    assert await typed(page, "shoulder", "PI/6") == pytest.approx(math.pi / 6)
    assert await page.get_by_label("shoulder, typed").input_value() == "30"
    await page.locator("#angle-unit").click()
    assert await page.get_by_label("shoulder, typed").input_value() == "0.5236"


SLIDE = """(slider, value) => {
  slider.value = value;
  slider.dispatchEvent(new Event("input"));
}"""


async def test_a_slider_stands_at_round_numbers_and_at_its_ends(page_of_arm):
    slider = page_of_arm.get_by_label("shoulder", exact=True)
    for value, shown in (("1.0", "1"), ("-0.5", "-0.5"), ("9", "3.1416")):
        await slider.evaluate(SLIDE, value)
        assert await page_of_arm.get_by_label("shoulder, typed").input_value() == shown
    assert await page_of_arm.evaluate("kindsl.scene.q.get('shoulder')") == math.pi


async def test_a_double_click_resets_a_slider(page_of_arm):
    await typed(page_of_arm, "shoulder", "1.2")
    await page_of_arm.get_by_label("shoulder", exact=True).dblclick()
    assert await page_of_arm.evaluate("kindsl.scene.q.get('shoulder')") == 0


async def test_keys_turn_move_zoom_and_choose_views(page_of_arm):
    page = page_of_arm
    await page.locator("#pane").focus()
    seen = {await page.evaluate(EYE)}
    for key in ("ArrowLeft", "ArrowUp", "Shift+ArrowLeft", "+", "-", *"1234567", "Home"):
        await page.keyboard.press(key)
        seen.add(await page.evaluate(EYE))
    assert len(seen) >= 12
    await page.keyboard.press("1")
    state = await page.evaluate("kindsl.camera.state()")
    assert state["position"][0] > state["target"][0] + 0.5
    assert state["position"][1:] == pytest.approx(state["target"][1:], abs=1e-6)
    await page.keyboard.press("?")
    assert await page.locator("#keys[open] dt").count() > 15
    await page.keyboard.press("Escape")
    await page.locator("#keys[open]").wait_for(state="detached")


async def test_f_looks_at_what_is_chosen_and_esc_chooses_nothing(page_of_arm):
    page = page_of_arm
    await page.locator("#tree .name", has_text="slider").click()
    await page.locator("#selection h3", has_text="link slider").wait_for()
    await page.keyboard.press("f")
    pose = await page.evaluate("kindsl.scene.poses.robot.links.get('slider').slice(12, 15)")
    target = (await page.evaluate("kindsl.camera.state()"))["target"]
    assert math.dist(pose, target) < 0.35
    await page.keyboard.press("Escape")
    await page.locator("#selection").wait_for(state="hidden")
    await page.keyboard.press("Home")


async def test_fingers_turn_the_view_and_come_nearer(page_of_arm):
    page = page_of_arm
    distance, eye = "kindsl.camera.offset().length()", "kindsl.camera.offset().toArray()"
    await page.keyboard.press("7")
    far, before = await page.evaluate(distance), await page.evaluate(eye)
    await touch(page, [(100.0 + 20.0 * k, 560.0) for k in range(5)])
    assert await page.evaluate(distance) == pytest.approx(far)
    assert math.dist(await page.evaluate(eye), before) > 0.1 * far
    apart = (
        [(250.0 - 15.0 * k, 560.0) for k in range(5)],
        [(300.0 + 15.0 * k, 560.0) for k in range(5)],
    )
    await touch(page, *apart)
    assert await page.evaluate(distance) < 0.8 * far
    assert not await page.evaluate("kindsl.selection.chosen")
    await page.keyboard.press("Home")


async def test_pose_and_view_are_undone_and_redone(browser, server):
    async with opened(browser, await url_of(server)) as page:
        await until(page, "kindsl.history.present !== null")
        before = await page.evaluate("kindsl.history.take()")
        await typed(page, "shoulder", "0.7")
        await until(page, "!document.getElementById('undo').disabled")
        await page.keyboard.press("Escape")
        await page.keyboard.press("5")
        after = await page.evaluate("(kindsl.history.settle(), kindsl.history.take())")
        await page.keyboard.press("Control+z")
        await page.keyboard.press("Control+z")
        assert await page.evaluate("kindsl.history.take()") == before
        assert await page.get_by_label("shoulder, typed").input_value() in ("0", "0.7")
        await page.keyboard.press("Control+y")
        await page.keyboard.press("Control+y")
        assert await page.evaluate("kindsl.history.take()") == after


async def test_the_address_holds_the_view_and_a_reload_shows_it_again(browser, server):
    async with opened(browser, await url_of(server)) as page:
        await until(page, "kindsl.history.present !== null")
        await typed(page, "shoulder", "0.75")
        await page.locator("[data-preset=Inertia]").click()
        await page.locator("[data-category=ground]").uncheck()
        await page.locator("#tree .name", has_text="upper").click()
        await page.keyboard.press("4")
        await until(page, "location.hash.includes('eye=') && location.hash.includes('q=')")
        eye = await page.evaluate(EYE)
        link = await page.evaluate("kindsl.address.link()")
        assert link.startswith(server.url("robot") + "#")
    server.at("robot")._joints.clear()
    server.at("robot").channel.replace("joints", {})
    async with opened(browser, link) as page:
        await until(page, "kindsl.history.present !== null")
        assert await page.evaluate("kindsl.scene.q.get('shoulder')") == 0.75
        assert await page.evaluate("kindsl.presets.name") == "Inertia"
        assert not await page.locator("[data-category=ground]").is_checked()
        assert await page.evaluate("kindsl.selection.chosen.name") == "upper"
        assert await page.evaluate(EYE) == eye


@pytest.mark.parametrize(
    "fragment",
    ["q=%,a:b,:::&eye=1,2,3&preset=Nothing&show=body:x,none:1&pick=x:y", "eye=0,0,0,0,0,0"],
)
async def test_an_address_that_makes_no_sense_shows_the_usual_picture(browser, server, fragment):
    async with opened(browser, f"{await url_of(server)}#{fragment}") as page:
        await until(page, "kindsl.history.present !== null")
        assert await page.evaluate("kindsl.presets.name") == "Bodies"
        assert not await page.evaluate("kindsl.camera.isUsers")


async def test_distance_and_angle_between_two_frames(browser, server):
    async with opened(browser, await url_of(server)) as page:
        await until_shown(page, "Arm")
        await page.locator("#measure").click()
        await page.locator("#tree .name", has_text="upper").click()
        await page.locator("#tree .name", has_text="tool").click()
        await page.get_by_text("Distance 0.5 m").wait_for()
        await page.get_by_text("Angle 1.5708 rad").wait_for()
        assert await page.locator(".measured").inner_text() == "0.5 m"
        await typed(page, "lift", "0.1")
        await page.get_by_text("Distance 0.5657 m").wait_for()


async def test_links_are_hidden_isolated_and_found(browser, server):
    drawn = """() => {
      kindsl.scene.update();
      const names = new Set();
      for (const { mesh, marks } of kindsl.scene.batches.byKey.values()) {
        for (const { group, name } of marks) if (mesh.visible && group === "links") names.add(name);
      }
      return [...names].sort();
    }"""
    async with opened(browser, await url_of(server)) as page:
        await until_shown(page, "Arm")
        await page.locator("[data-preset=Kinematics]").click()
        assert await page.evaluate(drawn) == ["base", "slider", "upper"]
        await page.get_by_label("hide upper").click()
        assert await page.evaluate(drawn) == ["base", "slider"]
        await page.get_by_label("isolate upper").click()
        assert await page.evaluate(drawn) == ["upper"]
        await page.locator("#show-all").click()
        assert await page.evaluate(drawn) == ["base", "slider", "upper"]
        await page.get_by_label("Search links").fill("LIFT")
        assert await page.locator("#tree .name").all_text_contents() == ["slider  ⇅ lift"]


async def test_joints_move_between_their_configured_limits(browser, server):
    settings = Settings(
        joints={"shoulder": JointProperties(-0.2, 0.4), "lift": JointProperties(0.0, None)}
    )
    async with opened(browser, await url_of(server, settings=settings)) as page:
        await until(page, "kindsl.scene.limits.size === 2")
        slider = page.get_by_label("shoulder", exact=True)
        await until(page, "document.querySelector('[aria-label=shoulder]')?.max === '0.4'")
        assert await slider.get_attribute("min") == "-0.2"
        await typed(page, "shoulder", "1")
        assert await page.locator(".row.beyond .name").inner_text() == "shoulder"
        await typed(page, "shoulder", "0")
        await page.get_by_label("animate shoulder").click()
        await until(page, "Math.abs(kindsl.scene.q.get('shoulder')) > 0.05")
        positions = [await page.evaluate("kindsl.scene.q.get('shoulder')") for _ in range(20)]
        assert all(-0.2 - 1e-9 <= q <= 0.4 + 1e-9 for q in positions)
        assert not await page.evaluate("kindsl.scene.q.get('lift')")
        await page.locator("#animate").click()
        rest = await page.evaluate("kindsl.scene.q.get('shoulder')")
        await eventually(lambda: server.at("robot")._joints.get("shoulder") == rest)


async def test_the_picture_is_saved_with_ground_and_names(page_of_arm):
    page = page_of_arm
    async with page.expect_download() as saving:
        await page.locator("#png").click()
    saved = await saving.value
    assert saved.suggested_filename == "Arm.png"
    assert (await asyncio.to_thread((await saved.path()).read_bytes))[:4] == b"\x89PNG"


async def test_the_title_and_icon_tell_whose_robot_it_is_and_how(browser, server):
    async with opened(browser, await url_of(server)) as page:
        await until(page, "document.title === 'Arm – kindsl preview'")
        analysis = analyse(ARM.replace("slider via lift", "slider via lft"))
        await server.show("robot", analysis, analysis.findings)
        await until(page, "document.title.startsWith('Arm (')")
        await until(page, "document.querySelector('link[rel=icon]').dataset.look === 'error'")
        server.at("robot").lose("arm.kindsl: the file was moved or deleted")
        await page.get_by_text("arm.kindsl: the file was moved or deleted").wait_for()
        await until(page, "document.title.includes('not connected')")
        one = ARM.replace("    children {\n        slider via lift\n    }", "    children {}")
        one = (
            one[: one.index("link slider")] + one[one.index("r_joint shoulder") : one.index("p_j")]
        )
        await url_of(server, one + "\n}\n")
        await until(page, "document.getElementById('dof').textContent.startsWith('1 joint,')")


async def test_values_are_given_to_whoever_can_write_them(browser, server):
    wanted = []
    server.on_write = lambda key, values: wanted.append((key, values)) or "[parameters]\nreach = 1"
    async with opened(browser, await url_of(server, PARAMETRIC_ARM)) as page:
        await until_shown(page, "Arm")
        await page.get_by_text("Write these to kindsl.toml").click()
        await page.locator("dialog[open] pre", has_text="reach = 1").wait_for()
        assert wanted == [("robot", WriteParameters({"reach": 0.5}))]


LONG = (EXAMPLES / "quadruped.kindsl").read_text().replace("LF_thigh", "left_front_thigh_link")
HEIGHTS = """() => ["tree", "joints", "selection"].map((id) => {
  const { top, bottom } = document.getElementById(id).getBoundingClientRect();
  return [top, bottom];
})"""
SHARES = """() => ["panel", "lists", "inspector"].map((id) => {
  const { width, height } = document.getElementById(id).getBoundingClientRect();
  return id === "panel" ? width : height;
})"""


@pytest.fixture(scope="module")
async def page_of_quadruped(browser):
    running = PreviewServer()
    await running.start()
    async with opened(browser, await url_of(running, LONG)) as page:
        await until_shown(page, "Quadruped")
        await resize(page, 1280, 860)
        yield page
    await running.stop()


async def test_what_is_selected_is_told_beside_the_lists(page_of_quadruped):
    page = page_of_quadruped
    before = (await page.evaluate(HEIGHTS))[:2]
    await page.locator("#tree .name", has_text="LF_hip").click()
    await page.locator("#selection h3", has_text="link LF_hip").wait_for()
    *lists, card = await page.evaluate(HEIGHTS)
    assert lists == before
    assert lists[1][1] < card[0] < card[1] < 860
    await page.keyboard.press("Escape")


async def test_bars_share_the_panel_out_and_the_address_keeps_it(page_of_quadruped):
    page = page_of_quadruped
    usual = await page.evaluate(SHARES)
    await page.locator("#divider").wait_for()
    await page.locator("#divider").focus()
    for _ in range(4):
        await page.keyboard.press("ArrowUp")
    _, lists, inspector = await page.evaluate(SHARES)
    assert lists == pytest.approx(usual[1] - 64, abs=8)
    assert lists + inspector == pytest.approx(usual[1] + usual[2], abs=1)
    edge = await page.locator("#edge").bounding_box()
    await page.mouse.move(edge["x"] + 4, 300)
    await page.mouse.down()
    await page.mouse.move(edge["x"] - 156, 300, steps=3)
    await page.mouse.up()
    assert (await page.evaluate(SHARES))[0] == pytest.approx(usual[0] + 160, abs=3)
    await until(page, "location.hash.includes('panel=')")
    await page.locator("#edge").dblclick()
    await page.locator("#divider").dblclick()
    assert await page.evaluate(SHARES) == usual
    await until(page, "!location.hash.includes('panel=')")


async def test_a_pose_gets_a_name(browser, server):
    kept = []
    server.on_write = lambda key, wanted: kept.append((key, wanted)) or ""
    async with opened(browser, await url_of(server)) as page:
        await until_shown(page, "Arm")
        await page.evaluate("kindsl.actions.setJoint('shoulder', 1 / 3)")
        await page.get_by_role("button", name="Keep pose").click()
        name = page.get_by_label("Name", exact=True)
        await name.fill("zero")
        await name.press("Enter")
        assert await page.locator("#keep-pose").is_visible()
        await name.fill(" stand ")
        await name.press("Enter")
        await eventually(lambda: kept)
        assert kept == [("robot", KeepPose("stand", {"shoulder": 0.333333}))]


@pytest.mark.parametrize(("width", "least"), [(200, 70), (360, 80), (1280, 80), (2560, 200)])
async def test_sliders_use_the_width_and_names_keep_their_ends(page_of_quadruped, width, least):
    page = page_of_quadruped
    await resize(page, width, 860)
    slider = await page.get_by_label("LF_HAA", exact=True).bounding_box()
    assert slider["width"] > least
    assert (await page.locator("#joints .row").first.bounding_box())["height"] < 40
    name = page.locator("#tree .name", has_text="left_front_thigh_link")
    ends = [await name.locator(part).bounding_box() for part in (".name", ".end", ".start")[1:]]
    row = await page.locator("#tree").bounding_box()
    assert ends[0]["x"] + ends[0]["width"] < row["x"] + row["width"]
    assert ends[1]["width"] > 5
    await resize(page, 1280, 860)


async def test_a_limit_that_nobody_gave_looks_otherwise(browser, server):
    settings = Settings(
        joints={"shoulder": JointProperties(-0.2, 0.4), "lift": JointProperties(0.0, None)}
    )
    async with opened(browser, await url_of(server, settings=settings)) as page:
        await until(page, "kindsl.scene.limits.size === 2 && document.querySelector('.open-high')")
        looks = "(rows) => rows.map((row) => row.className)"
        assert await page.locator("#joints .row").evaluate_all(looks) == ["row", "row open-high"]


CLIPBOARD = """Object.defineProperty(navigator, "clipboard", {
  configurable: true, value: { writeText: async (text) => { globalThis.copied = text; } },
})"""


async def test_a_copied_link_says_where_and_how_long_it_leads_here(page_of_quadruped):
    page = page_of_quadruped
    await page.evaluate(CLIPBOARD)
    await page.locator("#link").click()
    await page.get_by_text("on this computer only, while this preview runs").wait_for()
    assert "token=" in await page.evaluate("copied")


async def chooser_by_key(page, button):
    """Press Enter on a button until it lets choose a file."""
    choosers = []

    def keep(chooser):
        choosers.append(chooser)

    page.on("filechooser", keep)
    await page.evaluate("null")  # the browser has heard by now that a chooser is awaited
    async with asyncio.timeout(60):
        while not choosers:
            # A busy browser takes a key for no gesture of a user's, and shows no chooser.
            await page.locator(button).wait_for()
            await page.locator(button).press("Enter")
            await asyncio.sleep(1)
    page.remove_listener("filechooser", keep)
    return choosers[0]


async def test_a_motion_is_opened_by_keyboard_and_its_torques_follow_the_robot(browser, server):
    async with opened(browser, await url_of(server)) as page:
        await until_shown(page, "Arm")
        chooser = await chooser_by_key(page, "#play-file")
        rows = "\n".join(f"{0.1 * i},{0.02 * i}" for i in range(20))
        motion = {"name": "wave.csv", "mimeType": "text/csv"}
        await chooser.set_files({**motion, "buffer": f"t,shoulder\n{rows}".encode()})
        await page.get_by_text("wave.csv: 20 samples, 1 joint").wait_for()
        told = """() => kindsl.player.told.textContent && kindslModules["panel/player.js"]
          .torques(kindsl.scene, kindsl.player.trajectory).values[0][0]"""
        before = await page.evaluate(told)
        await page.evaluate("kindsl.player.chart.firstChild.dataset.old = 'yes'")
        await url_of(server, ARM.replace("mass = 1.0", "mass = 3.0"))
        await until(page, "!document.querySelector('#player [data-old]')")
        assert abs(await page.evaluate(told)) > abs(before)
        await page.locator("#player .chart.stale").wait_for(state="detached")
