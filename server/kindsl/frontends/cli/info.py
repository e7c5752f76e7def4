"""Shows what a robot's file of any format describes: tree, degrees of freedom, masses, parameters.

examples:
  kindsl info arm.kindsl
  kindsl info arm.kindsl --param payload=0.5 --output-format json
"""

import argparse
import sys

from kindsl.frontends.cli.console import write
from kindsl.frontends.cli.documents.document_reading import note_errors, read_named, shown_name
from kindsl.frontends.cli.options import add_robot_arguments
from kindsl.products.reports.robot_facts import robot_facts

SUMMARY = "show the tree, masses and parameters of a document"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--output-format", choices=("text", "json"), default="text")
    add_robot_arguments(parser)


def run(args: argparse.Namespace) -> int:
    """Show the overview, of broken documents too.

    Returns:
        0, or 2 if the document cannot be read.
    """
    analysis = read_named(args)
    facts = robot_facts(analysis)
    if args.output_format == "json":
        import json

        write(sys.stdout, json.dumps({"path": shown_name(args.file), **facts}, indent=2) + "\n")
    else:
        from kindsl.products.reports.robot_text import robot_text

        write(sys.stdout, robot_text(facts))
    note_errors(args.file, analysis)
    return 0
