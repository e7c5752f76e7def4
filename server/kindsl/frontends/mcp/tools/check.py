"""Judge a .kindsl robot or a URDF: impossible inertia, loops, names, wrong units.

Answers a JSON object: `summary`, and `findings`, the most severe first, each with code, message
(the likely cause with the number), place (line and column from 1), related places and the fix
that there is. Call it after each change of a document; `explain` has the page of a code.
"""

import json

from kindsl.frontends.mcp.documents import DocumentArguments, judged
from kindsl.frontends.mcp.folder import Folder
from kindsl.frontends.mcp.tool import Content, text
from kindsl.judgement.analysis.fixing import announced
from kindsl.judgement.rules.base import Severity
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.phrases import counted
from kindsl.products.reports.finding_objects import finding_object

_MOST = 100
_ORDER = list(Severity)


def run(arguments: DocumentArguments, folder: Folder) -> list[Content]:
    """Return the findings."""
    path, analysis = judged(arguments, folder)
    lines = LineIndex(analysis.text)
    findings = sorted(announced(analysis), key=lambda finding: _ORDER.index(finding.severity))
    numbers = [(kind, sum(f.severity is kind for f in findings)) for kind in _ORDER]
    summary = ", ".join(counted(n, kind.value) for kind, n in numbers if n) or "nothing found"
    answer = {
        "summary": summary,
        "findings": [finding_object(path, finding, lines) for finding in findings[:_MOST]],
        "left_out": max(0, len(findings) - _MOST),
    }
    return [text(json.dumps(answer, indent=1))]
