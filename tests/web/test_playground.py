"""The whole tool in a browser's tab: editor, findings, fixes, preview; nothing leaves the tab."""

import re
from pathlib import Path
from typing import Literal

import pytest
from playwright.sync_api import Browser, BrowserContext, CDPSession
from tests.preview.handles import changed
from tests.support.axe import axe_script
from tests.support.published import published_models
from tests.vscode import models
from tests.web import site
from tests.web.tab import PLACE_CURSOR, SIZE, Tab, fragment

import kindsl
from kindsl.language.text.lines import LineIndex
from kindsl.products.reports.comparison import compared
from kindsl.robots.interchange.format import joints_dropped
from kindsl.robots.interchange.kindsl_writing import written_kindsl
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf

# The first test waits for what is built for all of them.
pytestmark = pytest.mark.timeout(900)
EXAMPLES = Path(__file__).parents[2] / "examples"
BROKEN = (
    models.ARM.replace("lower via elbow", "lower via ellbow")
    .replace("mass = 2.0", "mass = 2")
    .replace("(0.0, 0.0, 0.3)", "(0.0, 0.0, 300.0)")
    .replace("PI/2.0", "90.0")
)


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.kindsl")), ids=lambda path: path.stem)
def test_it_finds_what_the_linter_finds(tab: Tab, path: Path) -> None:
    expect_findings(tab, path)


@pytest.mark.parametrize("path", published_models())
def test_it_finds_the_same_in_published_models(tab: Tab, path: Path) -> None:
    tab.open_beside("kindsl.toml", "")
    expect_findings(tab, path)


def expect_findings(tab: Tab, path: Path) -> None:
    """Show a document and wait for the codes and ranges that the linter finds."""
    document = kindsl.load(path)
    lines = LineIndex(document.text)
    expected = []
    for finding in document.findings:
        start, end = lines.position(finding.start), lines.position(finding.end)
        expected.append([finding.code, start[0] + 1, start[1] + 1, end[0] + 1, end[1] + 1])
    tab.show(path.name.lower(), document.text)
    tab.expect_robot(str(document.model.name))
    tab.eventually(lambda: tab.found() == sorted(expected), f"the findings of {path.name}")


def test_nothing_is_called_checked_before_it_was(tab: Tab) -> None:
    """Neither a text that was just opened, nor one that was just changed."""
    problems, count = tab.page.locator("#problems"), tab.page.locator("#problem-count")
    tab.show("arm.kindsl", models.ARM)
    tab.eventually(lambda: problems.text_content() == "No problems found", "a checked text")
    with tab.held("textDocument/publishDiagnostics"):
        tab.show("broken.kindsl", BROKEN)
        tab.wait_for_held()
        assert (problems.text_content(), count.text_content()) == ("Checking…", "…")
    tab.eventually(lambda: len(tab.found()) == _problems(BROKEN), "its problems")
    tab.eventually(lambda: count.text_content() == str(_problems(BROKEN)), "their count")
    with tab.held("textDocument/publishDiagnostics"):
        tab.page.evaluate("(text) => playground.files.model().setValue(text)", models.ARM)
        tab.wait_for_held()
        assert "No problems found" not in (problems.text_content() or "")
        assert count.text_content() == "…"
    tab.eventually(lambda: problems.text_content() == "No problems found", "a checked text")
    assert count.text_content() == "0"


def test_a_configuration_is_checked_too(tab: Tab) -> None:
    tab.show("kindsl.toml", "[parameters]\n")
    problems = tab.page.locator("#problems")
    tab.eventually(lambda: problems.text_content() == "No problems found", "a checked text")
    tab.page.get_by_title("Close kindsl.toml").click()


@pytest.mark.parametrize("size", [600_000, 3_000_000])
def test_what_is_too_large_is_said(tab: Tab, size: int) -> None:
    """As a file that is opened: with a warning, or not at all."""
    tab.show("arm.kindsl", models.ARM)
    text = models.ARM + size * "/"
    file = {"name": "big.kindsl", "mimeType": "text/plain", "buffer": text.encode()}
    tab.page.locator("#file").set_input_files(files=[file])
    notice = tab.page.locator("#notice")
    tab.eventually(lambda: "large for" in (notice.text_content() or ""), "the sentence")
    tab.eventually(lambda: (tab.text() == text) == (size < 1_000_000), "what is open")
    tab.page.get_by_title("Close this message").click()
    tab.show("arm.kindsl", models.ARM)


