"""Compare is a mode of the page: any file, a twin, the saved version; numbers and picture."""

import pytest
from tests.preview.browser import eventually, opened, until, until_shown
from tests.preview.page import Page
from tests.preview.robots import ARM

from kindsl.frontends.preview.comparing import LAST_SAVED, document_robot, file_robot
from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.requests import BadRequestError, Compare, parse_request
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.robots.comparison.twins import TwinFile
from kindsl.robots.interchange.format import ORDINARY
from kindsl.robots.interchange.registry import format_named

LONGER = ARM.replace("translation = (0.4, 0.0", "translation = (0.6, 0.0")
HEAVIER = ARM.replace("mass = 2.0", "mass = 2.5")
# Sideways, of the ghost's base.
ASIDE = "kindsl.scene.poses.ghost.links.get('base')?.[12]"


DEFAULT = Settings()


def urdf_of(text):
    written = format_named("urdf").write("arm", analyse(text).skeleton(), ORDINARY)
    return written.text


def page_of(preview):
    return Page(preview.channel.state)


def shown(text, settings=DEFAULT):
    preview = DocumentPreview("arm.kindsl")
    analysis = analyse(text, settings)
    preview.show(analysis, ())
    return preview


def comparison(preview):
    return page_of(preview).at("/kindsl/comparison").get("comparison")


def ghost_kind(preview):
    return page_of(preview).at("/kindsl/ghost").get("ghost", {}).get("kind")


@pytest.fixture
def urdf(tmp_path):
    file = tmp_path / "arm.urdf"
    file.write_text(urdf_of(ARM))
    return file


def test_another_format_is_compared_by_its_numbers_with_their_lines(urdf):
    preview = shown(HEAVIER)
    preview.compare(file_robot("arm.urdf", str(urdf)))
    told = comparison(preview)
    assert (told["own"], told["other"], told["is_equal"]) == ("arm.kindsl", "arm.urdf", False)
    (row,) = told["rows"]
    assert (row["kind"], row["quantity"], row["here"], row["there"]) == ("link", "mass", 2.5, 2.0)
    assert row["line"] == 1 + HEAVIER[: HEAVIER.index("mass = 2.5")].count("\n")
    assert f"in arm.kindsl (line {row['line']})" in row["message"]
    assert ghost_kind(preview) == "other"


def test_typing_compares_anew_and_choosing_none_ends_it(urdf):
    preview = shown(ARM)
    preview.compare(file_robot("arm.urdf", str(urdf)))
    assert comparison(preview)["is_equal"]
    preview.show(analyse(LONGER), ())
    assert [row["name"] for row in comparison(preview)["rows"]] == ["lift"]
    preview.choose_other("")
    assert (comparison(preview), ghost_kind(preview)) == (None, None)


def test_a_twin_is_offered_and_the_saved_version_too(urdf):
    twin = TwinFile(str(urdf), "../arm.urdf")
    preview = shown(HEAVIER, Settings(twins=(twin,)))
    preview.keep_as_ghost()
    page = page_of(preview)
    names = [m.name for key, m in page.state.items() if key.type == "other"]
    assert names == ["../arm.urdf", LAST_SAVED]
    preview.choose_other("../arm.urdf")
    assert len(comparison(preview)["rows"]) == 1
    preview.choose_other(LAST_SAVED)
    assert comparison(preview)["is_equal"]
    preview.choose_other("another.urdf")
    assert comparison(preview) is None


def test_only_the_saved_version_is_called_so(urdf):
    preview = shown(ARM)
    preview.keep_as_ghost()
    preview.show(analyse(LONGER), ())
    assert ghost_kind(preview) == "saved"
    preview.show_plan(analyse(HEAVIER))
    assert ghost_kind(preview) == "planned"
    preview.show_plan(None)
    preview.compare(file_robot("arm.urdf", str(urdf)))
    assert ghost_kind(preview) == "other"


