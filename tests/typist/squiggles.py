"""A hand that types key by key, and the squiggles that it sees come and go in the line it types."""

from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from lsprotocol import types

from kindsl.frontends.lsp.session.calm import Calm
from kindsl.frontends.lsp.text.document import Document
from kindsl.frontends.lsp.text.open_documents import Documents
from kindsl.judgement.analysis.analysis import Analysis, analyse

_URI = "untitled:typed"
_PAIRS = {"{": "}", "(": ")"}


class Key(NamedTuple):
    """What a key does in an editor that closes brackets.

    Attributes:
        offset: Where it writes.
        text: What it writes; nothing where it steps over what is there.
        ends_line: Whether it is Enter.
    """

    offset: int
    text: str
    ends_line: bool


def keys(lines: list[str]) -> Iterator[Key]:
    """Yield the keys of a hand that types lines into an empty document, Enter after each."""
    at, behind = 0, ""
    for line in lines:
        if line == "}" and behind.lstrip().startswith("}"):
            at, behind = at + behind.index("}"), behind[behind.index("}") :]
        for character in line:
            if character in ")}" and behind.startswith(character):
                behind, text = behind[1:], ""
            else:
                closing = _PAIRS.get(character, "") if behind[:1] in ("", "\n", ")", "}") else ""
                behind, text = closing + behind, character + closing
            yield Key(at, text, ends_line=False)
            at += 1
        between = line.endswith("{") and behind.startswith("}")
        behind = "\n" + behind if between else behind
        yield Key(at, "\n\n" if between else "\n", ends_line=True)
        at += 1


class Passing(NamedTuple):
    """A squiggle that came while a line was typed and was gone when the line was done."""

    line: str
    code: str
    message: str


def passing_squiggles(lines: list[str], *, is_calm: bool = True) -> list[Passing]:
    """Return the squiggles that come and go within a line, all versions being checked.

    Args:
        lines: What is typed.
        is_calm: Whether what is told is what the server tells, else all that is found.
    """
    documents = Documents()
    calm = Calm(documents)
    documents.open(types.TextDocumentItem(_URI, "kinematics-dsl", 0, ""))
    calm.shown(_typed(documents), ())
    before: Counter[tuple[str, str]] = Counter()
    came: set[tuple[str, str]] = set()
    passed: list[Passing] = []
    rows = iter(lines)
    for version, key in enumerate(keys(lines), 1):
        _press(documents, key, version)
        document = _typed(documents)
        findings = Analysis(document.tree, _SETTINGS).findings
        told = calm.shown(document, findings) if is_calm else findings
        now = Counter((each.code, each.message) for each in told)
        came |= set(now - before)
        before = now
        if key.ends_line:
            line = next(rows)
            passed += [Passing(line, *gone) for gone in sorted(came - set(now))]
            came = set()
    return passed


_SETTINGS = analyse("").settings


def _typed(documents: Documents) -> Document:
    document = documents.get(_URI)
    assert document is not None
    return document


def _press(documents: Documents, key: Key, version: int) -> None:
    at = _typed(documents).position(key.offset)
    change = types.TextDocumentContentChangePartial(types.Range(at, at), key.text)
    identifier = types.VersionedTextDocumentIdentifier(version, _URI)
    documents.change(types.DidChangeTextDocumentParams(identifier, [change]))
