"""`kindsl`: one command, each subcommand imported only when it is asked for."""

import gc
import sys
from types import ModuleType

from kindsl import __version__
from kindsl.frontends.cli.commands import command_module, command_summaries, runs_long
from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.process import run_and_exit

USAGE_ERROR = 2
INTERRUPTED = 130
_DIGITS = tuple("0123456789.")


def main(arguments: list[str] | None = None) -> int:
    """Run the subcommand that the arguments name.

    Ends the process if the arguments are the process's, but for subcommands that run for long.
    """
    if arguments is None:
        arguments = sys.argv[1:]
        if not any(map(runs_long, arguments[:1])):
            run_and_exit(lambda: _dispatched(sys.argv[1:]))
    return _dispatched(arguments)


def overview() -> str:
    """Return the help of the command as a whole."""
    rows = "".join(f"  {name:17}{what}\n" for name, what in command_summaries().items())
    return (
        "usage: kindsl COMMAND ...\n\nTools for the Kinematics-DSL of RobCoGen.\n\n"
        f"commands:\n{rows}\noptions:\n  -h, --help       show this help\n"
        "  --version        print the version\n\nSee 'kindsl COMMAND --help' for its options.\n"
    )


def _dispatched(given: list[str]) -> int:
    command = given[0] if given else "--help"
    if command in ("-h", "--help", "help"):
        write(sys.stdout if given else sys.stderr, overview())
        return 0 if given else USAGE_ERROR
    if command in ("-V", "--version"):
        write(sys.stdout, f"kindsl {__version__}\n")
        return 0
    module = command_module(command)
    if module is None:
        write(sys.stderr, f"kindsl: error: {_unknown(command)}\n")
        return USAGE_ERROR
    return _run(command, module, given[1:])


def with_joined_negatives(arguments: list[str]) -> list[str]:
    """Return arguments with `--q -1,2` as `--q=-1,2`, which argparse would take for an option."""
    joined: list[str] = []
    for number, argument in enumerate(arguments):
        if argument == "--":
            return [*joined, *arguments[number:]]
        is_number = argument[:1] == "-" and argument[1:2] in _DIGITS
        if is_number and joined and joined[-1].startswith("--") and "=" not in joined[-1]:
            joined[-1] = f"{joined[-1]}={argument}"
        else:
            joined.append(argument)
    return joined


def _run(command: str, module: ModuleType, arguments: list[str]) -> int:
    import argparse

    from kindsl.frontends.cli.process import help_formatter

    if command != "lint":
        gc.enable()
    parser = argparse.ArgumentParser(
        prog=f"kindsl {command}", description=module.__doc__, formatter_class=help_formatter
    )
    module.add_arguments(parser)
    try:
        # Options may stand between paths; behind `--` there are none.
        parse = parser.parse_args if "--" in arguments else parser.parse_intermixed_args
        return int(module.run(parse(with_joined_negatives(arguments))))
    except KeyboardInterrupt:
        return INTERRUPTED
    except Exception as error:
        from kindsl.frontends.cli.documents.document_reading import report_error

        return report_error(error)


def _unknown(command: str) -> str:
    from kindsl.language.text.nearest import hint, nearest_word

    if command.startswith("-"):
        return f"unknown option '{command}'; see 'kindsl --help'"
    near = hint(nearest_word(command, command_summaries()), after=",")
    return f"unknown command '{command}'" + (near or "; see 'kindsl --help'")


if __name__ == "__main__":
    sys.exit(main())
