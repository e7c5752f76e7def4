"""A document with its analysis: syntax, model, findings."""

# Signatures in `help` are as short as they are written here.
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property, lru_cache, partial
from typing import TYPE_CHECKING

from kindsl.judgement.analysis.check_run import (
    Checkpoint,
    CheckRun,
    Fault,
    RunningRules,
    by_sight,
    go_on,
)
from kindsl.judgement.analysis.diagnostics import Diagnostic, Findings, Resolver
from kindsl.judgement.analysis.known_findings import Apart, blocks_of, set_apart
from kindsl.judgement.analysis.settings import Settings, is_enabled, severity_of
from kindsl.judgement.analysis.syntax_findings import is_explained, syntax_findings
from kindsl.judgement.rules.base import Finding, Rule
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.registry import CONCERN_XML, all_rules, checking_rules, rules_with
from kindsl.judgement.rules.subject import Subject
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Located
from kindsl.language.syntax.document import SyntaxDocument, paused_collector
from kindsl.language.syntax.readings import as_read_for
from kindsl.language.text.display import html_of
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.facts import Facts
from kindsl.language.text.phrases import counted
from kindsl.robots.interchange.syntaxes import syntax_of

if TYPE_CHECKING:
    from kindsl.judgement.rules.suppression import Suppression
    from kindsl.robots.mechanism.build import Mechanism
    from kindsl.robots.mechanism.linkage import Linkage

_NO_SETTINGS = Settings()


