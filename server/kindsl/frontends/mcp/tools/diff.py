"""Compare the mechanics of two robots: what moves where, what weighs what.

Each is a file of any format (.kindsl, .urdf, .sdf, .xml of MuJoCo) or a folder of generated code.
Names of links, their frames and signs of axes do not count. Answers which numbers differ, the one
that changes torques most first.
"""

import json
from functools import partial

from kindsl.frontends.mcp.folder import Folder
from kindsl.frontends.mcp.robots import compared_robot, read_other
from kindsl.frontends.mcp.tool import Arguments, Content, Field, text
from kindsl.products.reports.mechanics import facts, lines, report_of
from kindsl.robots.comparison.mechanical import compared_mechanics
from kindsl.robots.interchange.descriptions import read_foreign


class DiffArguments(Arguments):
    """Two robots."""

    a: str = Field(description="A file or folder, from the server's folder")
    b: str = Field(description="Another")
    parameters: dict[str, float] = Field({}, description="Values of parameters by their names")


def run(arguments: DiffArguments, folder: Folder) -> list[Content]:
    """Return what differs."""
    both, values = (arguments.a, arguments.b), arguments.parameters
    sides = {p: compared_robot(p, folder, values) for p in both if p.endswith(".kindsl")}
    others = [path for path in both if path not in sides]
    foreign = read_foreign(others, sides.values(), partial(read_other, folder))
    sides |= {path: read.robot for path, read in foreign.items()}
    notes = [f"note: {note}" for read in foreign.values() for note in read.notes]
    old, new = (sides[path] for path in both)
    report = report_of(old, new, compared_mechanics(old, new))
    found = "\n".join((*lines(report), *notes))
    return [text(found), text(json.dumps(facts(report), indent=1))]
