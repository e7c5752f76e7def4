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
    parameters: dict[str, float] = Field({}, description="Values of parameters by their names")


def run(arguments: DiffArguments, folder: Folder) -> list[Content]:
    """Return what differs."""
    both = arguments.a, arguments.b
    values, notes = arguments.parameters, list[str]()
    sides = {p: compared_document(p, folder, values) for p in both if is_document(p)}
    bases = [side.robot.skeleton.is_floating for side in sides.values()]
    for path in both:
        if path not in sides:
            sides[path], told = compared_other(path, folder, bases[0] if bases else None)
            notes += (f"note: {note}" for note in told)
    old, new = (sides[path] for path in both)
    report = report_of(old, new, compared_mechanics(old.robot, new.robot))
    found = "\n".join((*lines(report), *notes))
    return [text(found), text(json.dumps(facts(report), indent=1))]
