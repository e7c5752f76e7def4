"""The bodies of a robot in XML: links that are fixed together, and the joint that moves them."""

from collections.abc import Iterator, Sequence
from math import hypot
from typing import NamedTuple

from kindsl.judgement.diagnosis.body_verdicts import DOUBTFUL_LENGTH, GREATEST_LENGTH, is_as_large
from kindsl.judgement.diagnosis.judgements import IMPOSSIBLE, Verdict, judgements
from kindsl.language.semantics.declarations import Joint, Link, Vector
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import frame_of_com, pose_of_com
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.text.facts import kept
from kindsl.mechanics.rigid.body import MassDistribution, lumped, seen_from
from kindsl.mechanics.rigid.pose import IDENTITY, ORIGIN, RigidPose, Vector3, rotation_from_z
from kindsl.robots.interchange.xml_document import Connection, xml_of
from kindsl.robots.mechanism.link_inertia import link_inertia

_WITHIN = 1e-9


class XmlPart(NamedTuple):
    """A link as a part of a body.

    Attributes:
        pose: Its frame in the body's.
        mass: In its own frame, None where it has none that is known.
    """

    link: Link
    pose: RigidPose
    mass: MassDistribution | None


class XmlBody(NamedTuple):
    """Links that are fixed together; the body's frame is that of the joint that carries it.

    Attributes:
        parts: The links, the one that a joint moves first.
        moves: Whether a joint carries it.
        carrier: The joint that does, where it connects two links of the file.
        parent: The index of the body that carries it, less than its own; None without one.
        placement: The joint's frame in the parent's.
        ends: The origins of the joints by which it carries others.
        mass: The mass distribution of all parts, None where nothing is known of any.
    """

    parts: tuple[XmlPart, ...]
    moves: bool
    carrier: Connection | None
    parent: int | None
    placement: RigidPose
    ends: tuple[Vector3, ...]
    mass: MassDistribution | None

    @property
    def link(self) -> Link:
        """The first link, which names it."""
        return self.parts[0].link

    @property
    def joint(self) -> Joint | None:
        """The joint that carries it."""
        return self.carrier.joint if self.carrier is not None else None

    @property
    def heaviest(self) -> XmlPart:
        """The part with the greatest share of its mass: to blame for all together."""
        return max(self.parts, key=lambda part: part.mass.mass if part.mass is not None else 0.0)

    @property
    def axis_pose(self) -> RigidPose:
        """The frame whose z is the joint's axis, in the body's."""
        axis = self.carrier.axis if self.carrier is not None else None
        return IDENTITY if axis is None else RigidPose(rotation_from_z(axis), ORIGIN)

    def with_axis(self, axis: Vector3) -> "XmlBody":
        """Return the body with another axis of its joint, if it has one."""
        if self.carrier is None or self.carrier.axis is None:
            return self
        return self._replace(carrier=self.carrier._replace(axis=axis))


@kept
def xml_bodies(model: Model) -> list[XmlBody]:
    """Return the bodies of a robot in XML, parents first.

    What loops or hangs on no link of the file is there as well, and begins a tree of its own.
    """
    return _BodyWalk(model).bodies()


def odd_links(model: Model, bodies: Sequence[XmlBody]) -> set[Link]:
    """Return the parts whose inertia is impossible, of no material, or far: more is not said.

    So are those whose mass is negative.
    """
    odd = {*IMPOSSIBLE, Verdict.IMPLAUSIBLE}
    found = (j for island in model.islands for j in judgements(declarations(island), {}))
    negative = (p.link for b in bodies for p in b.parts if p.mass is not None and p.mass.mass < 0.0)
    far = (link for link, _ in far_coms(bodies))
    return {*(j.link for j in found if j.verdict in odd), *far, *negative}


def far_coms(bodies: Sequence[XmlBody]) -> Iterator[tuple[Link, Vector]]:
    """Yield the CoMs that lie farther from their links than all joints together reach.

    Of 3,199 published parts none lies farther than nine tenths of that; a robot whose only joint
    is next to its base has longer links, of which none is as long as `DOUBTFUL_LENGTH`.
    """
    reach = reach_of(bodies)
    for part in (part for body in bodies for part in body.parts if reach > 0.0):
        frame, pose = frame_of_com(part.link), pose_of_com(part.link, {})
        if frame is None or pose is None or frame.pose.translation is None:
            continue
        if hypot(*pose.translation) > max(reach, DOUBTFUL_LENGTH):
            yield part.link, frame.pose.translation