@pytest.mark.parametrize("name", ["nosuch", "toString"])
def test_an_unknown_example_is_named(context: BrowserContext, address: str, name: str) -> None:
    tab = Tab(context.new_page())
    tab.page.goto(f"{address}?example={name}")
    tab.wait_for_texts()
    sentence = f"There is no example '{name}'; here is 'quadruped'. There are "
    told = tab.page.locator("#notice").text_content() or ""
    assert told.startswith(sentence)
    assert "broken_arm" in told
    assert tab.text() == (EXAMPLES / "quadruped.kindsl").read_text()


def test_an_address_that_cannot_be_read_is_told(context: BrowserContext, address: str) -> None:
    tab = Tab(context.new_page())
    tab.page.goto(f"{address}#nonsense")
    tab.wait_for_texts()
    told = tab.page.locator("#notice").text_content() or ""
    assert told.startswith("The address holds no texts that can be read")


def test_hover_completion_and_outline_answer(tab: Tab) -> None:
    tab.show("arm.kindsl", models.ARM)
    tab.page.locator("#outline button", has_text="lower").first.click()
    hover = tab.page.locator(".monaco-hover-content").first

    def is_hovered() -> bool:
        return hover.is_visible() and "lower" in (hover.text_content() or "")

    tab.ask_until_seen(lambda: tab.trigger("showHover"), is_hovered, "the hover of a link")
    tab.page.evaluate(PLACE_CURSOR, [3, 20])
    suggested = tab.page.locator(".suggest-widget .monaco-list-row").first
    tab.ask_until_seen(lambda: tab.trigger("triggerSuggest"), suggested.is_visible, "a suggestion")
    tab.page.keyboard.press("Escape")


def test_an_edit_is_drawn_and_formatted(tab: Tab) -> None:
    tab.show("arm.kindsl", models.ARM.replace("Robot arm {", "Robot   other{"))
    tab.expect_robot("other")
    before = tab.text()
    tab.page.locator("#do-format").click()
    tab.eventually(lambda: tab.text() != before, "the formatted text")
    assert "Robot other {" in tab.text()


def test_a_click_in_the_preview_shows_the_source(tab: Tab) -> None:
    tab.show("arm.kindsl", models.ARM)
    tab.expect_robot("arm")
    tab.preview().evaluate("() => kindsl.send({ type: 'reveal', kind: 'link', name: 'lower' })")
    line = models.ARM.partition("link lower")[0].count("\n") + 1
    tab.eventually(
        lambda: tab.page.evaluate("() => playground.editor.getPosition().lineNumber") == line,
        "the cursor at the link",
    )


COUNT_COPIES = """() => new Promise((resolve) => {
    let copies = 0;
    addEventListener("message", ({ data }) => {
        if (data === "last") resolve(copies);
        if (data !== "first") return;
        if (++copies === 1) window.postMessage("last");
    });
    window.postMessage("first");
})"""


def test_a_message_to_the_picture_comes_once(tab: Tab) -> None:
    tab.show("arm.kindsl", models.ARM)
    tab.expect_robot("arm")
    assert tab.preview().evaluate(COUNT_COPIES) == 1


def test_a_dragged_arrow_changes_one_number_and_undo_restores_it(tab: Tab) -> None:
    tab.show("arm.kindsl", models.ARM)
    tab.expect_robot("arm")
    frame = tab.preview()
    frame.locator("#pane").press("7")
    tab.grasp("joint", "elbow")
    tab.drag_arrow("x")
    tab.eventually(lambda: tab.text() != models.ARM, "the text changed by the drag")
    ((old, new),) = changed(models.ARM, tab.text())
    assert old == "0.4"
    assert re.fullmatch(r"0\.\d\d?", new)
    tab.page.evaluate("() => playground.editor.focus()")
    tab.page.keyboard.press("Control+z")
    tab.eventually(lambda: tab.text() == models.ARM, "the text as it was")


