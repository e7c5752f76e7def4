"""Files are written wholly or not at all, and keep what they had besides their content."""

import os
import stat
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kindsl.language.text.encodings import encoded
from kindsl.language.text.writing import write_file, write_files, write_folder

OLD, NEW = b"old " * 600, b"new " * 9000
is_superuser = hasattr(os, "geteuid") and os.geteuid() == 0
needs_posix = pytest.mark.skipif(os.name != "posix", reason="owners and links as POSIX has them")
needs_superuser = pytest.mark.skipif(not is_superuser, reason="mounts a file system, gives away")


@pytest.fixture
def tiny(tmp_path: Path) -> Iterator[Path]:
    """A file system with room for little more than the old content."""
    folder = tmp_path / "tiny"
    folder.mkdir()
    mount = ("mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", str(folder))
    if sys.platform != "linux" or subprocess.run(mount, capture_output=True).returncode:
        pytest.skip("no file system can be mounted here")
    yield folder
    subprocess.run(("umount", str(folder)), check=True)


def names(folder: Path) -> set[str]:
    return {entry.name for entry in folder.iterdir()}


@needs_posix
@pytest.mark.parametrize("mode", [0o600, 0o644, 0o664, 0o755])
def test_a_file_keeps_its_mode(tmp_path: Path, mode: int) -> None:
    file = tmp_path / "x"
    file.write_bytes(OLD)
    file.chmod(mode)
    write_file(str(file), NEW)
    assert file.read_bytes() == NEW
    assert stat.S_IMODE(file.stat().st_mode) == mode
    assert names(tmp_path) == {"x"}


@needs_posix
@pytest.mark.parametrize("mask", [0o022, 0o077, 0o002])
def test_a_new_file_has_the_mode_that_the_user_wants(tmp_path: Path, mask: int) -> None:
    former = os.umask(mask)
    try:
        write_file(str(tmp_path / "x"), NEW)
    finally:
        os.umask(former)
    assert stat.S_IMODE((tmp_path / "x").stat().st_mode) == 0o666 & ~mask


@needs_posix
def test_links_lead_to_what_is_new(tmp_path: Path) -> None:
    file = tmp_path / "x"
    file.write_bytes(OLD)
    (tmp_path / "hard").hardlink_to(file)
    (tmp_path / "soft").symlink_to("x")
    (tmp_path / "none").symlink_to("made")
    write_file(str(tmp_path / "soft"), NEW)
    write_file(str(tmp_path / "none"), NEW)
    assert (tmp_path / "soft").is_symlink() and (tmp_path / "none").is_symlink()
    assert (tmp_path / "hard").read_bytes() == NEW == (tmp_path / "made").read_bytes()
    assert file.stat().st_nlink == 2


@needs_superuser
def test_a_file_keeps_its_owner(tmp_path: Path) -> None:
    file = tmp_path / "x"
    file.write_bytes(OLD)
    os.chown(file, 1234, 2345)
    write_file(str(file), NEW)
    assert (file.stat().st_uid, file.stat().st_gid) == (1234, 2345)


@needs_posix
def test_an_owner_that_cannot_be_given_again_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(*_: object) -> None:
        raise PermissionError(1, "Operation not permitted")

    file = tmp_path / "x"
    file.write_bytes(NEW)
    number = file.stat().st_ino
    monkeypatch.setattr("kindsl.language.text.writing._make_alike", refused)
    write_file(str(file), OLD)
    assert (file.read_bytes(), file.stat().st_ino) == (OLD, number)
    assert names(tmp_path) == {"x"}


@pytest.mark.parametrize("is_linked", [False, True])
def test_a_full_disk_leaves_the_old_file(tiny: Path, is_linked: bool) -> None:
    file = tiny / "x"
    file.write_bytes(OLD)
    if is_linked:
        (tiny / "hard").hardlink_to(file)
    with pytest.raises(OSError, match="No space left") as told:
        write_file(str(file), NEW)
    assert told.value.filename == str(file)
    assert file.read_bytes() == OLD
    assert names(tiny) == {"x", "hard"} if is_linked else {"x"}


def test_a_full_disk_leaves_a_whole_folder(tiny: Path) -> None:
    for name in "ab":
        (tiny / name).write_bytes(OLD)
    contents = {str(tiny / "a"): b"new", str(tiny / "c"): b"new", str(tiny / "b"): NEW}
    with pytest.raises(OSError, match="No space left"):
        write_files(contents)
    assert {path.name: path.read_bytes() for path in tiny.iterdir()} == {"a": OLD, "b": OLD}
    with pytest.raises(OSError, match="No space left"):
        write_folder(str(tiny / "sub"), {"a": "new", "b": NEW.decode()})
    assert names(tiny) == {"a", "b"}


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="Linux has it")
def test_devices_are_written_to() -> None:
    with pytest.raises(OSError, match="No space left"):
        write_file("/dev/full", NEW)
    write_file("/dev/null", NEW)
    assert stat.S_ISCHR(Path("/dev/null").stat().st_mode)


@pytest.mark.skipif(not Path("/dev/stdout").exists(), reason="Unix has it")
def test_what_is_appended_to_is_not_replaced(tmp_path: Path) -> None:
    file = tmp_path / "x"
    file.write_bytes(OLD)
    code = "from kindsl.language.text.writing import write_file; write_file('/dev/stdout', b'new')"
    with file.open("ab") as stream:
        subprocess.run([sys.executable, "-c", code], stdout=stream, check=True)
    assert file.read_bytes() == OLD + b"new"


@pytest.mark.skipif(is_superuser, reason="the superuser may write everything")
def test_a_file_that_must_not_be_written_stays(tmp_path: Path) -> None:
    file = tmp_path / "x"
    file.write_bytes(OLD)
    file.chmod(0o444)
    with pytest.raises(PermissionError):
        write_file(str(file), NEW)
    assert file.read_bytes() == OLD


@given(st.binary())
def test_what_was_no_utf_8_is_written_as_it_was(content: bytes) -> None:
    assert encoded(content.decode("utf-8", "surrogateescape")) == content
