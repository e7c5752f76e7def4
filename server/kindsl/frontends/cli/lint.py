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
DEFAULTS: dict[str, Any] = {
    "stdin_filename": None,
    "no_default_exclude": False,
    "select": None,
    "ignore": None,
    "target": None,
    "editor_settings": None,
    "param": (),
    "params": None,
    "config": None,
    "isolated": False,
    "fix": False,
    "unsafe_fixes": False,
    "diff": False,
    "write_baseline": None,
    "output_format": "text",
    "max_warnings": None,
    "exit_zero": False,
    "statistics": False,
    "verbose": False,
    "quiet": False,
    "watch": False,
    "jobs": 0,
    "explain": None,
    "list_rules": False,
}


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
    return SimpleNamespace(paths=arguments, **DEFAULTS)


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