def test_the_configuration_beside_the_text_holds(tab: Tab) -> None:
    tab.show("arm.kindsl", models.ARM.replace("(0.4, 0.0, 0.0)", "(reach, 0.0, 0.0)"))
    tab.eventually(lambda: [code for code, *_ in tab.found()] == ["KD401"], "KD401")
    tab.open_beside("kindsl.toml", "parameters = { reach = 0.4 }")
    tab.eventually(lambda: not tab.found(), "no finding any more")
    tab.page.get_by_title("Close kindsl.toml").click()
    tab.eventually(lambda: [code for code, *_ in tab.found()] == ["KD401"], "KD401 again")


def test_a_new_robot_replaces_no_other(tab: Tab) -> None:
    tab.open_beside("spare.kindsl", models.ARM)
    tab.page.locator("#do-new").click()
    tab.page.evaluate("() => playground.files.model().setValue('mine')")
    tab.page.get_by_title("Close spare.kindsl").click()
    tab.page.locator("#do-new").click()
    assert tab.text() != "mine"
    assert "mine" in tab.page.evaluate("() => Object.values(playground.files.texts())")


URDF = site.ROOT / "docs" / "guide" / "pan_tilt.urdf"


def test_a_urdf_is_opened_as_a_document_and_downloaded_again(tab: Tab, tmp_path: Path) -> None:
    tab.page.locator("#file").set_input_files(URDF)
    tab.expect_robot("pan_tilt")
    assert tab.page.locator("#tabs [aria-selected=true]").inner_text().startswith("pan_tilt.kindsl")
    written = written_kindsl(robot_of_urdf(URDF.read_bytes(), "robot"))
    assert tab.text() == written.text
    remarks = tab.page.locator("#notice li").all_inner_texts()
    assert remarks == [*written.remarks, joints_dropped(written.joints)]
    tab.page.screenshot(path=site.shot("playground-urdf"))
    with tab.page.expect_download() as downloading:
        tab.page.locator("#do-urdf").click()
    assert downloading.value.suggested_filename == "pan_tilt.urdf"
    downloading.value.save_as(tmp_path / "again.urdf")
    content = (tmp_path / "again.urdf").read_bytes()
    again = kindsl.parse(written_kindsl(robot_of_urdf(content, "robot")).text)
    found = compared(kindsl.parse(tab.text()), again)
    assert found.difference is not None and found.difference.is_empty
    message = tab.page.locator("#message")
    tab.eventually(
        lambda: "2 revolute joints got limits" in message.inner_text(), "what the URDF adds"
    )
    tab.page.locator("#file").set_input_files(URDF)
    tab.page.locator("#tabs [role=tab]", has_text="pan_tilt_2.kindsl").wait_for()


def test_a_bad_urdf_is_one_sentence_with_its_line(tab: Tab, tmp_path: Path) -> None:
    tab.show("arm.kindsl", models.ARM)
    bad = tmp_path / "bad.urdf"
    bad.write_text(URDF.read_text().replace('xyz="0 0 0.05"', 'xyz="0 0.05"'))
    tab.page.locator("#file").set_input_files(bad)
    told = "bad.urdf: line 5: <origin> has 2 numbers in 'xyz', not 3"
    notice = tab.page.locator("#notice p")
    tab.eventually(lambda: notice.text_content() == told, told)
    assert tab.text() == models.ARM
    tab.page.locator("#notice .close").click()
    assert notice.is_hidden()


def test_two_open_texts_are_compared_as_texts_and_as_robots(tab: Tab) -> None:
    heavier = models.ARM.replace("mass = 2.0", "mass = 2.5")
    assert heavier != models.ARM
    tab.open_beside("heavier.kindsl", heavier)
    tab.show("arm.kindsl", models.ARM)
    tab.page.locator("#do-compare").click()
    tab.page.locator("#old-side").select_option("heavier.kindsl")
    changes = tab.page.locator("#changes")
    tab.eventually(lambda: "mass 2.5 -> 2 kg" in changes.inner_text(), "the lighter link")
    tab.page.locator("#difference .line-delete:visible").first.wait_for()
    tab.page.screenshot(path=site.shot("playground-comparison"))
    tab.page.evaluate("(text) => playground.files.model().setValue(text)", heavier)
    tab.eventually(lambda: changes.inner_text() == "Nothing changed mechanically", "no change")
    tab.page.locator("#old-side").select_option("arm.kindsl as it was opened")
    tab.eventually(lambda: "mass 2 -> 2.5 kg" in changes.inner_text(), "the heavier link")
    tab.page.locator("#end-comparison").click()
    assert tab.page.locator("#editor").is_visible()


