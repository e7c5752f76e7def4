"""Lints a xacro file: what it expands to, at the places in the files that this comes from."""

from pathlib import Path

from kindsl.frontends.cli.documents.sources import read_text
from kindsl.frontends.cli.documents.walking import shown_path
from kindsl.frontends.cli.outcome import Failure, LintedFile
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.urdf.document import urdf_document
from kindsl.robots.interchange.xacro.expansion import expanded
from kindsl.robots.interchange.xacro.origins import Origin, origin


def expanded_files(
    path: str, shown: str, text: str, settings: Settings
) -> tuple[LintedFile, ...] | Failure:
    """Return a xacro file and those that it includes, with what is found in the whole robot.

    It evaluates Python expressions. Nothing is found in a file that only holds macros, and nothing
    is fixed.
    """
    try:
        expansion = expanded(Path(path), is_marked=True).decode("utf-8")
    except FormatError as error:
        return Failure(shown, str(error))
    analysis = Analysis(urdf_document(expansion), settings)
    texts = {path: text}

    def read(file: str) -> str:
        if file not in texts:
            known = read_text(file, file)
            texts[file] = known if isinstance(known, str) else ""
        return texts[file]

    found: dict[str, dict[object, Diagnostic]] = {path: {}}
    for each in analysis.findings if analysis.model.links else ():
        at = origin(expansion, each.start, each.end, read) or Origin(path, 0, 0)
        moved = each._replace(start=at.start, end=at.end, related=(), fix=None, choices=())
        found.setdefault(at.file, {})[at.start, each.code, each.message] = moved
    files = []
    for file, told in found.items():
        name = shown if file == path else shown_path(file)
        files.append(LintedFile(name, texts[file], sorted(told.values(), key=lambda d: d.start)))
    return tuple(files)
