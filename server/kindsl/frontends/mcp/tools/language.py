"""Explain how to write a robot in the Kinematics-DSL: its grammar, its units, two whole examples.

Ask this before you write a document. A target, robcogen or robcogen2, is the generator that shall
read it; what only the other one takes is left out.
"""

import re

from kindsl.frontends.mcp.examples import examples
from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.tool import Arguments, Content, Field, text
from kindsl.judgement.rules.context import TARGETS
from kindsl.language.syntax.grammars import grammar_text

_CONVENTIONS = """\
Units are m, rad, kg, kg m²; nothing is converted. A number that is no id has a decimal point (1.0).
A joint moves about, or along, the z axis of its frame. `ref_frame` places that frame in its
predecessor's: a translation, then turns about x, the new y, the new z. The frame of a link is that
of its joint. CoM and moments are in the link's frame and about its origin, not about the CoM; the
products are positive integrals with a minus in the tensor: [[Ix, -Ixy, -Ixz], ...].
Every joint stands once as `link via joint` under `children` of the body that carries it.
"""
_ONLY = re.compile(r"\s*//: only (\w+)\s*$")


class TargetArguments(Arguments):
    """A generator."""

    target: str | None = Field(None, description="robcogen or robcogen2; default: what both take")


def run(arguments: TargetArguments, _folder: Folder) -> list[Content]:
    """Return the grammar and examples."""
    target = arguments.target
    if target is not None and target not in TARGETS:
        raise ToolError(f"there is no target '{target}': {' or '.join(sorted(TARGETS))}")
    lines = [(line, _ONLY.search(line)) for line in grammar_text("kindsl.lark").splitlines()]
    grammar = "\n".join(line for line, only in lines if only is None or only[1] == target)
    return [text(_CONVENTIONS), text(grammar), *map(text, examples())]
