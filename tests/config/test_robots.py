"""Which files of a folder are robots of the workspace."""

import os
from pathlib import Path
from tempfile import TemporaryDirectory

from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.frontends.cli.documents.walking import documents
from kindsl.judgement.config.robots import TOOLS_FOLDERS, Obstacle, is_robot, robots_below, walked


def test_documents_are_found_at_any_depth(tmp_path: Path) -> None:
    assert found(tmp_path, "a.kindsl", "b/c/d.kindsl", "b/e.txt") == ["a.kindsl", "b/c/d.kindsl"]


def test_folders_of_tools_are_left_out_hidden_ones_are_not(tmp_path: Path) -> None:
    names = ".hidden/a.kindsl", "x/.venv/b.kindsl", "build/c.kindsl", "x/node_modules/y/d.kindsl"
    assert found(tmp_path, *names) == [".hidden/a.kindsl"]


def test_a_folder_that_is_asked_for_may_be_called_as_it_likes(tmp_path: Path) -> None:
    folder = tmp_path / "build"
    assert found(folder, "a.kindsl", "dist/b.kindsl") == ["a.kindsl"]


def test_folders_of_tools_may_be_asked_for_those_of_version_control_not(tmp_path: Path) -> None:
    names = "build/a.kindsl", ".venv/b.kindsl", ".git/c.kindsl", ".hg/d.kindsl"
    found(tmp_path, *names)
    walk = [Path(str(path)).relative_to(tmp_path) for path in walked(str(tmp_path), ())]
    assert walk == [Path(".venv/b.kindsl"), Path("build/a.kindsl")]


def test_a_file_may_be_called_like_a_folder_of_tools(tmp_path: Path) -> None:
    (tmp_path / "build").write_text("")
    assert found(tmp_path, "dist.kindsl") == ["dist.kindsl"]


def test_the_suffix_may_be_in_capitals(tmp_path: Path) -> None:
    assert found(tmp_path, "A.KINDSL", "b.Kindsl", "c.kindsl.bak") == ["A.KINDSL", "b.Kindsl"]


def test_what_is_no_file_is_passed_over_and_a_broken_link_told(tmp_path: Path) -> None:
    (tmp_path / "empty.kindsl").mkdir()
    (tmp_path / "gone.kindsl").symlink_to("nowhere")
    (tmp_path / "link.kindsl").symlink_to(tmp_path, target_is_directory=True)
    os.mkfifo(tmp_path / "pipe.kindsl")
    assert found(tmp_path, "a.kindsl") == ["a.kindsl"]
    obstacles = [one for one in walked(str(tmp_path)) if isinstance(one, Obstacle)]
    assert [(Path(one.path).name, type(one.reason)) for one in obstacles] == [
        ("gone.kindsl", FileNotFoundError)
    ]


def test_an_ignore_file_that_is_a_pipe_keeps_nobody_waiting(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / ".gitignore")
    assert found(tmp_path, "a.kindsl") == ["a.kindsl"]


folder_names = st.sampled_from(["sub", ".hidden", ".venv", "node_modules", "build", "x.kindsl"])
file_names = st.sampled_from(["a.kindsl", "B.KINDSL", "readme.md", ".c.kindsl", "old.kindsl"])
places = st.tuples(st.lists(folder_names, max_size=3), file_names).map(
    lambda p: "/".join((*p[0], p[1]))
)
rules = st.sampled_from(["old.kindsl", "/sub/", "!old.kindsl", "*.KINDSL", "sub/*", "#", "[", ""])


@settings(max_examples=60, deadline=None)
@given(st.lists(places, max_size=8), st.dictionaries(folder_names | st.just("."), st.lists(rules)))
def test_an_editor_and_the_linter_find_the_same(
    names: list[str], ignored: dict[str, list[str]]
) -> None:
    with TemporaryDirectory() as name:
        folder = Path(name)
        found(folder, ".git/HEAD", *names)
        for place, lines in ignored.items():
            (folder / place).mkdir(exist_ok=True)
            (folder / place / ".gitignore").write_text("\n".join(lines))
        robots = [str(path) for path in robots_below(folder)]
        linted = [path for path in documents([name]) if isinstance(path, str)]
        assert robots == linted
        assert all(Path(path).is_file() and is_robot(path) for path in robots)
        assert TOOLS_FOLDERS.isdisjoint(
            part for path in robots for part in Path(path).relative_to(folder).parts
        )


def test_what_git_ignores_is_left_out(tmp_path: Path) -> None:
    (tmp_path / "kept").mkdir()
    (tmp_path / ".gitignore").write_text("build/\n*_old.kindsl\n")
    (tmp_path / "kept" / ".gitignore").write_text("!x_old.kindsl\n")
    names = "build/a.kindsl", "b_old.kindsl", "kept/x_old.kindsl", "kept/y_old.kindsl", "z.kindsl"
    assert found(tmp_path, *names) == ["kept/x_old.kindsl", "z.kindsl"]


def test_a_folder_that_looks_like_a_document_is_only_a_folder(tmp_path: Path) -> None:
    assert found(tmp_path, "a.kindsl/b.kindsl") == ["a.kindsl/b.kindsl"]


def test_a_folder_that_is_not_there_has_none(tmp_path: Path) -> None:
    assert list(robots_below(tmp_path / "nowhere")) == []


def found(folder: Path, *names: str) -> list[str]:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("")
    return [path.relative_to(folder).as_posix() for path in robots_below(folder)]
