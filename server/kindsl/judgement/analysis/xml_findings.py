"""Findings of an XML file that is judged where it stands."""

from collections.abc import Container, Iterable, Iterator, Sequence
from math import inf, log

from kindsl.judgement.analysis.settings import Settings, is_enabled
from kindsl.judgement.diagnosis.judgements import is_placeholder
from kindsl.judgement.rules.base import Finding, Related, Rule, Severity
from kindsl.judgement.rules.context import Context
from kindsl.judgement.rules.registry import OF_PARTS, rules_with
from kindsl.judgement.rules.xml_bodies import XmlBody, odd_links, xml_bodies
from kindsl.judgement.rules.xml_elements import A_FEW
from kindsl.judgement.rules.xml_fixes import fix_by_counterpart, xml_choices, xml_fix
from kindsl.judgement.rules.xml_reference import reference_findings
from kindsl.judgement.rules.xml_shapes import LIKELY, body_findings
from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import mass_distribution
from kindsl.language.semantics.places import Located
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.mechanics.rigid.body import eigensystem, second_moments_about_com
from kindsl.mechanics.rigid.matter import density_of
from kindsl.robots.interchange.robot_island import RobotIsland
from kindsl.robots.interchange.xml_document import xml_of

_MISSING, _PLACEHOLDER, _COPIED, _DENSITY = "KD304", "KD310", "KD315", "KD311"
# Of what twins convict, and of angles, 289 of 306 fixes are right, or one of two; in place 70 of 72
# (`benchmarks/planted_slips.py` on three sets of robots, `planted_urdfs.py` on one).
_SURE = frozenset(("KD208", "KD210", "KD501", "KD509", "KD510"))
_NO_MASS, _REFERENCE = "KD303", "KD306"
# What is told of parts that cannot be as they are.
_ODD = frozenset(("KD301", "KD302", "KD303", _DENSITY, "KD502"))
# Who has numbers in another unit differs from all twins, and of a pair the other one as well.
_UNITS, _SIDES, _OF_TWINS = ("KD501", "KD502"), "KD510", ("KD509", "KD510")
_TOLD_OF_PARTS = OF_PARTS | {_COPIED, "KD307"}
# A part of so small a share of its body's mass hardly matters to how the body moves.
_NEGLIGIBLE = 0.01
_WATER = 1000.0  # kg/m³


