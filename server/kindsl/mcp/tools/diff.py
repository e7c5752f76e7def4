"""Compare the mechanics of two robots: what moves where, what weighs what.

Each is a file of any format (.kindsl, .urdf, .sdf, .xml of MuJoCo) or a folder of generated code.
Names of links, their frames and signs of axes do not count. Answers which numbers differ, the one
that changes torques most first.
"""

import json

from kindsl.comparison.mechanical import compared_mechanics
from kindsl.mcp.folder import Folder
from kindsl.mcp.robots import compared_document, compared_other, is_document
from kindsl.mcp.tool import Arguments, Content, Field, text
from kindsl.reports.mechanics import facts, lines, report_of


class DiffArguments(Arguments):
    """Two robots."""

    a: str = Field(description="A file or folder, from the server's folder")
    b: str = Field(description="Another")


def run(arguments: DiffArguments, folder: Folder) -> list[Content]:
    """Return what differs."""
    both = arguments.a, arguments.b
    documents = {path: compared_document(path, folder) for path in both if is_document(path)}
    bases = [side.robot.skeleton.is_floating for side in documents.values()]
    floating = bases[0] if bases else None
    old, new = (documents.get(path) or compared_other(path, folder, floating) for path in both)
    report = report_of(old, new, compared_mechanics(old.robot, new.robot))
    return [text("\n".join(lines(report))), text(json.dumps(facts(report), indent=1))]
