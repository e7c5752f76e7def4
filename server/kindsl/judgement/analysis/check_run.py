"""Runs rules over a document; if one of them fails, the others still report."""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import NamedTuple, TypeAlias

from kindsl.judgement.rules.base import Finding, Rule
from kindsl.judgement.rules.context import Context
from kindsl.language.semantics.aspects import Aspect
from kindsl.language.semantics.declarations import Declarations
from kindsl.language.semantics.model import Model, ModelPart
from kindsl.language.semantics.parameters import Symbols
from kindsl.language.syntax.document import Chunk
from kindsl.language.syntax.tree import Island
from kindsl.language.text.facts import Fact
from kindsl.language.text.groups import grouped

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
    """

    key: _Key
    found: Found
    islands: frozenset[Island]


class Readers(NamedTuple):
    """Rules that read the same of a document."""

    reads: Aspect
    reads_twins: bool
    rules: tuple[Rule, ...]


_OF_ISLANDS = Fact[_Known]("findings of islands")
_OF_BODIES = Fact[_Known]("findings of bodies")
_OF_DOCUMENT = Fact[dict[tuple[Aspect, bool], _Known]]("findings of documents")


class RunningRules(NamedTuple):
    """The rules that run, by what they see."""

    of_islands: tuple[Rule, ...]
    of_bodies: tuple[Rule, ...]
    of_documents: tuple[Readers, ...]


def by_sight(rules: Iterable[Rule]) -> RunningRules:
    """Return rules by what they see."""
    chosen = tuple(rules)
    of_documents = (rule for rule in chosen if rule.check_document is not None)
    readers = grouped(((r.reads | Aspect.STRUCTURE, r.reads_twins), r) for r in of_documents)
    return RunningRules(
        tuple(rule for rule in chosen if rule.check_island is not None),
        tuple(rule for rule in chosen if rule.check_body is not None),
        tuple(Readers(*reads, tuple(who)) for reads, who in readers.items()),
    )


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
        is_without_twins: Whether no twin is read: their findings of the last version stay in
            islands that are here, too.
    """

    def __init__(
        self,
        checkpoint: Checkpoint,
        model: Model,
        context: Context,
        rules: RunningRules,
        *,
        is_without_twins: bool = False,
    ) -> None:
        self.faults: list[Fault] = []
        self.is_without_twins = is_without_twins
        self._checkpoint, self._model, self._context = checkpoint, model, context
        self._rules = rules
        self._islands = frozenset(model.islands)

    def findings(self) -> Found:
        """Return all that the rules find."""
        return self._document_findings() + self._body_findings() + self._island_findings()

    def _document_findings(self) -> Found:
        versions = self._model.document.versions
        last = versions.get(_OF_DOCUMENT) or versions.keep(_OF_DOCUMENT, {})
        found: Found = []
        for reads, reads_twins, rules in self._rules.of_documents:
            known = last.get((reads, reads_twins))
            if not (reads_twins and self.is_without_twins):
                key = rules, *self._key(reads)
                known = self._known(known, key, partial(self._of_readers, rules))
                last[reads, reads_twins] = known
                found += known.found
            elif known is not None:
                before = (each for each in known.found if each[0] in rules)
                found += (each for each in before if _islands([each]) <= self._islands)
        return found

    def _of_readers(self, rules: Iterable[Rule]) -> _Findings:
        for rule in rules:
            if rule.check_document is not None:
                self._checkpoint()
                yield from self._of(rule, rule.check_document(self._model, self._context))

    def _island_findings(self) -> Found:
        chosen = self._rules.of_islands

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

    def _body_findings(self) -> Found:
        chosen = self._rules.of_bodies
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
        """Return known findings, found again where they no longer hold."""
        if known is not None and known.key == key and known.islands <= self._islands:
            return known
        self._checkpoint()
        n_faults = len(self.faults)
        found = list(find())
        return _Known(key if len(self.faults) == n_faults else (), found, _islands(found))

    def _key(self, reads: Aspect) -> _Key:
        return self._context.key, self._model.edition.facts(reads)

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
    if not found:
        return frozenset()
    fixes = {id(fix): fix for _, f in found for fix in (f.fix, *f.choices) if fix is not None}
    places = [place for _, f in found for place in (f.at, *(related.at for related in f.related))]
    places += [change.at for fix in fixes.values() for change in fix.changes]
    return frozenset(place.island for place in places)
