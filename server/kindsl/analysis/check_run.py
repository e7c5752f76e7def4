"""Runs rules over a document; if one of them fails, the others still report."""

from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple, TypeAlias

from kindsl.rules.base import Finding, Rule
from kindsl.rules.context import Context
from kindsl.semantics.declarations import Declarations
from kindsl.semantics.model import Model
from kindsl.syntax.tree import Island
from kindsl.text.facts import Fact

Found: TypeAlias = list[tuple[Rule, Finding]]
Checkpoint: TypeAlias = Callable[[], None]

# What the findings of an island depend on besides it: the rules, and what they may see.
_Key = tuple[tuple[Rule, ...], object]
_FINDINGS: "Fact[tuple[_Key, Found]]" = Fact("findings")


class Fault(NamedTuple):
    """A rule that failed, by an internal error."""

    rule: Rule
    error: Exception

    @property
    def message(self) -> str:
        """The failure in words."""
        return f"{self.rule.code} failed: {type(self.error).__name__}: {self.error}"


def go_on() -> None:
    """Stop nothing."""


class CheckRun:
    """One run of rules.

    Attributes:
        faults: The rules that failed so far.
    """

    def __init__(self, checkpoint: Checkpoint) -> None:
        self.faults: list[Fault] = []
        self._checkpoint = checkpoint

    def document_findings(self, rules: Iterable[Rule], model: Model, context: Context) -> Found:
        """Return the findings of the rules that see the whole model."""
        found: Found = []
        for rule in rules:
            if rule.check_document is not None:
                self._checkpoint()
                found += self._of(rule, rule.check_document(model, context))
        return found

    def island_findings(self, rules: Iterable[Rule], model: Model, context: Context) -> Found:
        """Return the findings of the rules that see one island, from its memory if unchanged."""
        found: Found = []
        local = tuple(rule for rule in rules if rule.check_island is not None)
        for island, declared, symbols in zip(
            model.islands, model.declared, model.symbols, strict=True
        ):
            uses_values = bool(symbols.parameters or symbols.constants)
            key = (local, context.key if uses_values else context.targets)
            known = island.facts.get(_FINDINGS)
            if known is None or known[0] != key:
                self._checkpoint()
                known = self._remembered(island, declared, key, context)
            found += known[1]
        return found

    def _remembered(
        self, island: Island, declared: Declarations, key: _Key, context: Context
    ) -> tuple[_Key, Found]:
        found: Found = []
        n_faults = len(self.faults)
        for rule in key[0]:
            if rule.check_island is not None:
                found += self._of(rule, rule.check_island(declared, context))
        if len(self.faults) == n_faults:
            island.facts.keep(_FINDINGS, (key, found))
        return key, found

    def _of(self, rule: Rule, findings: Iterator[Finding]) -> Found:
        """Return all findings of a rule, those before a fault too."""
        found: Found = []
        try:
            for finding in findings:
                found.append((rule, finding))
        except Exception as error:
            self.faults.append(Fault(rule, error))
        return found
