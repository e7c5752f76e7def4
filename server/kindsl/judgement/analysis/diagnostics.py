"""Findings with absolute offsets, as they are shown."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from kindsl.judgement.analysis.text_fix import TextFix
from kindsl.judgement.rules.base import Finding, Fix, Rule, Severity, Tag
from kindsl.judgement.rules.registry import page_address
from kindsl.judgement.rules.subject import DOCUMENT, Subject, subject_at
from kindsl.language.semantics.places import Located, Place
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.tree import Island
from kindsl.language.text.display import html_of
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.span import Span


class RelatedPlace(NamedTuple):
    """Another place of the same document."""

    start: int
    end: int
    message: str


class Diagnostic(NamedTuple):
    """A finding as it is shown; offsets in code points of the document, `end` exclusive.

    Attributes:
        probability: Of the cause that the message names, where one was weighed against others.
        also: Other things that it is about as well.
    """

    code: str
    name: str
    severity: Severity
    message: str
    start: int
    end: int
    related: tuple[RelatedPlace, ...] = ()
    fix: TextFix | None = None
    tag: Tag | None = None
    choices: tuple[TextFix, ...] = ()
    explains: frozenset[str] = frozenset()
    subject: Subject = DOCUMENT
    probability: float | None = None
    also: tuple[Subject, ...] = ()

    @property
    def url(self) -> str | None:
        """The address of the rule's page, a file of the installed package."""
        return page_address(self.code)


class Findings(tuple[Diagnostic, ...]):
    """Findings of one text, in its order; a notebook shows them with their source lines."""

    text: str

    def __new__(cls, findings: Iterable[Diagnostic], text: str) -> "Findings":
        """Return the findings of a text."""
        self = super().__new__(cls, findings)
        self.text = text
        return self

    def __getnewargs__(self) -> tuple[tuple[Diagnostic, ...], str]:
        return tuple(self), self.text

    def _repr_html_(self) -> str | None:
        return html_of(self)


class Resolver:
    """Turns places in islands into absolute offsets."""

    def __init__(self, document: SyntaxDocument) -> None:
        self._document = document
        self._starts: Mapping[int, int] = {
            id(island): start
            for island, start in zip(document.islands, document.starts, strict=False)
        }

    def span(self, at: Located) -> Span:
        """Return a place with absolute offsets."""
        origin = self._starts[id(at.island)]
        return Span(origin + at.start, origin + at.end)

    def edit(self, at: Located, text: str) -> TextEdit:
        """Return the edit of the document that puts a text in a place."""
        return TextEdit(*self.span(at), text)

    def edit_of(self, island: Island, edit: TextEdit) -> TextEdit:
        """Return an edit of an island as one of the document."""
        return self.edit(Place(island, edit.start, edit.end), edit.text)

    def edits(self, fix: Fix) -> tuple[TextEdit, ...]:
        """Return the edits of a fix in the document, in their order there."""
        return tuple(sorted(self.edit(change.at, change.text) for change in fix.changes))

    def diagnostic(self, rule: Rule, finding: Finding, severity: Severity) -> Diagnostic:
        """Return a finding with absolute offsets."""
        start, end = self.span(finding.at)
        related = tuple(RelatedPlace(*self.span(r.at), r.message) for r in finding.related)
        return Diagnostic(
            rule.code,
            rule.name,
            severity,
            finding.message,
            start,
            end,
            related,
            self._fix(finding.fix) if finding.fix else None,
            finding.tag,
            tuple(map(self._fix, finding.choices)),
            finding.explains,
            finding.subject or subject_at(finding.at),
            finding.probability,
            tuple(map(subject_at, finding.also)),
        )

    def _fix(self, fix: Fix) -> TextFix:
        edits = self.edits(fix)
        return TextFix(fix.title, fix.is_safe, edits, fix.is_within_digits, self._document)
