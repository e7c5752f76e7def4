"""Texts of a file at two commits, through git."""

import os
import subprocess
from typing import NamedTuple

from kindsl.frontends.cli.documents.document_reading import CommandError
from kindsl.language.text.encodings import decoded

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
        raise CommandError.about("--git", f"'{text}' is not BASE..HEAD")
    return Commits(base, head or "HEAD")


class Texts(NamedTuple):
    """The texts of a file at two commits, None where it is not there.

    Its name at the first one, from the repository's root, is told if that differs.
    """

    old: str | None
    new: str | None
    old_name: str | None = None


def versions_of(path: str, commits: Commits) -> Texts:
    """Return the texts of a file at two commits, under its former name if it was renamed.

    Raises:
        CommandError: There is no git, no repository, no such commit, or no such file in both.
    """
    folder, name = os.path.split(os.path.abspath(path))
    prefix = _git(path, folder, "not a git repository", "rev-parse", "--show-prefix")
    for commit in commits:
        unknown = f"'{commit}' is not a commit of its git repository"
        _git(path, folder, unknown, "rev-parse", "--verify", "--quiet", f"{commit}^{{commit}}")
    place = os.fsdecode(prefix.removesuffix(b"\n")) + name
    old, new = (_text_at(commit, place, path, folder) for commit in commits)
    if old is None and new is None:
        raise CommandError.about(path, f"does not exist in {commits.base} or {commits.head}")
    former = _former_name(place, commits, path, folder) if old is None else None
    if former is None:
        return Texts(old, new)
    return Texts(_text_at(commits.base, former, path, folder), new, former)


def _text_at(commit: str, place: str, path: str, folder: str) -> str | None:
    listed = _git(path, folder, "git fails", "ls-tree", "-z", "--full-tree", commit, "--", place)
    if b" blob " not in listed:
        return None
    content = _git(path, folder, "git fails", "show", f"{commit}:{place}")
    return decoded(content)


def _former_name(place: str, commits: Commits, path: str, folder: str) -> str | None:
    options = ("--name-status", "-z", "-M", "--diff-filter=R", "--no-relative", "--no-ext-diff")
    told = _git(path, folder, "git fails", "diff", *options, *commits, "--")
    # A status, the old name, the new one, and so on.
    fields = os.fsdecode(told).split("\0")
    pairs = zip(fields[1::3], fields[2::3], strict=False)
    return next((old for old, new in pairs if new == place), None)


def short(commit: str) -> str:
    """Return the name to report for a commit: full hashes shortened."""
    is_hash = len(commit) == 40 and all(c in "0123456789abcdef" for c in commit)
    return commit[:_SHORT] if is_hash else commit


def _git(path: str, folder: str, failure: str, *arguments: str) -> bytes:
    if not os.path.isdir(folder):
        raise CommandError.about(path, "no such file or folder")
    try:
        run = subprocess.run(
            ["git", "--literal-pathspecs", "-C", folder, *arguments],
            capture_output=True,
            timeout=_PATIENCE,
            check=False,
        )
    except FileNotFoundError:
        raise CommandError.about(path, "git is not installed") from None
    except subprocess.TimeoutExpired:
        raise CommandError.about(path, "git does not answer") from None
    if run.returncode:
        raise CommandError.about(path, failure)
    return run.stdout
