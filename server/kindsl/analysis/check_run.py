"""Runs rules over a document; if one of them fails, the others still report."""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import NamedTuple, TypeAlias

from kindsl.rules.base import Finding, Rule
from kindsl.rules.context import Context
from kindsl.semantics.aspects import Aspect
from kindsl.semantics.declarations import Declarations
from kindsl.semantics.model import Model, ModelPart
from kindsl.semantics.parameters import Symbols
from kindsl.syntax.document import Chunk
from kindsl.syntax.tree import Island
from kindsl.text.facts import Fact

_RuleFinding: TypeAlias = tuple[Rule, Finding]
Found: TypeAlias = list[_RuleFinding]
_Findings = Iterator[_RuleFinding]
Checkpoint: TypeAlias = Callable[[], None]

# What findings depend on besides what they are kept with.
_Key = tuple[object, ...]


class _Known(NamedTuple):
    """Findings of rules.

    Attributes:
        key: What that depends on.
        found: What it found.
        islands: All islands to which that points.
    """

    key: _Key
    found: Found
    islands: frozenset[Island]


_OF_ISLANDS = Fact[_Known]("findings of islands")
_OF_BODIES = Fact[_Known]("findings of bodies")
_BY_CODE = Fact[dict[str, _Known]]("findings of documents")


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
    """One run of rules over a version of a document; what holds since the last one is not run.

    Attributes:
        faults: The rules that failed so far.
        is_without_twins: Whether no twin is read: of what they say otherwise, what the last
            version had in islands that are here, too, stays.
    """

    def __init__(
        self,
        checkpoint: Checkpoint,
        model: Model,
        context: Context,
        *,
        is_without_twins: bool = False,
    ) -> None:
        self.faults: list[Fault] = []
        self.is_without_twins = is_without_twins
        self._checkpoint, self._model, self._context = checkpoint, model, context
        self._islands = frozenset(model.islands)
        self._keys: dict[Aspect, _Key] = {}

    def document_findings(self, rules: Iterable[Rule]) -> Found:
        """Return the findings of the rules that see the whole model."""
        versions = self._model.document.versions
        last = versions.get(_BY_CODE) or versions.keep(_BY_CODE, {})
        found: Found = []
        for rule in rules:
            if rule.reads_twins and self.is_without_twins:
                before = last[rule.code].found if rule.code in last else ()
                found += (each for each in before if _islands([each]) <= self._islands)
            elif rule.check_document is not None:
                key = rule, self._key(rule.reads)
                findings = rule.check_document(self._model, self._context)
                known = self._known(last.get(rule.code), key, partial(self._of, rule, findings))
                last[rule.code] = known
                found += known.found
        return found

    def island_findings(self, rules: Iterable[Rule]) -> Found:
        """Return the findings of the rules that see one island at a time."""
        chosen = tuple(rule for rule in rules if rule.check_island is not None)

        def check(declared: Declarations) -> _Findings:
            for rule in chosen:
                if rule.check_island is not None:
                    yield from self._of(rule, rule.check_island(declared, self._context))

        keys = (chosen, self._context.targets), (chosen, self._context.key)
        return self._in_all_islands(
            _OF_ISLANDS,
            lambda part: keys[bool(part.parameters or part.constants)],
            lambda _, symbols: keys[any(symbols)],
            check,
        )

    def body_findings(self, rules: Iterable[Rule]) -> Found:
        """Return the findings of the rules that see one body and the joints on it."""
        chosen = tuple(rule for rule in rules if rule.check_body is not None)
        joints_on = self._model.tree.joints_on

        def check(declared: Declarations) -> _Findings:
            for body in declared.bodies():
                for rule in chosen:
                    if rule.check_body is not None:
                        found = rule.check_body(body, joints_on(body), self._context)
                        yield from self._of(rule, found)

        key = chosen, *self._key(Aspect.STRUCTURE | Aspect.PLACES)
        return self._in_all_islands(
            _OF_BODIES,
            lambda _: key,
            lambda declared, _: (key[:2], *map(joints_on, declared.bodies())),
            check,
        )

    def _in_all_islands(
        self,
        fact: Fact[_Known],
        key_of_part: Callable[[ModelPart], _Key],
        key_of_island: Callable[[Declarations, Symbols], _Key],
        check: Callable[[Declarations], _Findings],
    ) -> Found:
        """Return what is found in each island.

        Args:
            fact: What chunks and islands keep it as.
            key_of_part: What it depends on besides the islands of a chunk.
            key_of_island: What it depends on besides one island.
            check: Finds it in what an island declares.
        """
        found: Found = []
        for chunk, part in zip(self._model.document.chunks, self._model.parts, strict=True):

            def of_chunk(chunk: Chunk = chunk, part: ModelPart = part) -> _Findings:
                rows = zip(chunk.islands, part.declared, part.symbols, strict=True)
                for island, declared, symbols in rows:
                    key = key_of_island(declared, symbols)
                    known = self._known(island.facts.get(fact), key, partial(check, declared))
                    yield from island.facts.keep(fact, known).found

            known = self._known(chunk.facts.get(fact), key_of_part(part), of_chunk)
            found += chunk.facts.keep(fact, known).found
        return found

    def _known(
        self, known: _Known | None, key: _Key, find: Callable[[], Iterable[_RuleFinding]]
    ) -> _Known:
        """Return what is known, found again where it does not hold any more."""
        if known is not None and known.key == key and known.islands <= self._islands:
            return known
        self._checkpoint()
        n_faults = len(self.faults)
        found = list(find())
        return _Known(key if len(self.faults) == n_faults else (), found, _islands(found))

    def _key(self, reads: Aspect) -> _Key:
        known = self._keys.get(reads)
        if known is None:
            known = self._context.key, self._model.edition.facts(reads)
        return self._keys.setdefault(reads, known)

    def _of(self, rule: Rule, findings: Iterator[Finding]) -> Found:
        """Return all findings of a rule, those before a fault too."""
        found: Found = []
        try:
            for finding in findings:
                found.append((rule, finding))
        except Exception as error:
            self.faults.append(Fault(rule, error))
        return found


def _islands(found: Found) -> frozenset[Island]:
    """Return the islands to which findings point."""
    fixes = {id(fix): fix for _, f in found for fix in (f.fix, *f.choices) if fix is not None}
    places = [place for _, f in found for place in (f.at, *(related.at for related in f.related))]
    places += [change.at for fix in fixes.values() for change in fix.changes]
    return frozenset(place.island for place in places)
