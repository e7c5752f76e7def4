"""The exported page works from the file system, without a server and without a network."""

import base64
import hashlib
import re

import numpy as np
import pytest
import umsgpack
from tests.preview.browser import PAINTED, WORLD_POSES, opened, until, until_shown
from tests.preview.robots import ARM, mechanics_of, plain_robot, skeleton_in, skeleton_of

from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.export import exported_page
from kindsl.judgement.analysis.analysis import analyse
from kindsl.robots.scene.encoding import as_dict
from kindsl.robots.scene.formulas import formula_messages


def exported(analysis):
    preview = DocumentPreview("robot")
    preview.show(analysis, ())
    return exported_page(preview.channel.state)


async def test_it_works_from_the_file_system(browser, tmp_path):
    analysis = plain_robot(7, 2)
    file = tmp_path / "robot.html"
    file.write_text(exported(analysis), encoding="utf-8")
    mechanics = mechanics_of(skeleton_in(analysis))
    q = np.random.default_rng(1).uniform(-2.0, 2.0, 7)
    async with opened(browser, file.as_uri()) as page:
        requests = []
        page.on("request", lambda request: requests.append(request.url))
        await until_shown(page, str(analysis.model.name))
        numbers = page.locator("#joints .number")
        await numbers.nth(6).wait_for()
        for index, value in enumerate(q.tolist()):
            await numbers.nth(index).fill(repr(value))
            await numbers.nth(index).press("Enter")
        drawn = await page.evaluate(WORLD_POSES)
        for name, pose in mechanics.forward_kinematics(q).items():
            found = drawn.get(f"links {name}", drawn.get(f"frames {name}"))
            np.testing.assert_allclose(np.reshape(found, (4, 4)), pose, atol=1e-6)
        assert (await page.evaluate(PAINTED))["body"] > 100
        assert requests == []


def test_only_its_own_scripts_may_run():
    page = exported(analyse(ARM))
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', page).group(1)
    scripts = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
    digests = [hashlib.sha256(script.encode()).digest() for script in scripts]
    hashes = {f"'sha256-{base64.b64encode(digest).decode()}'" for digest in digests}
    directives = dict(part.strip().split(" ", 1) for part in policy.split(";"))
    assert set(directives["script-src"].split()) == hashes
    assert directives["default-src"] == "'none'"
    assert "connect-src" not in directives


def test_it_reaches_for_nothing_outside():
    page = exported(analyse(ARM))
    outside = re.sub(r"<script.*?</script>|<style>.*?</style>", "", page, flags=re.DOTALL)
    assert not re.search(r"(?:src|href)=\"(?!data:,)", outside)


def test_the_state_is_in_it_once():
    page = exported(analyse(ARM))
    data = base64.b64decode(re.search(r'id="embedded-state"[^>]*>([^<]*)<', page).group(1))
    change = umsgpack.unpackb(data)
    assert (change["type"], change["is_whole"]) == ("change", True)
    messages = change["parts"]
    keys = [(message["path"], message["type"]) for message in messages]
    assert len(keys) == len(set(keys))
    joints = [message["name"] for message in messages if message["type"] == "joint"]
    assert joints == list(skeleton_of(ARM).joint_names)


PARAMETRIC = (
    ARM.replace("(0.4, 0.0, 0.0)", "(reach[0.4], 0.0, -reach[0.4]/2.0)")
    .replace("(-PI/2.0, 0.0, 0.0)", "(-PI/2.0, 2.0*tilt[0.1], 0.0)")
    .replace("translation = (0.0, 0.0, 0.3)", "translation = (0.0, rise[0.05], 0.3)")
)


def with_formulas(analysis):
    preview = DocumentPreview("robot")
    preview.show(analysis, ())
    formulas = formula_messages(analysis.model, analysis.context.values)
    return exported_page([*preview.channel.state, *formulas])


async def test_its_parameters_move_what_depends_on_them(browser, tmp_path):
    analysis = analyse(PARAMETRIC)
    file = tmp_path / "arm.html"
    file.write_text(with_formulas(analysis), encoding="utf-8")
    values = {"reach": 0.55, "tilt": -0.4, "rise": 0.2}
    skeleton = skeleton_in(analysis, values)
    async with opened(browser, file.as_uri()) as page:
        await until_shown(page, "Arm")
        for name, value in values.items():
            await page.get_by_label(f"{name}, typed").fill(str(value))
            await page.get_by_label(f"{name}, typed").press("Enter")
        drawn = await page.evaluate(WORLD_POSES)
        for name, pose in mechanics_of(skeleton).forward_kinematics([0.0, 0.0]).items():
            found = drawn.get(f"links {name}", drawn.get(f"frames {name}"))
            np.testing.assert_allclose(np.reshape(found, (4, 4)), pose, atol=1e-6)
        rod = await page.evaluate(
            """() => Math.hypot(...kindsl.scene.marks.byPath.get(
              "/kindsl/robot/links/upper/body/segment-lift").local.elements.slice(4, 7))"""
        )
        assert rod == pytest.approx(np.linalg.norm(skeleton.placements[1].translation))
        await page.locator("#parameters .row", has_text="reach").locator(".reset").click()
        await until(page, "kindsl.scene.trees.robot.joints.get('lift').placement[12] === 0.4")


def test_formulas_are_those_of_the_document():
    analysis = analyse(PARAMETRIC)
    formulas = {
        m.name: as_dict(m) for m in formula_messages(analysis.model, analysis.context.values)
    }
    assert set(formulas) == {"lift", "tool"}
    assert formulas["lift"]["translation"] == [
        (0.0, (("reach", 1.0),)), (0.0, ()), (0.0, (("reach", -0.5),)),
    ]  # fmt: skip
    assert formulas["lift"]["rotation"][1] == (0.0, (("tilt", 2.0),))
    assert formulas["tool"]["rod"] == "/kindsl/robot/links/slider/body/segment-tool"
