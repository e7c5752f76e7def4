"""Findings of an XML file that is judged where it stands."""

from collections.abc import Iterable, Iterator

from kindsl.judgement.analysis.settings import Settings, is_enabled
from kindsl.judgement.diagnosis.judgements import is_placeholder
from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.registry import rules_with
from kindsl.judgement.rules.xml_elements import OF_PARTS
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.semantics.places import Located
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.robots.interchange.xml_document import XmlDocument, XmlIsland

_MISSING, _PLACEHOLDER, _COPIED = "KD304", "KD310", "KD315"
# A part of so small a share of its body's mass hardly matters to how the body moves.
_NEGLIGIBLE = 0.01
_MOST_RELATED = 20


def xml_findings(
    document: SyntaxDocument,
    model: Model,
    settings: Settings,
    found: Iterable[tuple[Rule, Finding]],
) -> Iterator[tuple[Rule, Finding]]:
    """Yield all findings of an XML file: without fixes, and on parts that hardly weigh as hints.

    Args:
        document: The file.
        model: What it declares.
        settings: Which rules report.
        found: What the rules found that concern it.
    """
    flaws = document.flaws if isinstance(document, XmlDocument) else ()
    codes = frozenset((_MISSING, _PLACEHOLDER, *(flaw.code for flaw in flaws)))
    rules = {rule.code: rule for rule in rules_with(codes) if is_enabled(rule, settings)}
    for flaw in flaws:
        if flaw.code in rules:
            yield rules[flaw.code], Finding(flaw.at, flaw.message)
    bodies = _bodies(model)
    for code, findings in ((_PLACEHOLDER, _placeholders(model)), (_MISSING, _missing(bodies))):
        if code in rules:
            yield from ((rules[code], finding) for finding in findings)
    light = _light_parts(bodies)
    for rule, finding in found:
        plain = finding._replace(fix=None, choices=())
        if rule.code in (*OF_PARTS, _COPIED) and id(finding.at.island) in light:
            plain = plain._replace(severity=Severity.HINT)
        yield rule, plain


def _bodies(model: Model) -> list[tuple[Link, list[Link], bool]]:
    """Return each body's first link, all its links, and whether a joint moves it."""
    links: dict[str, Link] = {}
    for link in model.links:
        links.setdefault(str(link.name), link)
    carrier: dict[str, tuple[str, bool]] = {}
    for island in model.islands:
        joint = island.element if isinstance(island, XmlIsland) else None
        if joint is not None and joint.tag == "joint":
            parent, child = joint.find("parent"), joint.find("child")
            if parent is not None and child is not None:
                is_fixed = joint.get("type") == "fixed"
                carrier[child.get("link") or ""] = parent.get("link") or "", is_fixed
    groups: dict[str, list[Link]] = {}
    for name, link in links.items():
        first, seen = name, {name}
        while first in carrier and carrier[first][1] and carrier[first][0] in links:
            first = carrier[first][0]
            if first in seen:
                break
            seen.add(first)
        groups.setdefault(first, []).append(link)
    return [(links[name], group, name in carrier) for name, group in groups.items()]


def _mass(link: Link) -> float:
    mass = link.inertia.mass if link.inertia is not None else None
    return max((mass.literal or 0.0) if mass is not None else 0.0, 0.0)


def _is_massless(link: Link) -> bool:
    """Return whether no mass is given: one that is negative or unreadable is reported itself."""
    mass = link.inertia.mass if link.inertia is not None else None
    return link.inertia is None or (mass is not None and mass.literal == 0.0)


def _light_parts(bodies: Iterable[tuple[Link, list[Link], bool]]) -> set[int]:
    """Return the islands of parts whose mass is next to nothing beside that of their body."""
    light = set()
    for _, parts, _ in bodies:
        least = _NEGLIGIBLE * sum(map(_mass, parts))
        light |= {id(part.island) for part in parts if _mass(part) < least}
    return light


def _placeholders(model: Model) -> Iterator[Finding]:
    """Yield one finding for all inertias of a file whose mass and moments are 1."""
    units = []
    for link in model.links:
        body = mass_distribution(link.inertia, {}) if link.inertia is not None else None
        if body is not None and is_placeholder(body):
            units.append(link)
    if units:
        at = units[0].inertia or units[0].name
        what = f"inertia of '{units[0].name}'{_more(units)} is a placeholder: "
        yield _of_all(units, at, f"{what}mass and moments are 1")


def _missing(bodies: Iterable[tuple[Link, list[Link], bool]]) -> Iterator[Finding]:
    """Yield one finding for all bodies of a file that move and have no mass."""
    without = [first for first, parts, moves in bodies if moves and all(map(_is_massless, parts))]
    if without:
        verb = "have" if without[1:] else "has"
        what = f"link '{without[0].name}'{_more(without)} {verb} no inertia, and a joint moves "
        yield _of_all(without, without[0].name, what + ("them" if without[1:] else "it"))


def _more(links: list[Link]) -> str:
    number = len(links) - 1
    return f" and {number} more" if number else ""


def _of_all(links: list[Link], at: Located, message: str) -> Finding:
    others = links[1 : _MOST_RELATED + 1]
    return Finding(at, message, tuple(Related(link.name, f"link '{link.name}'") for link in others))
