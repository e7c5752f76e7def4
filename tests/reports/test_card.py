"""`kindsl card`: all that is in a document, in each format, broken ones as far as it goes."""

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from tests.support.published import published_models

import kindsl
from kindsl.frontends.cli.main import main
from kindsl.judgement.analysis.settings import Settings
from kindsl.products.reports.card import card_page
from kindsl.products.reports.drawing.shapes import Disc, Label, Line
from kindsl.products.reports.page.blocks import Figure, Heading, Matrix, Table
from kindsl.products.reports.page.html import html_text
from kindsl.products.reports.page.markdown import markdown_text

RENDERERS = {"markdown": markdown_text, "html": html_text}
EXAMPLES = Path(__file__).parents[2] / "examples"
QUADRUPED = EXAMPLES / "quadruped.kindsl"
SECTIONS = ["Tree", "Joints", "Masses", "Frames", "Parameters", "Transforms", "Health"]


def page(path: Path):
    return card_page(kindsl.load(path, Settings()))


def table(blocks, title: str) -> Table:
    start = next(i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.text == title)
    return next(b for b in blocks[start:] if isinstance(b, Table))


def test_it_holds_everything() -> None:
    document = kindsl.load(EXAMPLES / "industrial_arm.kindsl")
    blocks = card_page(document)
    assert [b.text for b in blocks if isinstance(b, Heading)][1:] == SECTIONS
    links = [row[0].strip() for row in table(blocks, "Tree").rows]
    assert links == [str(body.name) for body in document.model.bodies]
    joints = [row[0] for row in table(blocks, "Joints").rows]
    assert joints == [str(joint.name) for joint in document.model.joints]
    assert sum(isinstance(b, Matrix) for b in blocks) == len(joints)


def test_what_is_not_known_of_a_body_is_no_number(tmp_path: Path) -> None:
    path = tmp_path / "a.kindsl"
    path.write_text(QUADRUPED.read_text().replace("CoM = (0.0, 0.036, 0.0)", "CoM = (0.0, y, 0.0)"))
    row = next(row for row in table(page(path), "Masses").rows if row[0] == "LF_hip")
    assert row == ("LF_hip", "0.54", "-", "-", "-")


def test_a_suppressed_doubt_about_a_shape_is_not_told(tmp_path: Path) -> None:
    path = tmp_path / "a.kindsl"
    light = QUADRUPED.read_text().replace("mass = 0.54", "mass = 0.000054", 1)
    shapes = []
    for comment in ("", "// kindsl: ignore-file[KD311]\n"):
        path.write_text(comment + light)
        shapes += [row[4] for row in table(page(path), "Masses").rows if row[0] == "LF_hip"]
    assert shapes == ["too light", "-"]


def test_every_link_and_frame_is_drawn_within_the_sheet() -> None:
    (picture,) = (b for b in page(QUADRUPED) if isinstance(b, Figure))
    shapes = picture.drawing.shapes
    spots = [s for x in shapes if isinstance(x, Line) for s in (x.start, x.end)]
    spots += [x.center for x in shapes if isinstance(x, Disc)]
    assert len(spots) > 40
    width, height = picture.drawing.width, picture.drawing.height
    assert all(0 < x < width and 0 < y < height for x, y in spots)
    assert {"trunk"} <= {x.text for x in shapes if isinstance(x, Label)}


@pytest.mark.parametrize("output_format", RENDERERS)
def test_each_format_is_well_formed(output_format: str) -> None:
    text = RENDERERS[output_format](page(QUADRUPED))
    assert "http" not in re.sub('xmlns="[^"]*"|http-equiv', "", text)
    if output_format == "html":
        body = text[text.index("<body>") : text.index("</html>")]
        assert len(ElementTree.fromstring(body).findall("table")) > 10
    else:
        rows = [line for line in text.splitlines() if line.startswith("| ")]
        assert len(rows) > 50 and "```math" in text


@pytest.mark.parametrize("cut", [0, 40, 600, 2000])
def test_broken_documents_are_shown_as_far_as_they_go(cut: int) -> None:
    blocks = card_page(kindsl.parse(QUADRUPED.read_text()[:cut], Settings()))
    assert any(isinstance(b, Heading) and b.text == "Health" for b in blocks)
    for output_format in RENDERERS:
        assert RENDERERS[output_format](blocks)


@pytest.mark.parametrize("path", published_models())
def test_published_documents_have_a_card(path: Path) -> None:
    blocks = page(path)
    assert any(isinstance(b, Figure) for b in blocks)
    assert all(RENDERERS[output_format](blocks) for output_format in RENDERERS)


def test_command_writes_a_file_or_stdout(tmp_path: Path, capsys) -> None:
    out = tmp_path / "card.html"
    assert main(["card", str(QUADRUPED), "--output-format", "html", "-o", str(out)]) == 0
    assert out.read_text().startswith("<!DOCTYPE html>")
    assert main(["card", "--isolated", str(QUADRUPED)]) == 0
    assert capsys.readouterr().out.startswith("# ")
    assert main(["card", str(tmp_path / "absent.kindsl")]) == 2
    assert main(["card", str(QUADRUPED), "-o", str(tmp_path / "no" / "card.md")]) == 2
    assert "cannot be written: there is no folder" in capsys.readouterr().err


def test_latex_is_answered_with_the_command_that_writes_it(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["card", str(QUADRUPED), "--output-format", "latex"])
    assert stopped.value.code == 2
    printed = capsys.readouterr()
    assert printed.out == "" and "pandoc card.md --from gfm --standalone" in printed.err


def test_the_picture_is_in_a_pose_of_the_configuration(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "a.kindsl"
    path.write_text(QUADRUPED.read_text())
    (tmp_path / "kindsl.toml").write_text("[poses.stand]\nLF_HFE = 0.7\n")
    out = tmp_path / "card.html"
    pictures = []
    for options in ([], ["--pose", "stand"]):
        assert main(["card", str(path), "--output-format", "html", "-o", str(out), *options]) == 0
        pictures.append(out.read_text())
    assert "At zero: bodies" in pictures[0]
    assert "In pose &#x27;stand&#x27;: bodies" in pictures[1]
    drawn, moved = (re.search(r"<svg.*?</svg>", text, re.S)[0] for text in pictures)
    assert drawn != moved
    assert pictures[0].count("<table") == pictures[1].count("<table")
    assert main(["card", str(path), "--pose", "sit"]) == 2
    assert "kindsl.toml names no pose 'sit'" in capsys.readouterr().err
