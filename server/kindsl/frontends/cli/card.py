"""Writes a page about a document for a wiki or a paper.

It has a picture, the tree, joints, masses, frames, parameters, each joint's transform in closed
form, and the document's health. Broken documents are shown as far as they go. Markdown that is
written to a file has its picture in a file beside it. Pandoc makes LaTeX and PDF of it.

examples:
  kindsl card arm.kindsl -o arm.md
  kindsl card arm.kindsl --param payload=0.5 -o arm.md
  pandoc arm.md --from gfm --standalone --output arm.tex
"""

import argparse

from kindsl.frontends.cli.documents.document_reading import note_errors, read_named, refusals
from kindsl.frontends.cli.documents.sources import STDIN
from kindsl.frontends.cli.documents.writing import write_output
from kindsl.frontends.cli.options import add_robot_arguments

SUMMARY = "write a page about a document: picture, tables, transforms"
FORMATS = ("markdown", "html")
_PANDOC = "pandoc card.md --from gfm --standalone --output card.tex"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--output-format", type=_output_format, choices=FORMATS, default="markdown")
    parser.add_argument(
        "-o", "--output", metavar="OUT", help="write to this file instead of stdout"
    )
    parser.add_argument(
        "--pose", metavar="NAME", help="picture a pose of kindsl.toml: [poses.NAME]"
    )
    add_robot_arguments(parser)


def _output_format(text: str) -> str:
    if text == "latex":
        message = f"LaTeX is written by pandoc: kindsl card FILE -o card.md && {_PANDOC}"
        raise argparse.ArgumentTypeError(message)
    return text


def run(args: argparse.Namespace) -> int:
    """Write the page.

    Returns:
        0, or 2 if the document cannot be read or the page cannot be written.

    Raises:
        CommandError: The configuration has no such pose for this robot.
    """
    analysis = read_named(args)
    from kindsl.judgement.analysis.settings import PoseError
    from kindsl.products.reports.card import card_page
    from kindsl.products.reports.page.html import html_text
    from kindsl.products.reports.page.markdown import markdown_text, with_pictures

    with refusals(args.file, PoseError):
        page = card_page(analysis, args.pose)
    if args.output_format == "markdown" and args.output is not None:
        # What shows Markdown strips pictures that are in it.
        text, pictures = with_pictures(page, args.output)
        write_output(args.output, text, pictures)
    else:
        text = html_text(page) if args.output_format == "html" else markdown_text(page)
        write_output(args.output or STDIN, text)
    note_errors(args.file, analysis)
    return 0
