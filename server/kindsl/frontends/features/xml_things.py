"""Links and joints of a robot in XML under a cursor, with their mechanics in the file's frames."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from math import degrees

from kindsl.frontends.features.wording import (
    KILOGRAMS,
    Hover,
    code,
    finding_line,
    inertia_lines,
    number,
    paragraph,
    pose_text,
    vector,
)
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.xml_bodies import XmlBody, XmlPart, xml_bodies
from kindsl.judgement.rules.xml_elements import LimitedJoint, joints_of
from kindsl.language.semantics.declarations import Joint, Link
from kindsl.language.semantics.lowering import declarations
from kindsl.language.syntax.tree import Node
from kindsl.language.text.phrases import listed
from kindsl.robots.interchange.xml_document import Connection, xml_of

_UNLIMITED = "without limits"


def thing_at(analysis: Analysis, offset: int) -> tuple[str, str]:
    """Return kind and name, as pictures have them, of what an offset is in; empty for nothing."""
    place = analysis.syntax.island_at(offset)
    declared = declarations(place.island)
    for joint in declared.joints:
        # In an MJCF it is within the body that it moves.
        if not declared.links or joint.start <= offset - place.start < joint.end:
            return "joint", str(joint.name)
    for link in declared.links:
        heads = {body.link for body in xml_bodies(analysis.model)}
        return "link" if link in heads else "frame", str(link.name)
    return "", ""


def xml_hover(analysis: Analysis, offset: int) -> Hover | None:
    """Return the hover of a link or joint whose first tag, or inertia, is at an offset."""
    place = analysis.syntax.island_at(offset)
    declared = declarations(place.island)
    things: list[tuple[Node, Callable[[], str]]]
    things = [(each.node, partial(_of_joint, analysis, each)) for each in declared.joints]
    for link in declared.links:
        nodes = [link.node, *([] if link.inertia is None else [link.inertia.node])]
        things += ((node, partial(_of_link, analysis, link)) for node in nodes)
    for node, text in things:
        tag = node.children[0]
        if place.start + tag.start <= offset <= place.start + tag.end:
            return Hover(place.start + tag.start, place.start + tag.end, text())
    return None


def _of_link(analysis: Analysis, link: Link) -> str:
    bodies = xml_bodies(analysis.model)
    own = ((index, part) for index, body in enumerate(bodies) for part in body.parts)
    found = next(((index, part) for index, part in own if part.link is link), None)
    title = f"**link `{link.name}`**"
    if found is None:
        return title
    index, part = found
    lines = [*_place_lines(bodies, index, part), *_mass_lines(bodies, index, part)]
    return paragraph(title, [*lines, *_finding_lines(analysis, link)])


def _place_lines(bodies: Sequence[XmlBody], index: int, part: XmlPart) -> Iterator[str]:
    body = bodies[index]
    carrier = body.carrier
    if part.link is not body.link:
        yield f"fixed to {code(str(body.link.name))}"
    elif carrier is not None:
        yield f"carried by joint {code(str(carrier.joint.name))}, parent {code(carrier.parent)}"
    others = [code(str(each.link.name)) for each in body.parts[1:] if each.link is not part.link]
    if part.link is body.link and others:
        yield f"fixed to it: {listed(others)}"
    below = [each for each in bodies if each.parent == index and each.carrier is not None]
    carried = [code(str(each.link.name)) for each in below]
    if carried:
        yield f"carries {listed(carried)}"


def _mass_lines(bodies: Sequence[XmlBody], index: int, part: XmlPart) -> Iterator[str]:
    if part.mass is not None:
        yield f"mass {number(part.mass.mass)} {KILOGRAMS}"
        yield from inertia_lines(part.mass)
    below = {index}
    for other, body in enumerate(bodies):
        if body.parent in below:
            below.add(other)
    weights = [bodies[each].mass for each in sorted(below)]
    whole = sum(mass.mass for mass in weights if mass is not None)
    yield f"{number(whole)} {KILOGRAMS} with all that is fixed to it and that it carries"


def _finding_lines(analysis: Analysis, link: Link) -> Iterator[str]:
    """Yield what the rules say of a link, the worst first; nothing of one that is all right."""
    start, end = analysis.resolver.span(link)
    severities = list(Severity)
    here = [finding for finding in analysis.findings if start <= finding.start <= end]
    for finding in sorted(here, key=lambda each: severities.index(each.severity)):
        yield finding_line(finding.severity, finding.message, finding.code)


def _of_joint(analysis: Analysis, joint: Joint) -> str:
    connections = xml_of(analysis.syntax).connections
    limited = next((e for e in joints_of(analysis.model) if e.name == joint.name), None)
    kind = limited.kind if limited is not None else ""
    lines = (_joint_lines(c, limited) for c in connections if c.joint is joint)
    return paragraph(f"**{kind} joint `{joint.name}`**", next(lines, ()))


def _joint_lines(connection: Connection, limited: LimitedJoint | None) -> Iterator[str]:
    is_length = connection.joint.kind == "prismatic"
    yield f"parent {code(connection.parent)}, child {code(connection.child)}"
    yield f"at zero: {pose_text(connection.parent_T_child.then(connection.child_T_joint))}"
    if connection.axis is not None:
        motion = "slides along" if is_length else "turns about"
        yield f"{motion} {vector(connection.axis)} of its frame"
    if limited is not None and limited.limit is not None:
        yield f"limits {_limits(limited)}"


def _limits(joint: LimitedJoint) -> str:
    if joint.lower is None or joint.upper is None:
        return _UNLIMITED
    ends = [degrees(x) if joint.unit == "rad" else x for x in (joint.lower, joint.upper)]
    return f"{' to '.join(map(number, ends))}{' m' if joint.unit == 'm' else '°'}"
