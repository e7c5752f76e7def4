"""Where the last server listened is kept where nobody else can read it, or not at all."""

import os

import pytest

from kindsl.frontends.preview.access import Access
from kindsl.frontends.preview.session import last_session, remember


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    return tmp_path / "kindsl"


def test_a_session_is_found_again_by_its_name():
    assert last_session("arm") is None
    remember("arm", Access("secret", 7000))
    assert last_session("arm") == Access("secret", 7000)
    assert last_session("leg") is None


def test_only_the_owner_can_read_it(folder):
    remember("arm", Access("secret", 7000))
    assert folder.stat().st_mode & 0o777 == 0o700
    assert [file.stat().st_mode & 0o777 for file in folder.iterdir()] == [0o600]


def test_the_name_tells_nothing_of_the_file(folder):
    remember("/home/someone/secret.kindsl", Access("secret", 7000))
    assert "secret" not in next(folder.iterdir()).name


def test_a_folder_that_others_can_read_is_not_used(folder):
    folder.mkdir(mode=0o755)
    folder.chmod(0o755)
    remember("arm", Access("secret", 7000))
    assert list(folder.iterdir()) == []
    assert last_session("arm") is None


def test_a_link_is_not_followed(folder, tmp_path):
    (tmp_path / "elsewhere").mkdir(mode=0o700)
    folder.symlink_to(tmp_path / "elsewhere")
    remember("arm", Access("secret", 7000))
    assert list((tmp_path / "elsewhere").iterdir()) == []


@pytest.mark.parametrize("content", ["", "{", "[]", "3", '{"port": "x"}', '{"token": "a"}'])
def test_a_spoilt_file_is_no_session(folder, content):
    remember("arm", Access("secret", 7000))
    next(folder.iterdir()).write_text(content)
    assert last_session("arm") is None


def test_nothing_is_kept_where_nothing_can_be(monkeypatch):
    monkeypatch.setenv("XDG_RUNTIME_DIR", os.devnull)
    remember("arm", Access("secret", 7000))
    assert last_session("arm") is None