def reach_of(bodies: Sequence[XmlBody]) -> float:
    """Return how far all joints together reach; those too far away reach no farther than any."""
    reaches: list[float] = []
    for body in bodies:
        above = 0.0 if body.parent is None else reaches[body.parent]
        reached = above + hypot(*body.placement.translation)
        reaches.append(GREATEST_LENGTH if far_joint(body, bodies) else reached)
    return max(reaches, default=0.0)


def far_joint(body: XmlBody, bodies: Sequence[XmlBody]) -> Vector | None:
    """Return where a joint is that no robot has so far from the body that carries it, or None."""
    carrier, distance = body.carrier, hypot(*body.placement.translation)
    # What is written in another frame may be far in that alone.
    is_near = carrier is None or (not carrier.is_told and distance <= GREATEST_LENGTH)
    if carrier is None or is_near or body.parent is None:
        return None
    translation, parent = carrier.joint.pose.translation, bodies[body.parent].mass
    if translation is None:
        return None
    far = max(abs(component.literal or 0.0) for component in translation.components)
    # What stands in a world may stand anywhere.
    is_odd = far > GREATEST_LENGTH and parent is not None and not is_as_large(parent, far)
    return translation if is_odd else None


class _BodyWalk:
    """A walk from the roots down."""

    def __init__(self, model: Model) -> None:
        document = xml_of(model.document)
        self._links: dict[str, Link] = {}
        for link in model.links:
            self._links.setdefault(str(link.name), link)
        self._below: dict[str, list[Connection]] = {}
        self._carried: dict[str, Connection] = {}
        for connection in document.connections:
            if self._carried.setdefault(connection.child, connection) is connection:
                self._below.setdefault(connection.parent, []).append(connection)
        self._has_shapes = document.has_shapes
        self._seen: set[str] = set()
        self._bodies: list[XmlBody] = []

    def bodies(self) -> list[XmlBody]:
        roots = (name for name in self._links if name not in self._carried)
        hanging = (n for n, c in self._carried.items() if c.parent not in self._links)
        for name in (*roots, *hanging, *self._links):
            self._from(name)
        return self._bodies

    def _from(self, root: str) -> None:
        pending: list[tuple[str, int | None, Connection | None, RigidPose]]
        pending = [(root, None, None, IDENTITY)]
        while pending:
            name, parent, carrier, placement = pending.pop()
            if name not in self._links or name in self._seen:
                continue
            parts, moving = self._parts(name, carrier)
            above, ends = self._carried.get(name), tuple(pose.translation for _, pose in moving)
            moves = above is not None and not above.is_fixed
            index = len(self._bodies)
            self._bodies.append(
                XmlBody(parts, moves, carrier, parent, placement, ends, self._mass(parts))
            )
            pending += [(each.child, index, each, pose) for each, pose in reversed(moving)]

    def _parts(
        self, name: str, carrier: Connection | None
    ) -> tuple[tuple[XmlPart, ...], list[tuple[Connection, RigidPose]]]:
        """Return a link with all that is fixed to it, and what these carry otherwise."""
        self._seen.add(name)
        joint_T_link = IDENTITY if carrier is None else carrier.child_T_joint.inverse()
        parts = [_part(self._links[name], joint_T_link)]
        moving = []
        for part in parts:
            for each in self._below.get(str(part.link.name), ()):
                pose = part.pose.then(each.parent_T_child)
                if each.is_fixed and each.child in self._links and each.child not in self._seen:
                    self._seen.add(each.child)
                    parts.append(_part(self._links[each.child], pose))
                elif not each.is_fixed:
                    moving.append((each, pose.then(each.child_T_joint)))
        return tuple(parts), moving

    def _mass(self, parts: Sequence[XmlPart]) -> MassDistribution | None:
        known = [seen_from(part.mass, part.pose) for part in parts if part.mass is not None]
        is_whole = len(known) == len(parts) or not self._has_shapes
        return lumped(known) if known and is_whole else None


def _part(link: Link, pose: RigidPose) -> XmlPart:
    mass = link_inertia(link, {})
    return XmlPart(link, pose, None if isinstance(mass, Unknown) else mass)
