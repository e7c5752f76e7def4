"""Texts of a file at two commits, through git."""

import os
import subprocess
from typing import NamedTuple

from kindsl.cli.documents.reading import CommandError
from kindsl.cli.outcome import Failure

_PATIENCE = 60  # seconds
_SHORT = 12


class Commits(NamedTuple):
    """Two commits as somebody named them."""

    base: str
    head: str


def commits_of(text: str) -> Commits:
    """Return the commits of `BASE..HEAD`.

    Raises:
        CommandError: It is not of that form.
    """
    base, dots, head = text.partition("..")
    if not dots or not base or base.startswith("-") or head.startswith(("-", ".")):
        raise CommandError([Failure("--git", f"'{text}' is not BASE..HEAD")])
    return Commits(base, head or "HEAD")


def text_at(commit: str, path: str) -> str:
    """Return the text of a file at a commit.

    Raises:
        CommandError: There is no git, no repository, no such commit, or no such file in it.
    """
    folder, name = os.path.split(os.path.abspath(path))
    _git(path, folder, "no git repository", "rev-parse", "--show-toplevel")
    unknown = f"'{commit}' is no commit of its git repository"
    _git(path, folder, unknown, "rev-parse", "--verify", "--quiet", f"{commit}^{{commit}}")
    content = _git(path, folder, f"does not exist in {commit}", "show", f"{commit}:./{name}")
    return content.decode("utf-8", "surrogateescape")


def short(commit: str) -> str:
    """Return what to call a commit: full hashes shortened."""
    is_hash = len(commit) == 40 and all(c in "0123456789abcdef" for c in commit)
    return commit[:_SHORT] if is_hash else commit


def _git(path: str, folder: str, failure: str, *arguments: str) -> bytes:
    if not os.path.isdir(folder):
        raise CommandError([Failure(path, "no such file or folder")])
    try:
        run = subprocess.run(
            ["git", "-C", folder, *arguments], capture_output=True, timeout=_PATIENCE, check=False
        )
    except FileNotFoundError:
        raise CommandError([Failure(path, "git is not installed")]) from None
    except subprocess.TimeoutExpired:
        raise CommandError([Failure(path, "git does not answer")]) from None
    if run.returncode:
        raise CommandError([Failure(path, failure)])
    return run.stdout
