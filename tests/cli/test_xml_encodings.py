"""Robots in XML whose files are in another encoding than UTF-8, as they declare."""

import json
from pathlib import Path

import pytest
from tests.analysis.test_urdf_fixes import LEGS, spoilt
from tests.cli.conftest import Runner

import kindsl


def legs(encoding: str, text: str = LEGS) -> str:
    declared = f'<?xml version="1.0" encoding="{encoding}"?>\n'
    return declared + text.removeprefix('<?xml version="1.0"?>\n').replace(
        '<robot name="', '<!-- Schöße --> <robot name="Größe '
    )


@pytest.mark.parametrize("encoding", ["ISO-8859-1", "windows-1252", "UTF-16", "utf-8"])
def test_places_are_those_of_the_text_and_fixes_leave_the_encoding(
    encoding: str, kdsl_lint: Runner, kindsl: Runner, tmp_path: Path
) -> None:
    path, whole = tmp_path / "legs.urdf", legs(encoding)
    bad = legs(encoding, spoilt('value="1.152"', 'value="1152"'))
    path.write_bytes(bad.encode(encoding))
    (found,) = json.loads(kdsl_lint("--output-format", "json", str(path)).out)
    line = bad[: bad.index("1152")].count("\n")
    assert (found["code"], found["start"]["line"]) == ("KD314", line)
    assert kindsl("info", str(path)).out.startswith("Gr_e_")
    kdsl_lint("--fix", "--unsafe-fixes", str(path))
    assert path.read_bytes() == whole.encode(encoding)


def test_an_unknown_encoding_is_named_where_it_matters(kdsl_lint: Runner, tmp_path: Path) -> None:
    path = tmp_path / "legs.urdf"
    path.write_bytes(legs("KOI8-X").encode("latin-1"))
    told = kdsl_lint(str(path)).out
    assert (
        f"{path}:2:9: error[KD004] undecodable bytes 0xF6 0xDF, in UTF-8 and"
        in told.splitlines()[0]
    )
    assert "the declared encoding 'KOI8-X'" in told.splitlines()[0]


def test_a_declaration_that_the_bytes_deny_is_not_believed(tmp_path: Path) -> None:
    """Each byte of UTF-8 is a character of windows-1252, but for a few."""
    path = tmp_path / "legs.urdf"
    path.write_bytes(legs("windows-1252").replace("ö", "\u0141").encode())
    assert "\u0141" in kindsl.load(path).text


@pytest.mark.parametrize("mark", ["", "\ufeff"])
def test_what_is_utf_8_stays_so_whatever_it_declares(
    mark: str, kdsl_lint: Runner, tmp_path: Path
) -> None:
    path = tmp_path / "legs.urdf"
    declared = "UTF-16" if not mark else "ISO-8859-1"
    path.write_bytes((mark + legs(declared, spoilt('value="1.152"', 'value="1152"'))).encode())
    kdsl_lint("--fix", "--unsafe-fixes", str(path))
    assert path.read_bytes() == (mark + legs(declared)).encode()


def test_a_file_is_compared_by_the_numbers_in_it(kindsl: Runner, tmp_path: Path) -> None:
    old, new = tmp_path / "old.urdf", tmp_path / "new.urdf"
    old.write_text(legs("utf-8"), encoding="utf-8")
    new.write_bytes(legs("UTF-16", spoilt('value="1.152"', 'value="1.352"')).encode("UTF-16"))
    assert "(line " in kindsl("diff", str(old), str(new)).out
