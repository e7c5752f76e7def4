"""What was typed into the playground is there again, and nothing takes its place unasked."""

from pathlib import Path

import pytest
from playwright.sync_api import BrowserContext
from tests.vscode import models
from tests.web import site
from tests.web.tab import Tab, fragment

# The first test waits for what is built for all of them.
pytestmark = pytest.mark.timeout(900)
MINE = models.ARM.replace("Robot arm", "Robot mine")
TYPE = "([name, text]) => playground.files.model(name).setValue(text)"
TEXTS = "() => playground.files.texts()"
NO_STORAGE = """Object.defineProperty(window, "localStorage", { get() { throw new Error("no"); } });
window.stays = () => !dispatchEvent(new Event("beforeunload", { cancelable: true }));"""


def opened(context: BrowserContext, address: str) -> Tab:
    """Open the playground in a new tab; its server does not run."""
    tab = Tab(context.new_page())
    tab.page.goto(address)
    tab.wait_for_texts()
    return tab


def put(tab: Tab, name: str, text: str) -> None:
    """Change a text as typing would."""
    tab.page.evaluate(TYPE, [name, text])


def told(tab: Tab) -> str:
    return tab.page.locator("#notice").inner_text()


def test_what_was_typed_is_there_after_a_reload_and_on_another_day(
    context: BrowserContext, address: str
) -> None:
    tab = opened(context, address)
    put(tab, "quadruped.kindsl", MINE)
    tab.page.locator("#do-new").click()
    before = tab.page.evaluate(TEXTS)
    tab.page.reload()
    tab.wait_for_texts()
    assert tab.page.evaluate(TEXTS) == before
    assert tab.page.evaluate("() => playground.files.active") == "robot.kindsl"
    assert told(tab).startswith("Restored as you left it, ")
    tab.page.close()
    later = opened(context, address)
    assert later.page.evaluate(TEXTS) == before
    later.page.screenshot(path=site.shot("playground-restored"))
    later.page.get_by_role("button", name="Start over").click()
    later.page.wait_for_function("() => window.playground?.files.names().length === 2")
    assert "Robot mine" not in later.text()


def test_a_visit_that_changes_nothing_leaves_nothing(context: BrowserContext, address: str) -> None:
    tab = opened(context, address)
    tab.page.reload()
    tab.wait_for_texts()
    assert tab.page.locator("#notice").is_hidden()


def test_two_tabs_keep_each_its_own(context: BrowserContext, address: str) -> None:
    one, other = opened(context, address), opened(context, address)
    put(one, "quadruped.kindsl", MINE)
    put(other, "quadruped.kindsl", models.OTHER)
    for tab, text in ((one, MINE), (other, models.OTHER)):
        tab.page.reload()
        tab.wait_for_texts()
        assert tab.text() == text


def test_a_shared_link_and_ones_own_texts_leave_each_other_alone(
    context: BrowserContext, address: str
) -> None:
    own = opened(context, address)
    put(own, "quadruped.kindsl", MINE)
    own.page.close()
    link = f"{address}#{fragment('arm.kindsl', {'arm.kindsl': models.ARM})}"
    shared = opened(context, link)
    assert shared.page.evaluate(TEXTS) == {"arm.kindsl": models.ARM}
    put(shared, "arm.kindsl", models.OTHER)
    shared.page.reload()
    shared.wait_for_texts()
    assert shared.text() == models.OTHER
    # Another link in the same tab.
    shared.page.evaluate("(hash) => { location.hash = hash; }", fragment("b.kindsl", {"b": MINE}))
    shared.page.wait_for_function("() => window.playground?.files.names()[0] === 'b.kindsl'")
    assert opened(context, address).text() == MINE


def test_what_is_opened_replaces_no_work(
    context: BrowserContext, address: str, tmp_path: Path
) -> None:
    tab = opened(context, address)
    put(tab, "quadruped.kindsl", MINE)
    tab.page.locator("#examples").select_option("quadruped")
    assert tab.text() == MINE
    file = tmp_path / "quadruped.kindsl"
    file.write_text(models.OTHER)
    tab.page.locator("#file").set_input_files(file)
    tab.eventually(lambda: tab.text() == models.OTHER, "the file")
    assert tab.page.evaluate(TEXTS)["quadruped.kindsl"] == MINE
    (tmp_path / "kindsl.toml").write_text("[parameters]\na = 2.0\n")
    put(tab, "kindsl.toml", "[parameters]\na = 1.0\n")
    tab.page.locator("#file").set_input_files(tmp_path / "kindsl.toml")
    tab.page.get_by_text("Take the former").click()
    tab.eventually(lambda: "a = 1.0" in tab.text(), "the former configuration")


def test_a_changed_text_that_is_closed_can_be_opened_again(
    context: BrowserContext, address: str
) -> None:
    tab = opened(context, address)
    put(tab, "quadruped.kindsl", MINE)
    tab.page.get_by_title("Close quadruped.kindsl").click()
    assert told(tab).startswith("quadruped.kindsl is closed.")
    tab.page.get_by_text("Open it again").click()
    assert tab.text() == MINE


def test_a_browser_that_keeps_nothing_asks_before_it_leaves(
    context: BrowserContext, address: str
) -> None:
    context.add_init_script(NO_STORAGE)
    tab = opened(context, address)
    assert not tab.page.evaluate("() => stays()")
    put(tab, "quadruped.kindsl", MINE)
    tab.eventually(lambda: "does not keep your texts" in told(tab), "a warning")
    assert tab.page.evaluate("() => stays()")
