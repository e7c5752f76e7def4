"""A document with everything that is known of it: syntax, model, findings."""

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from kindsl.rules.base import Finding, Rule
from kindsl.rules.context import Context
from kindsl.rules.diagnostics import Diagnostic, Resolver
from kindsl.rules.kd704_unused_suppression import RULE as UNUSED_SUPPRESSION
from kindsl.rules.kd704_unused_suppression import unused_suppressions
from kindsl.rules.registry import all_rules
from kindsl.rules.settings import Settings, is_enabled, severity_of
from kindsl.rules.suppression import suppressions
from kindsl.rules.syntax_findings import syntax_findings
from kindsl.semantics.declarations import Declarations
from kindsl.semantics.model import Model
from kindsl.syntax.collector import paused_collector
from kindsl.syntax.document import SyntaxDocument, parse
from kindsl.syntax.tree import Island
from kindsl.text.edits import TextEdit

if TYPE_CHECKING:
    from kindsl.mechanism.build import Mechanism

_NO_SETTINGS = Settings()
# What the findings of an island depend on besides it: the rules, and what they may see.
_Key = tuple[tuple[Rule, ...], object]


class Analysis:
    """An immutable document; everything else about it is computed when asked for, once.

    Attributes:
        syntax: Its text and syntax.
        settings: What the user decided.
    """

    def __init__(self, syntax: SyntaxDocument, settings: Settings = _NO_SETTINGS) -> None:
        self.syntax = syntax
        self.settings = settings

    @property
    def text(self) -> str:
        """The source."""
        return self.syntax.text

    @cached_property
    def model(self) -> Model:
        """The robot, as far as the text describes one."""
        return Model(self.syntax.islands)

    @cached_property
    def context(self) -> Context:
        """Targets and values that the rules see."""
        return Context(self.settings.targets, self.settings.bindings, self.model)

    @cached_property
    def resolver(self) -> Resolver:
        """The way from places in islands to absolute offsets."""
        return Resolver(self.syntax.islands, self.syntax.starts)

    @cached_property
    def findings(self) -> tuple[Diagnostic, ...]:
        """What is wrong, in the order of the text, silenced findings left out."""
        with paused_collector():
            found = [self._resolve(rule, finding) for rule, finding in self._raw_findings()]
        silenced = suppressions(self.syntax.islands, self.syntax.starts, len(self.text))
        if silenced:
            kept = [d for d in found if not any(s.covers(d) for s in silenced)]
            enabled = [rule.code for rule in all_rules() if is_enabled(rule, self.settings)]
            unused = [s for s in silenced if not any(s.covers(d) for d in found)]
            found = kept
            if UNUSED_SUPPRESSION.code in enabled:
                found += [
                    self._resolve(UNUSED_SUPPRESSION, finding)
                    for finding in unused_suppressions(unused, enabled)
                ]
        return tuple(sorted(found, key=lambda d: (d.start, d.end, d.code, d.message)))

    def edited(self, edits: Sequence[TextEdit]) -> "Analysis":
        """Return the analysis of the edited text; what no edit touches is not computed again."""
        return Analysis(self.syntax.edited(edits), self.settings)

    def with_settings(self, settings: Settings) -> "Analysis":
        """Return the analysis of the same text under other decisions."""
        return Analysis(self.syntax, settings)

    def mechanism(self, parameters: dict[str, float] | None = None) -> "Mechanism":
        """Return the numbered bodies for mechanics; needs NumPy.

        Args:
            parameters: Values that win over all other bindings.

        Raises:
            UnboundParameterError: A parameter has no value.
            ModelError: The document does not describe a kinematic tree.
        """
        from kindsl.mechanism.build import mechanism_of

        return mechanism_of(self.model, {**self.context.values, **(parameters or {})})

    def _resolve(self, rule: Rule, finding: Finding) -> Diagnostic:
        severity = severity_of(rule, finding.severity, self.settings)
        return self.resolver.diagnostic(rule, finding, severity)

    def _raw_findings(self) -> Iterator[tuple[Rule, Finding]]:
        yield from syntax_findings(self.syntax)
        rules = [rule for rule in all_rules() if is_enabled(rule, self.settings)]
        for rule in rules:
            if rule.check_document is not None:
                for finding in rule.check_document(self.model, self.context):
                    yield rule, finding
        local = tuple(rule for rule in rules if rule.check_island is not None)
        for island, declared, symbols in zip(
            self.model.islands, self.model.declared, self.model.symbols, strict=True
        ):
            uses_values = bool(symbols.parameters or symbols.constants)
            key = (local, self.context.key if uses_values else self.context.targets)
            yield from _island_findings(island, declared, key, self.context)


def analyse(text: str, settings: Settings = _NO_SETTINGS) -> Analysis:
    """Return the analysis of a text; never raises, whatever the text."""
    return Analysis(parse(text), settings)


def _island_findings(
    island: Island, declared: Declarations, key: _Key, context: Context
) -> list[tuple[Rule, Finding]]:
    """Return what the island rules find, from the island's memory where nothing changed."""
    known = island.facts.get("findings")
    if isinstance(known, tuple) and known[0] == key:
        return known[1]  # type: ignore[no-any-return]
    found = [
        (rule, finding)
        for rule in key[0]
        if rule.check_island is not None
        for finding in rule.check_island(declared, context)
    ]
    island.facts["findings"] = key, found
    return found
