"""The picture of a card in Markdown: in a file of its own where the page is in one."""

import re
from pathlib import Path
from urllib.parse import unquote

from tests.cli.samples import GOOD

from kindsl.frontends.cli.main import main


def test_a_page_in_a_file_has_its_picture_beside_it(tmp_path: Path) -> None:
    source, page = tmp_path / "arm.kindsl", tmp_path / "my arm.md"
    source.write_text(GOOD)
    assert main(["card", str(source), "-o", str(page)]) == 0
    text = page.read_text()
    (address,) = re.findall(r"!\[.*\]\((.*)\)", text)
    assert "data:" not in text
    assert (tmp_path / unquote(address)).read_text().startswith("<svg")


def test_a_page_on_stdout_has_its_picture_in_it(tmp_path: Path, capsys) -> None:
    source = tmp_path / "arm.kindsl"
    source.write_text(GOOD)
    assert main(["card", str(source)]) == 0
    assert "](data:image/svg+xml;base64," in capsys.readouterr().out
    assert not list(tmp_path.glob("*.svg"))
