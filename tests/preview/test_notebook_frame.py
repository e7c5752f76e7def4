"""What a notebook shows of a document runs in its own frame, apart from the notebook."""

import html
import re

from tests.preview.browser import IS_SHOWN, TIMEOUT
from tests.preview.robots import plain_robot

import kindsl
from kindsl.judgement.analysis.settings import Settings


async def test_the_frame_draws_the_robot_and_asks_nobody(browser, tmp_path):
    document = kindsl.parse(plain_robot(3, 1).text, Settings())
    file = tmp_path / "notebook.html"
    file.write_text(
        f'<meta charset="utf-8">{kindsl.live(document)._repr_html_()}', encoding="utf-8"
    )
    page = await browser.new_page()
    page.set_default_timeout(TIMEOUT)
    requests, errors = [], []
    page.on("request", lambda request: requests.append(request.url))
    page.on("pageerror", lambda error: errors.append(str(error)))
    await page.goto(file.as_uri())
    frame = next(frame for frame in page.frames if frame is not page.main_frame)
    await frame.wait_for_function("typeof kindsl !== 'undefined'")
    await frame.wait_for_function(IS_SHOWN, arg=str(document.model.name))
    await frame.wait_for_function("kindsl.viewer.renderer.info.render.calls > 0")
    assert [u for u in requests if not u.startswith(("file:", "about:", "data:", "blob:"))] == []
    assert errors == []
    await page.close()


def test_the_frame_cannot_reach_the_notebook():
    shown = kindsl.live(kindsl.parse(plain_robot(3, 1).text, Settings()))._repr_html_()
    (sandbox,) = re.findall(r'<iframe sandbox="([^"]*)"', shown)
    assert sandbox == "allow-scripts"
    assert "default-src 'none'" in html.unescape(shown)
