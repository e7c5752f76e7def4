"""A robot in another format: judged where it stands, computed as the document that it becomes."""

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.check_run import Checkpoint, Fault, go_on
from kindsl.judgement.analysis.diagnostics import Diagnostic, Findings, Resolver
from kindsl.judgement.analysis.known_findings import Apart
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Located
from kindsl.language.syntax.document import SyntaxDocument, parse
from kindsl.language.text.span import Span
from kindsl.robots.interchange.format import AS_WRITTEN, Format, FormatError, ReadingChoices
from kindsl.robots.interchange.kindsl_writing import described_kindsl
from kindsl.robots.interchange.syntaxes import XACRO_SUFFIX, other_format, syntax_of, unjudged
from kindsl.robots.interchange.xml_document import xml_of
from kindsl.robots.mechanism.errors import ModelError

if TYPE_CHECKING:
    from kindsl.robots.mechanism.build import Mechanism


class UnreadableRobotError(FormatError):
    """A file of another format describes no robot that can be shown; one sentence.

    Attributes:
        defects: The findings that say why, at their places; empty where only the sentence does.
    """

    def __init__(self, message: str, defects: Sequence[Diagnostic]) -> None:
        super().__init__(message)
        self.defects = defects


class TranslatedRobot(Analysis):
    """A robot of another format: text, findings and places are its file's, the model is ours.

    Attributes:
        refused: Why it can be shown, but not computed: sentences, mostly none.
    """

    def __init__(
        self,
        judged: Analysis,
        document: Analysis,
        names: Mapping[tuple[str, str], str],
        refused: tuple[str, ...],
    ) -> None:
        super().__init__(judged.syntax, document.settings)
        self._judged, self._document, self.refused = judged, document, refused
        self._names = names

    @cached_property
    def model(self) -> Model:
        """The robot, as a document would describe it."""
        return self._document.model

    @cached_property
    def resolver(self) -> Resolver:
        """The way from the model's links and joints to those of the file."""
        return _NamedPlaces(self.syntax, self._judged.model, self._names)

    @property
    def apart(self) -> Apart:
        """The findings in the file, those that the baseline knows, and what it knows in vain."""
        return self._judged.apart

    @property
    def faults(self) -> tuple[Fault, ...]:
        """Rules that failed by an internal error: their findings are missing."""
        return self._judged.faults

    def check(self, checkpoint: Checkpoint = go_on) -> Findings:
        """Return the findings in the file."""
        return self._judged.check(checkpoint)

    # It is compared with nothing.
    check_without_twins = check

    def unsilenced(self) -> list[Diagnostic]:
        """Return all findings, including those that comments or a baseline suppress."""
        return self._judged.unsilenced()

    def with_settings(self, settings: Settings) -> Analysis:
        """Return the analysis of the same text under other decisions."""
        document = self._document.with_settings(settings)
        judged = self._judged.with_settings(settings)
        return TranslatedRobot(judged, document, self._names, self.refused)

    def body_with(self, link: str) -> str:
        """Return the name in the model of what holds a link of the file; empty if nothing does."""
        return self._names.get(("link", link), "")

    def mechanism(self, parameters: Mapping[str, float] | None = None) -> "Mechanism":
        """Return the numbered bodies for mechanics; raises ModelError where it is only shown."""
        for reason in self.refused:
            raise ModelError(reason)
        return super().mechanism(parameters)


class _NamedPlaces(Resolver):
    """Finds links and joints of a model in the file that it was made from, by their names."""

    def __init__(
        self, written: SyntaxDocument, model: Model, names: Mapping[tuple[str, str], str]
    ) -> None:
        super().__init__(written)
        links = {str(link.name): link.name for link in reversed(model.links)}
        things = {"link": links, "frame": links}
        things["joint"] = {str(joint.name): joint.name for joint in reversed(model.joints)}
        # What is fixed to a link comes first, and the link's own name replaces it.
        of_file = (
            (name, things[kind].get(n)) for (kind, n), name in names.items() if kind in things
        )
        self._named: Mapping[str, Located] = {n: place for n, place in of_file if place is not None}

    def span(self, at: Located) -> Span:
        name = getattr(at, "name", at)
        found = self._named.get(name) if isinstance(name, str) else None
        return Span(0, 0) if found is None else super().span(found)


def analysed_robot(
    name: str,
    text: str,
    settings: Settings,
    path: Path | None = None,
    choices: ReadingChoices = AS_WRITTEN,
) -> Analysis:
    """Return the analysis of a robot's file, whatever its format.

    Args:
        name: The file's, which tells the format.
        settings: Decisions for it.
        path: Where it is read from with the files that it names; None for the text alone.
        choices: How another format is read.

    Raises:
        UnreadableRobotError: It is of another format, and describes no robot in it.
        ModuleNotFoundError: What its format needs is not installed.
    """
    format = other_format(name, text)
    if format is None:
        return Analysis(parse(text), settings)
    # What a xacro expands to is judged where it is linted.
    syntax = unjudged(text) if name.lower().endswith(XACRO_SUFFIX) else syntax_of(name, text)
    judged = Analysis(syntax if syntax.is_xml else unjudged(text), settings)
    try:
        document, names, refused = _translated(format, name, text, path, choices, settings)
    except FormatError as error:
        raise UnreadableRobotError(str(error), tuple(_defects(judged))) from None
    return TranslatedRobot(judged, document, names, refused)


def _translated(
    format: Format,
    name: str,
    text: str,
    path: Path | None,
    choices: ReadingChoices,
    settings: Settings,
) -> tuple[Analysis, Mapping[tuple[str, str], str], tuple[str, ...]]:
    if path is not None and format.read is not None:
        read = format.read(path, choices)
    elif format.parse is not None:
        read = format.parse(text, Path(name).stem, choices)
    else:
        raise FormatError(f"{format.title} is read from a file, which may name others")
    written = described_kindsl(read)
    joints = {**written.joints, **settings.joints}
    document = Analysis(parse(written.text), settings._replace(joints=joints))
    return document, written.names, read.refused


def _defects(judged: Analysis) -> Iterator[Diagnostic]:
    """Yield what keeps a file from being in its format."""
    codes = {flaw.code for flaw in xml_of(judged.syntax).flaws}
    yield from (finding for finding in judged.findings if finding.code in codes)