def xml_findings(
    document: SyntaxDocument,
    model: Model,
    context: Context,
    settings: Settings,
    found: Sequence[tuple[Rule, Finding]],
) -> Iterator[tuple[Rule, Finding]]:
    """Yield all findings of an XML file, those on parts that hardly weigh as hints.

    Fixes are those of causes alone, of which the probability is known.

    Args:
        document: The file.
        model: What it declares.
        context: What the rules see besides.
        settings: Which rules report.
        found: What the rules found that concern it.
    """
    xml, bodies = xml_of(document), xml_bodies(model)
    own = [(flaw.code, Finding(flaw.at, flaw.message)) for flaw in xml.flaws]
    own += ((_PLACEHOLDER, finding) for finding in _placeholders(model))
    of_bodies = list(body_findings(model, bodies, context))
    # A mass that its twins tell is told once.
    of_twins = {id(finding.at.island) for code, finding in of_bodies if code in _OF_TWINS}
    missing = () if xml.has_shapes else _missing(bodies, of_twins)
    own += ((_MISSING, finding) for finding in missing)
    own += ((_REFERENCE, finding) for finding in reference_findings(model, bodies))
    own += of_bodies
    rules = {rule.code: rule for rule in rules_with(frozenset(code for code, _ in own))}
    enabled = [(rules[code], each) for code, each in own if is_enabled(rules[code], settings)]
    light = _light_parts(bodies)
    at_rest = set() if xml.has_shapes else _parts_at_rest(bodies)
    # Where nothing moves but a base may float its density matters.
    has_joints = any(body.moves for body in bodies)
    massless = set() if xml.has_shapes else {id(b.link.island) for b in _massless(bodies)}
    copied = {id(finding.at.island) for rule, finding in found if rule.code == _COPIED}
    in_units = {id(f.at.island) for rule, f in (*enabled, *found) if rule.code in _UNITS}
    explained = {
        (id(at.island), code)
        for _, f in (*enabled, *found)
        for at in (f.at, *f.also)
        for code in f.explains
    }
    told = []
    for rule, finding in (*enabled, *found):
        island, is_of_part = id(finding.at.island), rule.code in _TOLD_OF_PARTS
        if (island, rule.code) in explained:
            continue
        if is_of_part and rule.code != _COPIED and island in copied:
            continue
        others = finding.related if rule.code == _SIDES else ()
        islands = {island, *(id(other.at.island) for other in others)}
        if rule.code in _OF_TWINS and not islands.isdisjoint(in_units):
            continue
        if rule.code == _NO_MASS and island in massless:
            continue
        # So a simulator is told that a root stands still.
        if rule.code == _NO_MASS and island in at_rest and finding.severity is Severity.WARNING:
            continue
        is_sure = bool(finding.probability) or rule.code in _SURE
        is_light = is_of_part and island in light
        is_light = is_light or (rule.code == _DENSITY and has_joints and island in at_rest)
        fixes = is_sure and not is_light
        is_likely = bool(finding.also) or (finding.probability or 1.0) >= LIKELY
        fix = xml_fix(finding.fix) if fixes and is_likely else None
        choices = xml_choices(finding.choices) if fixes else ()
        severity = Severity.HINT if is_light else finding.severity
        told.append((rule, finding._replace(fix=fix, choices=choices, severity=severity)))
    yield from _folded(_with_fixes(model, bodies, told))


def _with_fixes(
    model: Model, bodies: Sequence[XmlBody], told: Sequence[tuple[Rule, Finding]]
) -> list[tuple[Rule, Finding]]:
    """Return findings, with what a counterpart has where no likely cause is fixed."""
    fixed = {id(finding.at.island) for _, finding in told if finding.fix}
    odd, made = odd_links(model, bodies), []
    for rule, finding in told:
        island = finding.at.island
        links = [link for link in declarations(island).links if link in odd]
        is_open = rule.code in _ODD and finding.severity is not Severity.HINT
        if is_open and id(island) not in fixed and links:
            fix, peer = fix_by_counterpart(model, links[0], odd) or (None, None)
            fix = xml_fix(fix)
            if fix is not None and peer is not None and peer.inertia is not None:
                fixed.add(id(island))
                related = Related(peer.inertia, f"inertia of '{peer.name}'")
                finding = finding._replace(fix=fix, choices=(), related=(*finding.related, related))
        made.append((rule, finding))
    return made


def _folded(found: Sequence[tuple[Rule, Finding]]) -> Iterator[tuple[Rule, Finding]]:
    """Yield findings, more than a few densities of a file as one: that of the least plausible."""
    folds: dict[object, list[tuple[Rule, Finding]]] = {}
    for number, (rule, finding) in enumerate(found):
        # One beside a comment may be silenced by it.
        is_dense = rule.code == _DENSITY and "kindsl:" not in finding.at.island.text
        key = finding.severity if is_dense else number
        folds.setdefault(key, []).append((rule, finding))
    for fold in folds.values():
        if len(fold) <= A_FEW:
            yield from fold
            continue
        (rule, worst), *others = sorted(fold, key=lambda each: -_oddity(each[1]))
        related = (Related(finding.at, finding.message) for _, finding in others[:A_FEW])
        message = f"{worst.message}; {len(others)} more links have an implausible density"
        also = tuple(finding.at for _, finding in others)
        yield rule, worst._replace(message=message, related=tuple(related), also=also)


