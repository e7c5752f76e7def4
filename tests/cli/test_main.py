"""`kindsl`: which subcommand runs, and the help."""

import argparse
import re
import shlex
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.cli.samples import UNBOUND

from kindsl.frontends.cli.commands import command_module, command_summaries
from kindsl.frontends.cli.main import with_joined_negatives


def test_help_lists_what_is_there(kindsl: Runner) -> None:
    told = kindsl("--help")
    assert told.status == 0
    listed = re.findall(
        r"^  ([a-z-]+)  +(?=[a-z])", told.out.partition("options:")[0], re.MULTILINE
    )
    assert listed == list(command_summaries())
    assert {"lint", "format", "preview", "language-server"} < set(listed)


def test_without_command_shows_help_as_an_error(kindsl: Runner) -> None:
    told = kindsl()
    assert (told.status, told.out) == (2, "")
    assert told.err.startswith("usage: kindsl COMMAND")


@pytest.mark.parametrize(
    ("command", "told"),
    [
        ("lnit", "unknown command 'lnit', did you mean 'lint'?"),
        ("xyz", "unknown command 'xyz'; see 'kindsl --help'"),
        ("--lint", "unknown option '--lint'; see 'kindsl --help'"),
    ],
)
def test_unknown_command(kindsl: Runner, command: str, told: str) -> None:
    result = kindsl(command)
    assert result.status == 2
    assert result.err == f"kindsl: error: {told}\n"


def test_version(kindsl: Runner, kdsl_lint: Runner) -> None:
    assert re.fullmatch(r"kindsl \d+\.\d+\.\d+\S*\n", kindsl("--version").out)
    assert re.fullmatch(r"kdsl-lint \d+\.\d+\.\d+\S*\n", kdsl_lint("--version").out)


@pytest.mark.parametrize("command", command_summaries())
def test_every_command_has_help(kindsl: Runner, command: str) -> None:
    told = kindsl(command, "--help")
    assert told.status == 0
    assert told.out.startswith(f"usage: kindsl {command} ")
    assert max(map(len, told.out.splitlines())) <= 100


@pytest.mark.parametrize("command", command_summaries())
def test_examples_of_help_are_understood(command: str) -> None:
    module = command_module(command)
    assert module is not None
    parser = argparse.ArgumentParser(exit_on_error=False)
    module.add_arguments(parser)
    examples = re.findall(rf"^  kindsl {command}(.*)$", module.__doc__ or "", re.MULTILINE)
    assert examples or command == "mcp"
    for example in examples:
        parser.parse_intermixed_args(with_joined_negatives(shlex.split(example)))


def test_negative_numbers_are_values() -> None:
    given = ["f", "--q", "-1,2", "--gravity", "-.5,0,0", "-q", "-3", "--qd=1", "-2", "--forward"]
    joined = ["f", "--q=-1,2", "--gravity=-.5,0,0", "-q", "-3", "--qd=1", "-2", "--forward"]
    assert with_joined_negatives(given) == joined


@pytest.mark.parametrize("command", ["info", "card", "compute", "convert"])
def test_a_value_for_what_is_no_parameter_is_refused(
    kindsl: Runner, folder: Path, command: str
) -> None:
    (folder / "a.kindsl").write_text(UNBOUND)
    outputs = ["a.urdf"] if command == "convert" else []
    told = kindsl(command, "a.kindsl", *outputs, "--param", "lenght=1.0")
    assert (told.status, told.out) == (2, "")
    assert told.err == "a.kindsl: error: there is no parameter 'lenght', did you mean 'length'?\n"
    assert not (folder / "a.urdf").exists()


@pytest.mark.parametrize("command", [("diff",), ("review", "-o", "out")])
def test_a_value_for_a_parameter_of_neither_document_is_refused(
    kindsl: Runner, folder: Path, command: tuple[str, ...]
) -> None:
    (folder / "old.kindsl").write_text(UNBOUND)
    (folder / "new.kindsl").write_text(UNBOUND.replace("length", "reach"))
    documents = (*command, "old.kindsl", "new.kindsl")
    told = kindsl(*documents, "--param", "lenght=1.0")
    assert (told.status, told.out) == (2, "")
    message = "there is no parameter 'lenght' in either document, did you mean 'length'?"
    assert told.err == f"new.kindsl: error: {message}\n"
    assert not (folder / "out").exists()
    (folder / "old.kindsl").write_text(UNBOUND.replace("mass =", "mass"))
    assert kindsl(*documents, "--param", "lenght=1.0").status != 2


def test_a_value_for_a_parameter_of_one_of_two_documents_is_taken(
    kindsl: Runner, folder: Path
) -> None:
    (folder / "old.kindsl").write_text(UNBOUND)
    (folder / "new.kindsl").write_text(UNBOUND.replace("length", "0.5"))
    told = kindsl("diff", "old.kindsl", "new.kindsl", "--param", "length=0.5")
    assert (told.status, told.out) == (0, "nothing changed mechanically\n")
    told = kindsl("diff", "/dev/null", "old.kindsl", "--param", "lenght=0.5")
    message = "there is no parameter 'lenght', did you mean 'length'?"
    assert (told.status, told.err) == (2, f"old.kindsl: error: {message}\n")


def test_what_follows_two_hyphens_stays_apart() -> None:
    assert with_joined_negatives(["--", "-1.kindsl"]) == ["--", "-1.kindsl"]
    assert with_joined_negatives(["--q", "-1", "--", "-1"]) == ["--q=-1", "--", "-1"]
