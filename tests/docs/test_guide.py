"""The guide shows what the commands really print."""

import shutil
from pathlib import Path

import pytest
from tests.docs.console import commands_of, matches, rewritten, run_page
from tests.docs.guide import GUIDE, PAGES, copy_examples

needs_shell = pytest.mark.skipif(shutil.which("sh") is None, reason="there is no shell 'sh'")

PAGE = """\
Text.

```console
$ echo one; echo two
one
...
$ false
$ echo $?
1
```

```sh
$ never run
```
"""


@needs_shell
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_commands_print_what_the_page_shows(page: Path, tmp_path: Path) -> None:
    copy_examples(tmp_path)
    for command, printed in run_page(page.read_text(encoding="utf-8"), tmp_path):
        shown, real = "\n".join(command.expected), "\n".join(printed)
        assert matches(command.expected, printed), f"$ {command.text}\n{real}\n-- shown:\n{shown}"


def test_every_document_of_the_guide_is_used_in_it() -> None:
    text = "".join(page.read_text(encoding="utf-8") for page in PAGES)
    unused = [file.name for file in GUIDE.glob("*.kindsl") if file.name not in text]
    assert unused == []


@needs_shell
def test_commands_of_a_page_run_in_order(tmp_path: Path) -> None:
    printed = [lines for _, lines in run_page(PAGE, tmp_path)]
    assert printed == [("one", "two"), (), ("1",)]


def test_only_console_blocks_are_run() -> None:
    assert [command.text for command in commands_of(PAGE)] == [
        "echo one; echo two", "false", "echo $?",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("expected", "printed", "is_match"),
    [
        ((), (), True),
        (("a",), ("a",), True),
        (("a",), ("b",), False),
        (("a",), ("a", "b"), False),
        (("a", "..."), ("a",), True),
        (("...", "c"), ("a", "b", "c"), True),
        (("a.c",), ("abc",), False),
    ],
)
def test_what_matches(expected: tuple[str, ...], printed: tuple[str, ...], is_match: bool) -> None:
    assert matches(expected, printed) is is_match


@needs_shell
def test_a_stale_page_is_rewritten(tmp_path: Path) -> None:
    stale = PAGE.replace("one\n...", "three")
    assert rewritten(stale, run_page(stale, tmp_path)) == PAGE.replace("...", "two")
    assert rewritten(PAGE, run_page(PAGE, tmp_path)) == PAGE