def _oddity(finding: Finding) -> float:
    """Return how far a density is from that of water, as a logarithm."""
    (link,) = declarations(finding.at.island).links
    mass = mass_distribution(link.inertia, {}) if link.inertia is not None else None
    if mass is None or mass.mass <= 0.0:
        return 0.0
    density = density_of(mass.mass, eigensystem(second_moments_about_com(mass)))
    return abs(log(density / _WATER)) if 0.0 < density < inf else inf


def _mass(link: Link) -> float:
    mass = link.inertia.mass if link.inertia is not None else None
    return max((mass.literal or 0.0) if mass is not None else 0.0, 0.0)


def _is_massless(link: Link) -> bool:
    """Return whether no mass or no moments are given: what is unreadable is reported itself."""
    mass = link.inertia.mass if link.inertia is not None else None
    is_empty = link.inertia is None or not link.inertia.moments
    return is_empty or (mass is not None and mass.literal == 0.0)


def _light_parts(bodies: Iterable[XmlBody]) -> set[int]:
    """Return the islands of parts whose mass is next to nothing beside that of their body."""
    light = set()
    for body in bodies:
        least = _NEGLIGIBLE * sum(_mass(part.link) for part in body.parts)
        light |= {id(part.link.island) for part in body.parts if _mass(part.link) < least}
    return light


def _parts_at_rest(bodies: Sequence[XmlBody]) -> set[int]:
    """Return the islands of what no joint moves: mostly a base, of which the file does not say
    whether it floats.
    """
    return {id(part.link.island) for b in bodies if not b.moves for part in b.parts}


def _placeholders(model: Model) -> Iterator[Finding]:
    """Yield one finding for all inertias of a file whose mass and moments are 1."""
    units = []
    for link in model.links:
        body = mass_distribution(link.inertia, {}) if link.inertia is not None else None
        if body is not None and is_placeholder(body):
            units.append(link)
    if units:
        at = units[0].inertia or units[0].name
        verb = "are placeholders" if units[1:] else "is a placeholder"
        what = f"inertia{'s' if units[1:] else ''} of '{units[0].name}'{_more(units)} {verb}: "
        yield _of_all(units, at, f"{what}mass and moments are 1")


def _missing(bodies: Sequence[XmlBody], told_of: Container[int]) -> Iterator[Finding]:
    """Yield one finding for all bodies of a file that move and have no mass or no moments.

    Links between the axes of one joint are a hint. A robot in which no body has either is for
    planning: of 17 such published files nobody would change one.
    """
    without, n_moving = _massless(bodies), sum(body.moves for body in bodies)
    has_none = len(without) == n_moving
    between = [b for b in without if _is_between_axes(b)] if not has_none else []
    others = [b for b in without if b not in between and id(b.link.island) not in told_of]
    of_others = Severity.INFORMATION if has_none else None
    for group, severity in ((others, of_others), (between, Severity.HINT)):
        links = [body.link for body in group]
        if links:
            verb, it = ("have", "them") if links[1:] else ("has", "it")
            what = f"link '{links[0].name}'{_more(links)} {verb} no inertia, and a joint moves {it}"
            yield _of_all(links, links[0].name, what)._replace(severity=severity)


def _massless(bodies: Iterable[XmlBody]) -> list[XmlBody]:
    """Return the bodies that move and have no mass or no moments."""
    return [b for b in bodies if b.moves and all(_is_massless(part.link) for part in b.parts)]


def _is_between_axes(body: XmlBody) -> bool:
    """Return whether a body carries a single other one, at its own origin, and has no shape."""
    islands = [part.link.island for part in body.parts]
    elements = (island.element for island in islands if isinstance(island, RobotIsland))
    is_shape = any(e is not None and e.find("visual") is not None for e in elements)
    return len(body.ends) == 1 and not any(body.ends[0]) and not is_shape


def _more(links: list[Link]) -> str:
    number = len(links) - 1
    return f" and {number} more" if number else ""


def _of_all(links: list[Link], at: Located, message: str) -> Finding:
    others = links[1 : A_FEW + 1]
    return Finding(at, message, tuple(Related(link.name, f"link '{link.name}'") for link in others))
