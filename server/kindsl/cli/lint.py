"""`kdsl-lint` and `kindsl lint`: tells what is wrong with Kinematics-DSL documents."""

import sys
from typing import TYPE_CHECKING

from kindsl.cli.process import run_and_exit

if TYPE_CHECKING:
    import argparse
    from types import SimpleNamespace


def add_arguments(parser: "argparse.ArgumentParser") -> None:
    """Declare the options."""
    from kindsl.cli.options import add_lint_arguments

    add_lint_arguments(parser)


def run(args: "argparse.Namespace | SimpleNamespace") -> int:
    """Lint, report.

    Returns:
        0 without errors (and at most as many warnings as allowed), 1 with findings, 2 for wrong
        usage, a document that cannot be read, or a defect of ours.
    """
    from kindsl.cli.linter.command import run_lint

    return run_lint(args)


def main(arguments: list[str] | None = None) -> int:
    """Run as a command of its own; ends the process if the arguments are the process's."""
    if arguments is None:
        run_and_exit(lambda: main(sys.argv[1:]))
    from kindsl.cli.lint_defaults import only_paths

    options = only_paths(arguments)
    if options is not None:
        return run(options)
    import argparse

    from kindsl.cli.help_formatter import HelpFormatter

    parser = argparse.ArgumentParser(
        prog="kdsl-lint", description=_DESCRIPTION, formatter_class=HelpFormatter
    )
    add_arguments(parser)
    return run(parser.parse_args(arguments))


_DESCRIPTION = "Tells what is wrong with Kinematics-DSL documents."


if __name__ == "__main__":
    sys.exit(main())
