"""Which files of a folder are robots of the workspace."""

from pathlib import Path

from kindsl.config.robots import robots_below


def test_documents_are_found_at_any_depth(tmp_path: Path) -> None:
    assert found(tmp_path, "a.kindsl", "b/c/d.kindsl", "b/e.txt") == ["a.kindsl", "b/c/d.kindsl"]


def test_hidden_folders_are_passed_over(tmp_path: Path) -> None:
    assert found(tmp_path, ".venv/a.kindsl", "b.kindsl") == ["b.kindsl"]


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
