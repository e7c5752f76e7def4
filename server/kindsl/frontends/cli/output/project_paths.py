"""Paths and identities for CI services."""

import os
from collections.abc import Iterator
from hashlib import sha256

from kindsl.frontends.cli.outcome import LintedFile, RunOutcome
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.language.text.printable import printable

_ROOTS = ("CI_PROJECT_DIR", "GITHUB_WORKSPACE")


def project_path(path: str) -> str:
    """Return a path from the root of the checkout, with slashes; absolute outside of it."""
    root = next((os.environ[name] for name in _ROOTS if os.environ.get(name)), os.getcwd())
    absolute = os.path.abspath(path)
    relative = os.path.relpath(absolute, root)
    return printable(absolute if relative.startswith("..") else relative).replace(os.sep, "/")


def fingerprints(outcome: RunOutcome) -> Iterator[tuple[LintedFile, Diagnostic, str]]:
    """Yield each finding with an identity that does not change when lines move."""
    for file in outcome.files:
        counts: dict[str, int] = {}
        path = project_path(file.path)
        for finding in file.findings:
            identity = f"{path}\0{finding.code}\0{finding.message}"
            counts[identity] = counts.get(identity, 0) + 1
            full = f"{identity}\0{counts[identity]}".encode("utf-8", "replace")
            yield file, finding, sha256(full).hexdigest()