@pytest.mark.parametrize(("text", "why"), [("<robot", "is no XML"), ("<robot name='x'/>", "link")])
def test_a_file_that_cannot_be_read_is_told_in_a_sentence(tmp_path, text, why):
    file = tmp_path / "broken.urdf"
    file.write_text(text)
    preview = shown(ARM)
    preview.compare(file_robot("broken.urdf", str(file)))
    told = comparison(preview)
    assert told["verdict"].startswith("broken.urdf: ")
    assert not told["rows"]
    assert ghost_kind(preview) is None


def test_a_broken_document_keeps_its_last_comparison(urdf):
    preview = shown(HEAVIER)
    preview.compare(file_robot("arm.urdf", str(urdf)))
    before = comparison(preview)
    preview.show(analyse(HEAVIER.replace("slider via lift", "slider via", 1)), ())
    assert comparison(preview) == before


@pytest.mark.parametrize(
    ("text", "request_"),
    [
        ('{"type": "compare", "name": "a.urdf"}', Compare("a.urdf")),
        ('{"type": "compare", "name": ""}', Compare("")),
    ],
)
def test_a_page_chooses_by_name(text, request_):
    assert parse_request(text) == request_


@pytest.mark.parametrize("text", ['{"type": "compare", "name": 3}', '{"type": "compare"}'])
def test_a_choice_without_a_name_is_refused(text):
    with pytest.raises(BadRequestError, match=r"@ \$\.name"):
        parse_request(text)


async def test_the_page_shows_both_swaps_them_and_frames_what_differs(browser, server, urdf):
    await server.show(
        "robot", analyse(LONGER.replace("mass = 2.0", "mass = 2.5")), (), "arm.kindsl"
    )
    server.at("robot").compare(file_robot("arm.urdf", str(urdf)))
    async with opened(browser, server.url("robot")) as page:
        await until_shown(page, "Arm")
        await until(page, "document.querySelectorAll('#compare tbody tr').length === 2")
        assert (
            await page.locator("#compare .verdict").inner_text()
            == "The mechanics differ: 2 numbers"
        )
        assert await page.locator("#compare th.side").all_inner_texts() == [
            "arm.kindsl",
            "arm.urdf",
        ]
        assert (
            await page.locator("[data-category=ghost] ~ .title").inner_text() == "Ghost (arm.urdf)"
        )
        assert await page.evaluate(ASIDE) == 0

        await page.locator("[data-way=beside]").click()
        await until(page, f"{ASIDE} > 0.1")
        assert await page.locator(".compared:visible").all_inner_texts() == [
            "arm.kindsl",
            "arm.urdf",
        ]
        await page.locator("#compare .swap").click()
        assert await page.locator("#compare th.side").all_inner_texts() == [
            "arm.urdf",
            "arm.kindsl",
        ]

        await page.locator("#compare td button", has_text="lift").click()
        await until(page, "kindsl.selection.chosen?.name === 'lift'")
        assert "beside%2Cswapped" in await page.evaluate("kindsl.address.text()")

        await page.locator("#compare select").select_option("")
        await until(page, "kindsl.scene.trees.ghost.links.size === 0")
        await until(page, "document.querySelector('#compare .verdict').hidden")
        await page.locator("#compare select").select_option("arm.urdf")
        await until(page, f"{ASIDE} > 0.1")


async def test_a_change_of_the_other_file_is_seen(server, urdf):
    await server.show("robot", analyse(ARM), ())
    server.at("robot").compare(file_robot("arm.urdf", str(urdf)))
    preview = server.document(None)
    await eventually(lambda: (comparison(preview) or {}).get("is_equal"))
    urdf.write_text(urdf_of(HEAVIER))
    server.at("robot").recompare()
    await eventually(lambda: not comparison(preview)["is_equal"])


def test_a_document_beside_itself_is_equal():
    analysis = analyse(ARM)
    preview = shown(ARM)
    preview.compare(document_robot("same.kindsl", lambda: analysis))
    assert comparison(preview)["is_equal"]
