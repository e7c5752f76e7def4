"""Places of the numbers of a limb, and their names."""

from typing import TYPE_CHECKING

from kindsl.judgement.diagnosis.judgements import TEN, keyword
from kindsl.language.semantics.declarations import Child, Joint, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import frame_of_com
from kindsl.language.semantics.places import Located, Place, has_problem_within
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.robots.limbs.weighing import Suspect

if TYPE_CHECKING:
    from kindsl.robots.interchange.robot_island import RobotIsland
    from kindsl.robots.interchange.xml_document import Connection

# Places in the inertia of a link, by which of its ten numbers they have.
PARTS = {"mass": slice(1), "com": slice(1, 4), "moments": slice(4, 10), "inertia": slice(10)}
OF_A_LINK = tuple(PARTS)
_WORDS = {"translation": "translation", "angles": "rotation", "com": "CoM"}


def phrase(place: Suspect) -> str:
    """Return the numbers at a place: `translation of 'RF_HFE'`, `CoM of 'RF_upperleg'`."""
    name = place.link if place.what in OF_A_LINK else place.joint
    return f"{_WORDS.get(place.what, place.what)} of '{name}'"


def place_at(model: Model, link: str, what: str) -> Suspect:
    """Return the same place of a peer."""
    joint = joint_of(model, link)
    return Suspect(link, str(joint.name) if joint is not None else "", what)


def joint_of(model: Model, link: str) -> Joint | None:
    """Return the joint that supports a link."""
    edge = model.tree.supporting_edge(model.body_named[link])
    connection = carrying(model, link) if edge is None else None
    return edge.joint if edge is not None else connection.joint if connection else None


def child_of(model: Model, link: str) -> Child | None:
    """Return the pair that attaches a link, None where a joint names both of its links."""
    edges = model.tree.above.get(model.body_named[link])
    return edges[0].child if edges else None


def carrying(model: Model, link: str) -> "Connection | None":
    """Return what connects a link to the one that carries it, where a joint names both."""
    if not model.document.is_xml:
        return None
    from kindsl.robots.interchange.xml_document import xml_of

    connections = xml_of(model.document).connections
    return next((each for each in connections if each.child == link), None)


def place_of_parent(model: Model, link: str) -> Located:
    """Return where it is written what carries a link."""
    connection = carrying(model, link)
    if connection is None:
        return child_of(model, link) or model.body_named[link].name
    return _island(connection).reference("parent")


def _island(connection: "Connection") -> "RobotIsland":
    from kindsl.robots.interchange.robot_island import RobotIsland

    island = connection.joint.island
    assert isinstance(island, RobotIsland)
    return island


def place_of_joint(model: Model, link: str) -> Located:
    """Return where it is written by which joint a link moves."""
    child, joint = child_of(model, link), joint_of(model, link)
    if child is not None:
        return child.joint
    return joint.name if joint is not None else model.body_named[link].name


def vector_at(model: Model, place: Suspect) -> Vector | None:
    """Return three numbers, None where others are meant."""
    body, joint = model.body_named[place.link], joint_of(model, place.link)
    if place.what == "com":
        frame = frame_of_com(body)
        if frame is not None:
            return frame.pose.translation
        return body.inertia.com if body.inertia is not None else None
    if joint is None or place.what not in ("translation", "angles"):
        return None
    return joint.pose.translation if place.what == "translation" else joint.pose.rotation


def numbers_at(model: Model, place: Suspect) -> tuple[Expression, ...]:
    """Return the numbers of a place; none where some are missing, or are those of another frame."""
    vector, body = vector_at(model, place), model.body_named[place.link]
    if place.what == "axis":
        connection = carrying(model, place.link)
        return tuple(_island(connection).axis()) if connection is not None else ()
    if place.what not in OF_A_LINK:
        return vector.components if vector is not None else ()
    inertia = body.inertia
    if inertia is None or inertia.mass is None:
        return ()
    if inertia.frame is not None and frame_of_com(body) is None:
        return ()
    com = vector_at(model, place._replace(what="com"))
    moments = (inertia.moments.get(name) for name in MOMENTS)
    three = com.components if com is not None else ()
    ten = (inertia.mass, *three, *(m for m in moments if m is not None))
    return ten[PARTS[place.what]] if len(ten) == len(TEN) else ()


def is_broken(model: Model, place: Suspect) -> bool:
    """Return whether something is not in the language among, or right beside, these numbers."""
    inertia = model.body_named[place.link].inertia
    whole = inertia if place.what in OF_A_LINK and place.what != "com" else vector_at(model, place)
    return whole is not None and has_problem_within(whole)


def located(model: Model, place: Suspect) -> Located:
    """Return where a finding is shown."""
    inertia, joint = model.body_named[place.link].inertia, joint_of(model, place.link)
    if place.what in OF_A_LINK and place.what != "com" and inertia is not None:
        return keyword(inertia)
    name = joint.name if joint is not None else model.body_named[place.link].name
    axis = numbers_at(model, place) if place.what == "axis" else ()
    if axis:
        return Place(axis[0].island, axis[0].start, axis[-1].end)
    return vector_at(model, place) or name