def test_a_comparison_ends_with_one_of_its_texts(tab: Tab) -> None:
    tab.open_beside("other.kindsl", models.ARM.replace("Robot arm", "Robot other"))
    tab.show("arm.kindsl", models.ARM)
    tab.page.locator("#do-compare").click()
    tab.page.locator("#old-side").select_option("other.kindsl")
    tab.page.locator("#difference .line-delete:visible").first.wait_for()
    complaints = len(tab.complaints)
    tab.page.get_by_title("Close other.kindsl").click()
    assert tab.page.locator("#editor").is_visible()
    assert tab.complaints[complaints:] == []


def test_nothing_but_its_own_host_is_asked(tab: Tab, address: str, playground: Path) -> None:
    tab.page.screenshot(path=site.shot("playground"))
    strangers = [url for url in tab.requests if not url.startswith((address, "blob:", "data:"))]
    assert strangers == []
    html = (playground / "index.html").read_text()
    policy = re.search(r'Security-Policy" content="([^"]+)"', html)
    assert policy is not None
    assert "'unsafe-eval'" not in policy[1]
    assert "http" not in policy[1]
    assert not [text for text in tab.complaints if "Content Security Policy" in text]


def test_a_shared_link_is_fixed_by_quick_fixes_and_drawn(browser: Browser, address: str) -> None:
    page = browser.new_page(viewport={"width": 1400, "height": 850}, color_scheme="dark")
    tab = Tab(page)
    tab.open(f"{address}#{fragment('arm.kindsl', {'arm.kindsl': BROKEN})}")
    problems = page.locator("#problem-count")
    tab.eventually(lambda: problems.text_content() == str(_problems(BROKEN)), "all problems")
    taken = []
    while tab.found():
        known = tab.found()
        taken.append(tab.fix_first())
        tab.eventually(lambda known=known: tab.found() != known, "fewer problems")
    assert not [title for title in taken if title.startswith("Ignore")]
    tab.expect_robot("arm")
    drawn = "() => [kindsl.scene.trees.robot.links.size, kindsl.inbox.status.state]"
    tab.eventually(lambda: tab.preview().evaluate(drawn) == [3, "live"], "the whole arm")
    page.screenshot(path=site.shot("playground-fixed"))
    page.locator("#do-share").click()
    tab.eventually(lambda: len(page.url) > len(address) + 100, "the text in the address")
    page.close()


def test_it_works_without_a_network_later(browser: Browser, playground: Path) -> None:
    context = browser.new_context(viewport={"width": 390, "height": 780})
    tab = Tab(context.new_page())
    with site.served(playground) as address:
        tab.open(address)
        state = "async () => (await navigator.serviceWorker.ready).active.state"
        tab.eventually(lambda: tab.page.evaluate(state) == "activated", "the service worker")
    tab.page.reload()
    tab.page.locator("body[data-state=ready]").wait_for()
    tab.page.get_by_role("button", name="Robot", exact=True).click()
    tab.expect_robot("Quadruped")
    tab.page.screenshot(path=site.shot("playground-phone"))
    context.close()


def test_a_spoilt_memory_image_is_done_without(
    browser: Browser, playground: Path, tmp_path: Path
) -> None:
    for file in playground.rglob("*"):
        copy = tmp_path / file.relative_to(playground)
        if file.is_dir():
            copy.mkdir()
        elif file.name != "server.snap.gz":
            copy.symlink_to(file)
    (tmp_path / "server" / "server.snap.gz").write_bytes(b"no image")
    with site.served(tmp_path) as address:
        tab = Tab(browser.new_page())
        tab.open(f"{address}?worker=off")
        assert (tab.page.locator("body").get_attribute("data-start") or "").startswith("zips")
        tab.expect_robot("Quadruped")
        tab.page.close()


