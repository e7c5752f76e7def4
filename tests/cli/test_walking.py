"""Which documents a command line means."""

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.frontends.cli.documents.sources import read_source
from kindsl.frontends.cli.documents.walking import documents


def found(*paths: str) -> list[str]:
    return [str(document) for document in documents(list(paths))]


def put(folder: Path, *names: str) -> None:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()


def test_folder_brings_all_documents_below_in_order(folder: Path) -> None:
    put(folder, "b.kindsl", "a.kindsl", "sub/deep/c.kindsl", "sub/readme.txt", ".hidden/d.kindsl")
    assert found(".") == [".hidden/d.kindsl", "a.kindsl", "b.kindsl", "sub/deep/c.kindsl"]


def test_named_twice_is_linted_once(folder: Path) -> None:
    put(folder, "sub/a.kindsl")
    assert found("sub/a.kindsl", "sub", "./sub/../sub/a.kindsl") == ["sub/a.kindsl"]


def test_gitignore_holds_with_its_exceptions(folder: Path) -> None:
    put(folder, "a.kindsl", "old.kindsl", "out/b.kindsl", "sub/old.kindsl", "sub/keep/x.kindsl")
    (folder / ".gitignore").write_text("out/\nold.kindsl\n")
    (folder / "sub" / ".gitignore").write_text("!old.kindsl\n/keep\n")
    assert found(".") == ["a.kindsl", "sub/old.kindsl"]


def test_gitignore_of_folders_above_holds_within_the_repository(folder: Path) -> None:
    put(folder, "sub/a.kindsl", "sub/gen.kindsl")
    (folder / ".gitignore").write_text("gen.kindsl\n")
    assert found("sub") == ["sub/a.kindsl"]


def test_what_is_named_is_linted_though_git_ignores_it(folder: Path) -> None:
    put(folder, "out/b.kindsl")
    (folder / ".gitignore").write_text("out/\n")
    assert found("out/b.kindsl") == ["out/b.kindsl"]
    assert found("out") == ["out/b.kindsl"]
    assert found(".") == []


def test_excludes_of_the_repository_itself_hold(folder: Path) -> None:
    put(folder, "a.kindsl", "mine.kindsl")
    (folder / ".git" / "info").mkdir()
    (folder / ".git" / "info" / "exclude").write_text("mine.kindsl\n")
    assert found(".") == ["a.kindsl"]


def test_the_repository_itself_is_not_walked(folder: Path) -> None:
    put(folder, ".git/x.kindsl", "a.kindsl")
    assert found(".") == ["a.kindsl"]


def test_folders_of_tools_are_left_out_unless_named(folder: Path) -> None:
    put(folder, ".venv/a.kindsl", "build/b.kindsl", "c.kindsl", "sub/node_modules/d.kindsl")
    assert found(".") == ["c.kindsl"]
    assert found("build", "sub/node_modules/d.kindsl") == [
        "build/b.kindsl",
        "sub/node_modules/d.kindsl",
    ]
    assert [str(path) for path in documents(["."], excluded=())] == [
        ".venv/a.kindsl", "build/b.kindsl", "c.kindsl", "sub/node_modules/d.kindsl",
    ]  # fmt: skip


def test_loop_of_links_ends(folder: Path) -> None:
    put(folder, "sub/a.kindsl")
    (folder / "sub" / "again").symlink_to("..")
    assert found(".") == ["sub/a.kindsl"]


def test_a_file_called_minus_is_no_stdin(folder: Path) -> None:
    put(folder, "-")
    assert found("./-") == ["./-"]
    assert found("-") == ["-"]


@settings(max_examples=200, deadline=None)
@given(st.binary(max_size=300))
def test_reading_any_bytes_gives_a_text_or_a_failure(content: bytes) -> None:
    from tempfile import NamedTemporaryFile

    with NamedTemporaryFile() as file:
        file.write(content)
        file.flush()
        text = read_source(file.name, "x.kindsl")
    if isinstance(text, str):
        assert text.encode("utf-8", "surrogateescape") == content
    else:
        assert str(text).startswith("x.kindsl:")


def test_links_are_not_resolved_away(folder: Path) -> None:
    put(folder, "elsewhere/deep/x.txt", "elsewhere/a.kindsl", "a.kindsl")
    (folder / "link").symlink_to("elsewhere/deep")
    assert found("link/../a.kindsl") == ["link/../a.kindsl"]
    assert found("elsewhere/a.kindsl", "link/../a.kindsl", "a.kindsl") == [
        "elsewhere/a.kindsl", "a.kindsl",
    ]  # fmt: skip
