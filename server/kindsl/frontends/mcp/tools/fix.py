"""Apply fixes to a .kindsl document and answer the difference, as a unified diff.

Safe fixes keep every number. With `unsafe`, the likely repairs of wrong numbers are made, too: look
at each. A file is written only with `apply`.
"""

from kindsl.frontends.mcp.documents import DocumentArguments, document
from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.tool import Content, Field, text
from kindsl.judgement.analysis.fixing import fixed, is_fixable, is_safe
from kindsl.language.text.phrases import counted
from kindsl.language.text.unified_diff import unified_diff


class FixArguments(DocumentArguments):
    """A document and which fixes."""

    unsafe: bool = Field(False, description="Also make repairs that change numbers")
    apply: bool = Field(False, description="Write the file at 'path'")


def run(arguments: FixArguments, folder: Folder) -> list[Content]:
    """Return the difference; write the file if that is asked."""
    if arguments.apply and arguments.path is None:
        raise ToolError("'apply' writes a file: give 'path', not 'text'")
    path, analysis = document(arguments, folder)
    found = fixed(analysis, is_fixable if arguments.unsafe else is_safe)
    new = found.analysis.text
    if new == analysis.text:
        return [text("No fix to make.")]
    if arguments.apply:
        folder.write(path, new)
    done = "written" if arguments.apply else "not written: call again with 'apply' to write it"
    done = f"{counted(found.n_findings, 'finding')} fixed, {done}."
    return [text(done), text(unified_diff(path, analysis.text, new))]
