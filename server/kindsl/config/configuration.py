"""What a project has decided, and what is wrong with how it says so."""

from collections.abc import Mapping
from typing import NamedTuple

from kindsl.rules.base import Severity
from kindsl.rules.settings import Settings
from kindsl.semantics.parameters import Binding


class Decisions(NamedTuple):
    """One table of decisions; None, or nothing, where the table says nothing.

    Attributes:
        targets: The generators that must accept the document.
        select: Codes or prefixes to run.
        ignore: Codes or prefixes to leave out.
        severity: Severity by code or prefix.
        bindings: Values of parameters.
    """

    targets: frozenset[str] | None = None
    select: tuple[str, ...] | None = None
    ignore: tuple[str, ...] | None = None
    severity: Mapping[str, Severity] = {}
    bindings: Mapping[str, Binding] = {}


class DocumentTable(NamedTuple):
    """The decisions of one `[[document]]`.

    Attributes:
        pattern: The documents it is for, in the manner of `.gitignore`.
        decisions: What it says of them.
    """

    pattern: str
    decisions: Decisions


class Place(NamedTuple):
    """Where a key stands: line and column from 1, offsets from 0, all in code points."""

    line: int
    column: int
    start: int
    end: int


class ConfigurationProblem(NamedTuple):
    """Something wrong in a configuration file.

    Attributes:
        path: The file.
        place: Where in it.
        key: The key in question, dotted; empty where the file as a whole is meant.
        message: One sentence without final period.
    """

    path: str
    place: Place
    key: str
    message: str

    def __str__(self) -> str:
        return f"{self.path}:{self.place.line}:{self.place.column}: error: {self.message}"


class ConfigurationError(Exception):
    """A configuration file cannot be used.

    Attributes:
        problems: All that is wrong with it, in the order of the file.
    """

    def __init__(self, problems: tuple[ConfigurationProblem, ...]) -> None:
        super().__init__("\n".join(map(str, problems)))
        self.problems = problems


class Configuration(NamedTuple):
    """A valid configuration file.

    Attributes:
        path: The file.
        text: Its text, for showing places in it.
        common: What holds for all documents below the file's folder.
        documents: What holds for some of them; later ones win.
        places: Where each key stands, by its path of keys and list indices.
        root: The keys before ours: `("tool", "kindsl")` in a pyproject.toml.
    """

    path: str
    text: str
    common: Decisions
    documents: tuple[DocumentTable, ...]
    places: Mapping[tuple[str | int, ...], tuple[int, int]]
    root: tuple[str, ...]

    @property
    def has_bindings(self) -> bool:
        """Whether it binds any parameter."""
        return bool(self.common.bindings) or any(d.decisions.bindings for d in self.documents)

    def tables_for(self, document: str) -> list[Decisions]:
        """Return the tables that hold for a document, the more particular later."""
        if not self.documents:
            return [self.common]
        from kindsl.config.patterns import is_match

        particular = [d.decisions for d in self.documents if is_match(self, d.pattern, document)]
        return [self.common, *particular]

    def settings_for(self, document: str) -> Settings:
        """Return the decisions for a document.

        Args:
            document: Its path, absolute or from the working directory.
        """
        settings = Settings()
        for table in self.tables_for(document):
            settings = overridden(settings, table)
        return settings


def overridden(settings: Settings, table: Decisions) -> Settings:
    """Return settings with what a table says put over them."""
    return Settings(
        settings.targets if table.targets is None else table.targets,
        settings.select if table.select is None else table.select,
        settings.ignore if table.ignore is None else table.ignore,
        {**settings.severity, **table.severity},
        {**settings.bindings, **table.bindings},
    )
