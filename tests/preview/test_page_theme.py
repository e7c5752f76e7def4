"""Light and dark, the editor's colours, narrow panels, and what axe-core says of the page."""

import pytest
from tests.preview.browser import opened, resize, until, until_shown
from tests.preview.robots import ARM, EXAMPLES
from tests.support.axe import axe_script

from kindsl.judgement.analysis.analysis import analyse


async def url_of(server):
    await server.show("robot", analyse(ARM), ())
    return server.url("robot")


IS_DARK = "kindsl.scene.colors === kindslModules['picture/palette.js'].DARK"
THEME = """(kind) => kindsl.theme.take({ kind, colors: {
  paper: "#002b36", sky: "#002b36", ink: "red; background: url(x)", sneaky: "#fff",
} })"""


async def test_an_editors_colours_are_taken_by_known_names_and_plain_values(browser, server):
    async with opened(browser, await url_of(server)) as page:
        await page.evaluate(THEME, "light")
        style = await page.evaluate("document.documentElement.getAttribute('style')")
        assert "--sky: #002b36" in style
        assert "url" not in style
        assert "sneaky" not in style
        # A dark ground needs light marks, whatever the theme is called.
        assert await page.evaluate(IS_DARK)
        await page.evaluate(POST_THEME)
        assert await page.evaluate(IS_DARK)


# A page's own message is none of an editor's. Heard by the page before by us, who listen later.
POST_THEME = """() => new Promise((heard) => {
  addEventListener("message", heard, { once: true });
  postMessage({ type: "kindsl.theme", kind: "light", colors: {} }, "*");
})"""


@pytest.mark.parametrize("width", [200, 240, 1280])
async def test_the_panel_is_usable_at_any_width(browser, server, width):
    async with opened(browser, await url_of(server)) as page:
        await until_shown(page, "Arm")
        await resize(page, width, 700)
        slider = await page.get_by_label("shoulder", exact=True).bounding_box()
        assert slider["width"] > 60
        assert await page.evaluate("document.documentElement.scrollWidth") <= width
        await page.locator("#close-panel").click()
        assert (await page.locator("#pane").bounding_box())["height"] == 700
        await page.locator("#open-panel").click()
        await page.locator("#panel").wait_for()


async def test_the_address_tells_the_theme_before_there_is_a_robot(browser, server):
    await server.show("robot", analyse(""), ())
    async with opened(browser, f"{server.url('robot')}#theme=dark") as page:
        await until(page, IS_DARK)


async def test_the_first_press_changes_what_is_seen(browser, server):
    await server.show("robot", analyse((EXAMPLES / "fancy.kindsl").read_text()), ())
    async with opened(browser, server.url("robot")) as page:
        assert await page.locator("#theme").inner_text() == "Use dark"
        await page.locator("#theme").click()
        await until(page, IS_DARK)
        assert await page.locator("#theme").inner_text() == "Use light"
        await page.locator("#theme").click()
        assert await page.locator("#theme").inner_text() == "Use auto"


async def axe_findings(page):
    found = await page.evaluate("axe.run(document)")
    return [(one["id"], [n["html"][:120] for n in one["nodes"]]) for one in found["violations"]]


@pytest.mark.parametrize("theme", ["light", "dark"])
async def test_axe_finds_nothing(browser, server, theme, axe):
    analysis = analyse((EXAMPLES / "fancy.kindsl").read_text())
    await server.show("robot", analysis, analysis.findings)
    async with opened(browser, f"{server.url('robot')}#theme={theme}") as page:
        await until(page, "kindsl.history.present !== null")
        await page.evaluate(axe)
        await page.evaluate("kindsl.player.load('wave.csv', 'time,jA\\n0,0\\n1,0.5')")
        await page.locator("[data-category=torque]").check()
        await page.locator("#tree .name").first.click()
        if await page.locator("#summary").is_visible():
            await page.locator("#summary").click()
        for width in (360, 768, 1920):
            await resize(page, width, 860)
            assert await axe_findings(page) == []
        await page.locator("#help").click()
        assert await axe_findings(page) == []
        await page.keyboard.press("Escape")
        await page.get_by_role("button", name="Keep pose").click()
        assert await axe_findings(page) == []


@pytest.fixture(scope="module")
def axe():
    return axe_script()