class Analysis:
    """An immutable document; everything else about it is computed when asked for, once.

    Attributes:
        facts: What others derive from it.
    """

    def __init__(self, syntax: SyntaxDocument, settings: Settings = _NO_SETTINGS) -> None:
        self._written = syntax
        self.settings = settings
        self.facts = Facts()
        self._apart: Apart = Apart()
        self._findings: Findings | None = None
        self._faults: tuple[Fault, ...] = ()

    @cached_property
    def syntax(self) -> SyntaxDocument:
        """Its text and syntax, as its targets read it."""
        if self._written.is_xml:
            return self._written
        return as_read_for(self._written, self.settings.targets)

    @property
    def text(self) -> str:
        """The source."""
        return self.syntax.text

    @cached_property
    def model(self) -> Model:
        """The robot, as far as the text describes one."""
        with paused_collector():
            return Model(self.syntax)

    @cached_property
    def context(self) -> Context:
        """Targets and values that the rules see."""
        settings = self.settings
        if not settings.twins:
            return Context(settings.targets, settings.bindings, self.model)
        from kindsl.judgement.analysis.twins import compared_twins

        compare = partial(compared_twins, settings.twins, self.model)
        twins = settings.twins
        return Context(settings.targets, settings.bindings, self.model, compare, twins)

    @cached_property
    def resolver(self) -> Resolver:
        """The way from places in islands to absolute offsets."""
        return Resolver(self.syntax)

    @property
    def findings(self) -> Findings:
        """The findings in the order of the text, without suppressed and known ones."""
        return self.check()

    @property
    def apart(self) -> Apart:
        """The findings, those that the baseline knows, and what it knows in vain."""
        self.check()
        return self._apart

    @property
    def faults(self) -> tuple[Fault, ...]:
        """Rules that failed by an internal error: their findings are missing."""
        self.check()
        return self._faults

    def check(self, checkpoint: Checkpoint = go_on) -> Findings:
        """Return the findings; only the first call that ends computes them.

        Args:
            checkpoint: Called again and again while rules run; what it raises stops them.
        """
        if self._findings is None:
            run = self._run(checkpoint)
            self._apart = self._set_apart(run)
            self._findings, self._faults = (
                Findings(self._apart.reported, self.text),
                tuple(run.faults),
            )
        return self._findings

    def check_without_twins(self, checkpoint: Checkpoint = go_on) -> Findings:
        """Return all findings if they are known or there are no twins, else those of the text.

        Findings about twins stay as they were in the last version, in blocks that are the same.
        """
        if self._findings is not None or not self.settings.twins:
            return self.check(checkpoint)
        run = self._run(checkpoint, is_without_twins=True)
        return Findings(self._set_apart(run).reported, self.text)

    def unsilenced(self) -> list[Diagnostic]:
        """Return all findings, including those that comments or a baseline suppress."""
        return self._found(self._run(go_on))

    def is_silenced(self, code: str, at: Located) -> bool:
        """Return whether a setting or a comment keeps a rule from reporting at a place."""
        start, _ = self.resolver.span(at)
        is_off = not any(is_enabled(rule, self.settings) for rule in rules_with(frozenset((code,))))
        return is_off or any(each.covers(code, start) for each in self._suppressions)

    @cached_property
    def _suppressions(self) -> Sequence[Suppression]:
        if not self._has_comments_for_us:
            return ()
        # Imported for such comments only, since it delays the linter's start.
        from kindsl.judgement.rules.suppression import suppressions

        return suppressions(self.syntax.islands, self.syntax.starts, len(self.text))

    @property
    def _has_comments_for_us(self) -> bool:
        return any("kindsl:" in island.text for island in self.syntax.islands)

    def edited(self, edits: Sequence[TextEdit]) -> Analysis:
        """Return the analysis of the edited text; only edited parts are computed again."""
        return Analysis(self._written.edited(edits), self.settings)

    def changed(self, edits: Sequence[TextEdit], values: Mapping[str, float]) -> Analysis:
        """Return the analysis of the edited text with parameters bound to these values."""
        document = self.edited(edits) if edits else self
        if not values:
            return document
        return document.with_settings(self.settings.rebound(values))

    def with_settings(self, settings: Settings) -> Analysis:
        """Return the analysis of the same text under other decisions."""
        return Analysis(self._written, settings)

    def body_with(self, link: str) -> str:
        """Return the name in the model of what holds a link of a finding; empty if nothing does."""
        return link

    def mechanism(self, parameters: Mapping[str, float] | None = None) -> Mechanism:
        """Return the numbered bodies for mechanics, with rotors and friction of their joints.

        Needs NumPy.

        Args:
            parameters: Values by name, numbers, that win over all other bindings.

        Raises:
            UnboundParameterError: A parameter has no value.
            ParameterValueError: A name is unknown, or a value is no number or out of its range.
            ModelError: The document does not describe a kinematic tree.
            ModuleNotFoundError: NumPy is not installed.
        """
        from kindsl.robots.mechanism.given_values import checked_values

        known = [str(parameter.name) for parameter in self.model.parameters]
        given = checked_values(parameters or {}, known, self.settings.bindings)
        try:
            from kindsl.robots.mechanism.build import mechanism_of
        except ModuleNotFoundError as error:
            message = f"{error.name} is not installed: pip install 'kindsl[numpy]'"
            raise ModuleNotFoundError(message, name=error.name) from None
        values = {**self.context.values, **given}
        return mechanism_of(self.model, values, self.settings.joints)

    def skeleton(self) -> Linkage:
        """Return the numbered bodies in plain floats, to be written in other formats.

        Raises:
            UnboundParameterError: A parameter has no value.
            ModelError: The document does not describe a kinematic tree.
        """
        from kindsl.robots.mechanism.reading import whole_linkage

        return whole_linkage(self.model, self.context.values)

    def __repr__(self) -> str:
        n_errors = sum(finding.severity == "error" for finding in self.findings)
        links = counted(len(self.model.links), "link")
        name = self.model.name or "unnamed"
        return f"<kindsl.Document '{name}': {links}, {counted(n_errors, 'error')}>"

    def _repr_html_(self) -> str | None:
        """Return the HTML for a notebook."""
        return html_of(self)

    def _resolve(self, rule: Rule, finding: Finding) -> Diagnostic:
        severity = severity_of(rule, finding.severity, self.settings)
        return self.resolver.diagnostic(rule, finding, severity)

    def _set_apart(self, run: CheckRun) -> Apart:
        """Return the findings of a run without suppressed ones, apart from known ones."""
        with paused_collector():
            found = self._found(run)
        unsilenced = self._without_silenced(found, run)
        if not self.settings.known:
            return Apart(unsilenced)
        return set_apart(unsilenced, blocks_of(self.syntax), self.settings)

    def _found(self, run: CheckRun) -> list[Diagnostic]:
        if self.syntax.is_xml:
            from kindsl.judgement.analysis.xml_findings import xml_findings

            of_rules = run.findings()
            where = self.syntax, self.model, self.context, self.settings
            found = [*xml_findings(*where, of_rules)]
        else:
            found = [*syntax_findings(self.model, self.settings.targets)]
            found += (entry for entry in run.findings() if not is_explained(entry[1]))
        return [self._resolve(rule, finding) for rule, finding in found]

    def _run(self, checkpoint: Checkpoint, *, is_without_twins: bool = False) -> CheckRun:
        settings = self.settings
        choice = settings.targets, settings.select, settings.ignore
        rules = running_rules(*choice, is_xml=self.syntax.is_xml)
        return CheckRun(
            checkpoint, self.model, self.context, rules, is_without_twins=is_without_twins
        )

    def _without_silenced(self, found: list[Diagnostic], run: CheckRun) -> list[Diagnostic]:
        """Return the findings that neither comments suppress nor others explain, in order."""
        if self._has_comments_for_us:
            from kindsl.judgement.analysis.silencing import without_silenced

            codes, silenced = self._codes(run), self._suppressions
            found = without_silenced(found, self.syntax, silenced, codes, self._resolve)
        explained = _explained(found)
        if explained:
            mended = _explained(d for d in found if d.fix or d.choices)
            found = [
                d
                for d in found
                if (d.subject, d.code) not in (explained if not (d.fix or d.choices) else mended)
            ]
        return sorted(found, key=lambda d: (d.start, d.end, d.code, d.message))

    def _codes(self, run: CheckRun) -> list[str]:
        rules = [rule for rule in all_rules() if is_enabled(rule, self.settings)]
        return [r.code for r in rules if not (run.is_without_twins and r.reads_twins)]


def _explained(found: Iterable[Diagnostic]) -> set[tuple[Subject, str]]:
    """Return the codes of findings that others make needless, with what these are about."""
    return {(of, code) for d in found for of in (d.subject, *d.also) for code in d.explains}


@lru_cache(maxsize=64)
def running_rules(
    targets: frozenset[str], select: tuple[str, ...], ignore: tuple[str, ...], *, is_xml: bool
) -> RunningRules:
    """Return the rules that run under some settings, on XML those that concern it."""
    settings = Settings(targets=targets, select=select, ignore=ignore)
    concerned = rules_with(CONCERN_XML) if is_xml else checking_rules()
    return by_sight(rule for rule in concerned if is_enabled(rule, settings))


# Its name in public is `kindsl.Document`.
Analysis.__name__ = Analysis.__qualname__ = "Document"
Analysis.__module__ = "kindsl"


def analyse(text: str, settings: Settings = _NO_SETTINGS) -> Analysis:
    """Return the analysis of a text; never raises, whatever the text."""
    return Analysis(syntax_of("", text), settings)
