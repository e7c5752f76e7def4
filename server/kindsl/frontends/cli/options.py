"""The options of `kindsl lint`."""

import argparse
import math
from typing import Any

from kindsl import __version__
from kindsl.frontends.cli.output import FORMATS
from kindsl.judgement.rules.context import TARGETS


def add_lint_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument(
        "paths",
        nargs="*",
        metavar="PATH",
        help="documents, folders, or '-' for stdin (default: the current folder)",
    )
    parser.add_argument("--stdin-filename", metavar="NAME", help="file name to report for stdin")
    add_exclusion_argument(parser)
    version = f"{parser.prog.partition(' ')[0]} {__version__}"
    parser.add_argument("--version", action="version", version=version, help="print the version")
    _add_decisions(parser.add_argument_group("what is reported"))
    add_parameter_arguments(parser.add_argument_group("parameters and configuration"))
    _add_fixes(parser.add_argument_group("fixes"))
    _add_reporting(parser.add_argument_group("how it is reported"))
    _add_pages(parser.add_argument_group("about the rules"))


def add_exclusion_argument(parser: argparse.ArgumentParser) -> None:
    """Declare the option for excluded folders."""
    parser.add_argument(
        "--no-default-exclude",
        action="store_true",
        help="include folders of tools: .venv, node_modules, build and the like",
    )


def add_parameter_arguments(group: Any) -> None:
    """Declare the options that bind parameters and choose a configuration."""
    group.add_argument(
        "--param",
        metavar="NAME=VALUE",
        action="append",
        default=[],
        type=_binding,
        help="give a parameter a value; repeatable",
    )
    group.add_argument(
        "--params", metavar="FILE", type=_file, help="a TOML file with values of parameters"
    )
    source = group.add_mutually_exclusive_group()
    source.add_argument("--config", metavar="FILE", type=_file, help="use this configuration file")
    source.add_argument("--isolated", action="store_true", help="use no configuration file")


def add_floating_argument(parser: argparse.ArgumentParser) -> None:
    """Declare the option for the base of formats that say nothing of it."""
    parser.add_argument(
        "--floating-base",
        action="store_true",
        help="let the root link of a URDF or SDF float, whatever the file says",
    )


def add_robot_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the file of a robot in any format, and the options that decide what it says."""
    parser.add_argument(
        "file", metavar="FILE", help="a document, URDF, SDF or MJCF, or '-' for stdin"
    )
    add_floating_argument(parser)
    add_parameter_arguments(parser.add_argument_group("parameters and configuration"))


def _add_decisions(group: Any) -> None:
    group.add_argument(
        "--select", metavar="CODES", action="extend", type=_codes,
        help="only these rules: codes or prefixes, separated by commas",
    )  # fmt: skip
    group.add_argument(
        "--ignore", metavar="CODES", action="extend", type=_codes, help="not these rules"
    )
    group.add_argument(
        "--target", metavar="NAMES", action="extend", type=_targets,
        help=f"generators that must accept the documents: {', '.join(TARGETS)}",
    )  # fmt: skip
    group.add_argument(
        "--editor-settings", metavar="JSON", type=_editor_settings,
        help="the section 'kindsl' of an editor's settings, which a configuration file overrides",
    )  # fmt: skip
    group.add_argument(
        "--write-baseline", metavar="FILE",
        help="write what is found as known; see 'baseline' in kindsl.toml",
    )  # fmt: skip


def _add_fixes(group: Any) -> None:
    group.add_argument("--fix", action="store_true", help="apply the safe fixes")
    group.add_argument(
        "--unsafe-fixes", action="store_true", help="apply unsafe fixes too, with --fix or --diff"
    )
    group.add_argument("--diff", action="store_true", help="show what --fix would change")


def _add_reporting(group: Any) -> None:
    group.add_argument("--output-format", choices=FORMATS, default="text")
    group.add_argument(
        "--max-warnings", metavar="N", type=_natural, help="exit with 1 for more warnings than N"
    )
    group.add_argument("--exit-zero", action="store_true", help="exit with 0 despite findings")
    group.add_argument("--statistics", action="store_true", help="count the findings by rule")
    group.add_argument(
        "-v", "--verbose", action="store_true",
        help="repeated findings one by one; end with the verdict of each generator",
    )  # fmt: skip
    group.add_argument("-q", "--quiet", action="store_true", help="findings only, no summary")
    group.add_argument("--watch", action="store_true", help="lint again whenever a file changes")
    group.add_argument(
        "--jobs", metavar="N", type=_natural, default=0, help="number of processes (0: automatic)"
    )


def _add_pages(group: Any) -> None:
    group.add_argument("--explain", metavar="CODE", help="show the page of a rule")
    group.add_argument("--list-rules", action="store_true", help="all rules")


def _codes(text: str) -> list[str]:
    from kindsl.judgement.config.schema import is_code

    codes = _elements(text)
    for code in codes:
        if not is_code(code):
            raise argparse.ArgumentTypeError(f"no rule has a code that begins with '{code}'")
    return [code.upper() for code in codes]


def _targets(text: str) -> list[str]:
    targets = _elements(text)
    for target in targets:
        if target not in TARGETS:
            from kindsl.judgement.config.schema import did_you_mean

            hint = did_you_mean(target, TARGETS)
            raise argparse.ArgumentTypeError(f"unknown target '{target}'{hint}")
    return targets


def _editor_settings(text: str) -> Any:
    import json

    from kindsl.judgement.config.editor_settings import editor_settings

    try:
        found = editor_settings(json.loads(text))
    except (ValueError, RecursionError) as error:
        raise argparse.ArgumentTypeError(f"'{text}' is not JSON") from error
    if found.problems:
        raise argparse.ArgumentTypeError(found.problems[0])
    return found.rules


def _elements(text: str) -> list[str]:
    """Return comma-separated elements; an empty element, as from an empty variable, is an error."""
    elements = [element.strip() for element in text.split(",")]
    if not all(elements):
        raise argparse.ArgumentTypeError(f"'{text}' has an empty element" if text else "is empty")
    return elements


def _file(text: str) -> str:
    if not text:
        raise argparse.ArgumentTypeError("is empty")
    return text


def _binding(text: str) -> tuple[str, float]:
    name, equals, value = text.partition("=")
    if not equals or not name.strip():
        raise argparse.ArgumentTypeError(f"'{text}' is not NAME=VALUE")
    try:
        number = float(value)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise argparse.ArgumentTypeError(f"'{value}', the value of '{name}', is not a number")
    return name.strip(), number


def _natural(text: str) -> int:
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"'{text}' is not a natural number")
    return int(text)
