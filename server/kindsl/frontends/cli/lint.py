"""Reports problems in Kinematics-DSL documents.

examples:
  kindsl lint
  kindsl lint --target robcogen --fix arm.kindsl
  kindsl lint --select KD3 --output-format json models
  kindsl lint --explain KD301
"""

import sys
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from kindsl.frontends.cli.process import run_and_exit

if TYPE_CHECKING:
    import argparse

SUMMARY = "report problems in documents"
DEFAULTS: dict[str, Any] = {"param": (), "output_format": "text", "jobs": 0}


class OnlyPaths(SimpleNamespace):
    """The options where none is given: off, and without a value, but for a few."""

    def __getattr__(self, name: str) -> None:
        return None


def add_arguments(parser: "argparse.ArgumentParser") -> None:
    """Declare the options."""
    from kindsl.frontends.cli.options import add_lint_arguments

    add_lint_arguments(parser)


def run(args: "argparse.Namespace | SimpleNamespace") -> int:
    """Lint, report.

    Returns:
        0 without errors (and at most as many warnings as allowed), 1 with findings, 2 for wrong
        usage, a document that cannot be read, or a defect of ours.
    """
    from kindsl.frontends.cli.linter.command import run_lint

    return run_lint(args)


def main(arguments: list[str] | None = None) -> int:
    """Run as a command of its own; ends the process if the arguments are the process's."""
    if arguments is None:
        run_and_exit(lambda: main(sys.argv[1:]))
    options = only_paths(arguments) or _parsed(arguments)
    return run(options)


def only_paths(arguments: list[str]) -> SimpleNamespace | None:
    """Return the options if all arguments are paths, else None.

    So the usual call needs no parser of arguments, which takes longer than reading a document.
    """
    if any(argument.startswith("-") and argument != "-" for argument in arguments):
        return None
    return OnlyPaths(paths=arguments, **DEFAULTS)


def _parsed(arguments: list[str]) -> "argparse.Namespace":
    import argparse

    from kindsl.frontends.cli.process import help_formatter

    parser = argparse.ArgumentParser(
        prog="kdsl-lint", description=__doc__, formatter_class=help_formatter
    )
    add_arguments(parser)
    return parser.parse_args(arguments)


if __name__ == "__main__":
    sys.exit(main())
