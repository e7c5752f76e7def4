"""`kindsl preview --edit`: what is dragged is written into the file, or said why not."""

import argparse

from tests.preview.robots import ARM
from tests.preview.test_command import line_of, running
from tests.preview.websocket import connected, first_part, whole_state

from kindsl.frontends.cli import preview
from kindsl.frontends.preview.steps import Writing
from kindsl.language.text.edits import TextEdit

AT = ARM.index("(0.4, 0.0") + 1
WRITING = Writing("Set x of joint 'lift'", ARM, (TextEdit(AT, AT + 3, "0.55"),))
EDITED = ARM.replace("(0.4, 0.0", "(0.55, 0.0")
DRAG = (
    '{"type":"drag","kind":"joint","name":"lift","component":"x","value":0.553,'
    '"step":0.01,"phase":"drop","revision":1}'
)


def written(file, writing) -> str:
    """Write as the command does; return why not."""
    parser = argparse.ArgumentParser()
    preview.add_arguments(parser)
    return preview._write_dragged(parser.parse_args([str(file)]), writing)


def test_bytes_mode_and_line_ends_stay(tmp_path):
    file = tmp_path / "arm.kindsl"
    text = ARM.replace("\n", "\r\n")
    file.write_bytes(text.encode())
    file.chmod(0o640)
    at = text.index("(0.4, 0.0") + 1
    assert written(file, Writing("", text, (TextEdit(at, at + 3, "0.55"),))) == ""
    assert file.read_bytes() == EDITED.replace("\n", "\r\n").encode()
    assert file.stat().st_mode & 0o777 == 0o640
    assert [path.name for path in tmp_path.iterdir()] == ["arm.kindsl"]


def test_what_somebody_wrote_meanwhile_stays(tmp_path):
    file = tmp_path / "arm.kindsl"
    file.write_text(ARM + "\n")
    assert "has changed" in written(file, WRITING)
    assert file.read_text() == ARM + "\n"


def test_a_file_that_may_only_be_read_stays(tmp_path, monkeypatch):
    file = tmp_path / "arm.kindsl"
    file.write_text(ARM)
    monkeypatch.setattr("os.access", lambda *_: False)
    assert written(file, WRITING) == "cannot be written: permission denied"
    assert file.read_text() == ARM


def test_no_link_is_followed(tmp_path):
    (tmp_path / "real.kindsl").write_text(ARM)
    (tmp_path / "arm.kindsl").symlink_to(tmp_path / "real.kindsl")
    assert "is a link" in written(tmp_path / "arm.kindsl", WRITING)
    assert (tmp_path / "real.kindsl").read_text() == ARM


def test_a_bound_parameter_is_written_where_it_is_bound(tmp_path):
    file, configuration = tmp_path / "arm.kindsl", tmp_path / "kindsl.toml"
    file.write_text(ARM)
    configuration.write_text("# lengths\n[parameters]\nreach = 0.40 # m\n")
    assert written(file, Writing("", ARM, (), (("reach", 0.55),))) == ""
    assert configuration.read_text() == "# lengths\n[parameters]\nreach = 0.55 # m\n"
    assert file.read_text() == ARM


def test_a_parameter_bound_elsewhere_stays(tmp_path):
    file = tmp_path / "arm.kindsl"
    file.write_text(ARM)
    refused = written(file, Writing("", ARM, (), (("reach", 0.55),)))
    assert refused == "'reach' is not bound in a configuration file"


def test_a_configuration_file_that_cannot_be_read_is_told(tmp_path):
    file, configuration = tmp_path / "arm.kindsl", tmp_path / "kindsl.toml"
    file.write_text(ARM)
    configuration.write_text("[parameters\n")
    told = written(file, Writing("", ARM, (), (("reach", 0.55),)))
    assert told.startswith(f"{configuration}:1:")


async def test_a_page_drags_and_the_file_follows(tmp_path):
    file = tmp_path / "arm.kindsl"
    file.write_text(ARM)
    async with running(tmp_path, file, "--edit") as (process, address), connected(address) as page:
        await first_part(page, lambda m: m["type"] == "editing")
        await page.write_message(DRAG)
        assert await line_of(process.stdout) == f"{file}: Set x of joint 'lift'"
        assert file.read_text() == EDITED


async def test_without_the_option_nothing_is_written(tmp_path):
    file = tmp_path / "arm.kindsl"
    file.write_text(ARM)
    async with running(tmp_path, file) as (_, address), connected(address) as page:
        await page.write_message(DRAG)
        await whole_state(page)
        assert file.read_text() == ARM
