"""Links in configuration files to the documents that tables are for."""

from pathlib import Path

from lsprotocol import types
from tests.cli.samples import GOOD

from kindsl.frontends.lsp.session.configuration_files import configuration_links
from kindsl.frontends.lsp.text.document import document

TEXT = """[[document]]
path = "arm.kindsl"
[[document]]
path = "*.kindsl"
[[document]]
path = "absent.kindsl"
"""


def links(
    folder: Path, text: str, name: str = "kindsl.toml"
) -> list[tuple[str | None, int, int, int]]:
    shown = document((folder / name).as_uri(), 1, text, "utf-16")
    found: list[types.DocumentLink] = list(configuration_links(shown))
    return [
        (k.target, k.range.start.line, k.range.start.character, k.range.end.character)
        for k in found
    ]


def test_documents_that_are_there_are_links(tmp_path: Path) -> None:
    (tmp_path / "arm.kindsl").write_text(GOOD)
    assert links(tmp_path, TEXT) == [((tmp_path / "arm.kindsl").as_uri(), 1, 8, 18)]
    assert links(tmp_path, f"{TEXT}x = [") == []
    assert links(tmp_path, TEXT, "other.toml") == []
    unnamed = document("untitled:kindsl.toml", 1, TEXT, "utf-16")
    assert list(configuration_links(unnamed)) == []
