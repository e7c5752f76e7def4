"""Links and joints of a robot in XML under a cursor, with their mechanics in the file's frames."""

from collections.abc import Iterator, Sequence
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
from kindsl.language.semantics.declarations import Joint, Link
from kindsl.language.semantics.lowering import declarations
from kindsl.language.text.phrases import listed
from kindsl.robots.interchange.robot_island import RobotIsland
from kindsl.robots.interchange.xml_document import Connection, XmlDocument
from kindsl.robots.interchange.xml_reading import XmlElement

_UNLIMITED = "without limits"


def thing_at(analysis: Analysis, offset: int) -> tuple[str, str]:
    """Return kind and name, as pictures have them, of what an offset is in; empty for nothing."""
    declared = declarations(analysis.syntax.island_at(offset).island)
    for joint in declared.joints:
        return "joint", str(joint.name)
    for link in declared.links:
        heads = {body.link for body in xml_bodies(analysis.model)}
        return "link" if link in heads else "frame", str(link.name)
    return "", ""


def xml_hover(analysis: Analysis, offset: int) -> Hover | None:
    """Return the hover of a link or joint whose first tag, or inertia, is at an offset."""
    place = analysis.syntax.island_at(offset)
    declared = declarations(place.island)
    nodes = [joint.node for joint in declared.joints]
    for link in declared.links:
        nodes += [link.node, *([] if link.inertia is None else [link.inertia.node])]
    for node in nodes:
        tag = node.children[0]
        if place.start + tag.start <= offset <= place.start + tag.end:
            text = [_of_link(analysis, link) for link in declared.links]
            text += [_of_joint(analysis, joint) for joint in declared.joints]
            return Hover(place.start + tag.start, place.start + tag.end, text[0])
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
    document, island = analysis.syntax, joint.island
    connections = document.connections if isinstance(document, XmlDocument) else ()
    element = island.element if isinstance(island, RobotIsland) else None
    kind = (element.get("type") if element is not None else None) or ""
    lines = (_joint_lines(c, element) for c in connections if c.joint is joint)
    return paragraph(f"**{kind} joint `{joint.name}`**", next(lines, ()))


def _joint_lines(connection: Connection, element: XmlElement | None) -> Iterator[str]:
    is_length = connection.joint.kind == "prismatic"
    yield f"parent {code(connection.parent)}, child {code(connection.child)}"
    yield f"at zero: {pose_text(connection.parent_T_child.then(connection.child_T_joint))}"
    if connection.axis is not None:
        motion = "slides along" if is_length else "turns about"
        yield f"{motion} {vector(connection.axis)} of its frame"
    limit = element.find("limit") if element is not None else None
    if limit is not None:
        yield f"limits {_limits([limit.get(name) for name in ('lower', 'upper')], is_length)}"


def _limits(ends: Sequence[str | None], is_length: bool) -> str:
    try:
        numbers = [float(end) for end in ends if end is not None]
    except ValueError:
        return _UNLIMITED
    if len(numbers) != 2:
        return _UNLIMITED
    shown = numbers if is_length else [degrees(each) for each in numbers]
    return f"{' to '.join(map(number, shown))}{' m' if is_length else '°'}"
