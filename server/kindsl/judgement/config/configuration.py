"""A valid configuration file."""

from typing import NamedTuple

from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.config.decisions import Decisions, TwinTable, overridden
from kindsl.judgement.config.errors import ConfigurationError, ConfigurationProblem
from kindsl.judgement.config.toml_places import KeyPath, Places
from kindsl.robots.comparison.twins import TwinFile

__all__ = ["Configuration", "ConfigurationError", "ConfigurationProblem", "DocumentTable"]


class DocumentTable(NamedTuple):
    """The decisions of one `[[document]]`.

    Attributes:
        pattern: The documents it is for, in the manner of `.gitignore`.
    """

    pattern: str
    decisions: Decisions


class Configuration(NamedTuple):
    """A valid configuration file.

    Attributes:
        text: Its text, for showing places in it.
        common: Settings of all documents below the file's folder.
        places: Where each key stands, by its path of keys and list indices.
        root: The keys before ours: `("tool", "kindsl")` in a pyproject.toml.
        baseline: The file of known findings, from the file's folder; empty without one.
        twins: Other files of robots.
        included: Patterns of URDFs that are linted, too, where a folder is.
    """

    path: str
    text: str
    common: Decisions
    documents: tuple[DocumentTable, ...]
    places: Places
    root: tuple[str, ...] = ()
    baseline: str = ""
    twins: tuple[TwinTable, ...] = ()
    included: tuple[str, ...] = ()

    @property
    def twin_files(self) -> tuple[TwinFile, ...]:
        """All twins, whatever the document."""
        return tuple(table.twin for table in self.twins)

    @property
    def has_bindings(self) -> bool:
        """True if it binds any parameter, limits any joint, names a pose or a twin."""
        tables = (self.common, *(document.decisions for document in self.documents))
        has_names = any(table.bindings or table.joints or table.poses for table in tables)
        return has_names or bool(self.twins)

    def includes(self, document: str) -> bool:
        """Return whether a robot in another format is linted where its folder is."""
        return any(self.is_match(pattern, document) for pattern in self.included)

    def keys_of(self, parameter: str, document: str) -> list[KeyPath]:
        """Return the keys that give a parameter of a document a value, the winning ones last."""
        found: list[KeyPath] = [self.root] if parameter in self.common.bindings else []
        found += [
            (*self.root, "document", number)
            for number, (pattern, decisions) in enumerate(self.documents)
            if parameter in decisions.bindings and self.is_match(pattern, document)
        ]
        return [(*keys, "parameters", parameter) for keys in found]

    def settings_for(self, document: str) -> Settings:
        """Return the decisions for a document, by its path, absolute or from the current folder."""
        settings = overridden(Settings(), self.common)
        for pattern, decisions in self.documents:
            if self.is_match(pattern, document):
                settings = overridden(settings, decisions)
        twins = (each.twin for each in self.twins if self.is_match(each.pattern, document))
        return settings._replace(twins=tuple(twins))

    def is_match(self, pattern: str, document: str) -> bool:
        """Return whether a document is one that a pattern in this file names."""
        # Imported where there are patterns only, since it delays the linter's start.
        from kindsl.judgement.config.patterns import is_match

        return is_match(self.path, pattern, document)