AXE = """async () => (await axe.run(document)).violations.map(({ id, nodes }) =>
    [id, ...nodes.map(({ html }) => html.slice(0, 120))])"""
SCHEMES: tuple[Literal["light", "dark"], ...] = ("light", "dark")
EDITOR_IS = """(scheme) => document.querySelector(".monaco-editor").classList
    .contains(scheme === "dark" ? "vs-dark" : "vs")"""


def test_axe_finds_nothing(browser: Browser, address: str) -> None:
    page = browser.new_page(viewport=SIZE)
    tab = Tab(page)
    tab.open(f"{address}?example=broken_arm")
    tab.eventually(tab.found, "the problems")
    page.evaluate(axe_script())
    papers = set()
    for scheme in SCHEMES:
        page.emulate_media(color_scheme=scheme)
        page.wait_for_function(EDITOR_IS, arg=scheme)
        papers.add(page.evaluate("() => getComputedStyle(document.body).backgroundColor"))
        assert page.evaluate(AXE) == []
    assert len(papers) == len(SCHEMES)
    page.close()


WIDTHS = """() => [document.getElementById("text"), document.getElementById("preview")
    .contentDocument.getElementById("pane")].map((one) => one.getBoundingClientRect().width)"""


def test_the_picture_is_as_wide_as_the_text(tab: Tab) -> None:
    text, picture = tab.page.evaluate(WIDTHS)
    assert text == pytest.approx(picture, rel=0.03)


def test_tabs_are_reached_by_keys(tab: Tab) -> None:
    tab.show("arm.kindsl", models.ARM)
    selected = tab.page.locator("#tabs [aria-selected=true]")
    selected.press("ArrowLeft")
    former = selected.inner_text()
    assert former != "arm.kindsl"
    assert tab.page.evaluate("() => document.activeElement.textContent") == former
    selected.press("ArrowRight")
    assert selected.inner_text() == "arm.kindsl"


def test_it_is_told_how_much_is_loaded(tab: Tab) -> None:
    said = tab.page.evaluate("() => said")
    shares = [
        (int(done), int(total))
        for text in said
        for done, total in re.findall(r"Loading Python: (\d+) MB of (\d+)", text)
    ]
    assert shares == sorted(shares)
    assert shares[0][0] < 10 < shares[-1][0]
    assert "Starting Python…" in said


def swipe(touches: CDPSession, y: float) -> None:
    """Touch at a height of the page, move to the right and let go."""
    for name, x in [("touchStart", 120), ("touchMove", 160), ("touchMove", 210), ("touchEnd", 0)]:
        points = [{"x": x, "y": y}] if x else []
        touches.send("Input.dispatchTouchEvent", {"type": name, "touchPoints": points})


def test_a_phone_shows_and_turns_a_shared_robot(browser: Browser, address: str) -> None:
    context = browser.new_context(
        viewport={"width": 390, "height": 780}, has_touch=True, is_mobile=True
    )
    tab = Tab(context.new_page())
    tab.open(f"{address}#{fragment('arm.kindsl', {'arm.kindsl': models.ARM})}")
    tab.expect_robot("arm")
    box = tab.page.locator("#preview").bounding_box()
    assert box is not None and box["width"] == 390
    eye = "() => kindsl.camera.state().position"
    tab.preview().wait_for_function("() => kindsl.scene.trees.robot.links.size === 3")
    before = tab.preview().evaluate(eye)
    touches = context.new_cdp_session(tab.page)
    middle = box["y"] + 120
    tab.ask_until_seen(
        lambda: swipe(touches, middle),
        lambda: tab.preview().evaluate(eye) != before,
        "another view",
    )
    tab.page.screenshot(path=site.shot("phone-robot"))
    tab.page.get_by_role("button", name="Text", exact=True).click()
    assert tab.page.evaluate("() => document.documentElement.scrollWidth") <= 390
    tab.page.screenshot(path=site.shot("phone-text"))
    context.close()


def _problems(text: str) -> int:
    return len(kindsl.parse(text).findings)
