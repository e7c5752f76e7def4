"""One robot written otherwise: link frames, names, order, signs, fixed links."""

import random
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from xml.etree.ElementTree import Element, SubElement, tostring

from kindsl.mechanics.rigid.body import MassDistribution, seen_from, shifted
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose, Vector3, fixed_axis_angles, pose_from
from kindsl.robots.interchange.rigid_links import RigidLink
from kindsl.robots.mechanism.linkage import Linkage

Variant = list[RigidLink]
_ORIGIN = (0.0, 0.0, 0.0)


def links_of(skeleton: Linkage) -> Variant:
    """Return the links of a robot; each joint has the axis z."""
    links = [RigidLink(skeleton.base_name, body=skeleton.masses[0])]
    for i, parent in skeleton.links():
        links.append(
            RigidLink(
                skeleton.link_names[i - 1],
                parent,
                skeleton.joint_names[i - 1],
                skeleton.joint_kinds[i - 1],
                (0.0, 0.0, 1.0),
                skeleton.placements[i - 1],
                body=skeleton.masses[i],
            )
        )
    return links


def reframed(links: Variant, chance: random.Random, is_floating: bool) -> Variant:
    """Return the links with their frames elsewhere in them, origins still on the joints' axes."""
    moves = [_move(link, chance) for link in links]
    if not is_floating:
        # A fixed base may be turned about gravity and put anywhere, no more.
        turn = (0.0, 0.0, chance.uniform(-3.0, 3.0))
        moves[0] = pose_from(_vector(chance, 0.4), turn)
    found = []
    for link, move in zip(links, moves, strict=True):
        parent = IDENTITY if link.parent is None else moves[link.parent].inverse()
        back = move.inverse()
        found.append(
            replace(
                link,
                parent_T_joint=parent.then(link.parent_T_joint).then(move)
                if link.joint
                else IDENTITY,
                axis=back.turn(link.axis),
                body=None if link.body is None else seen_from(link.body, back),
            )
        )
    return found


def _move(link: RigidLink, chance: random.Random) -> RigidPose:
    turn = _vector(chance, 3.0)
    if link.joint_kind == "revolute":
        way = chance.uniform(-0.3, 0.3)
        return pose_from(tuple(way * each for each in link.axis), turn)  # type: ignore[arg-type]
    return pose_from(_vector(chance, 0.3), turn)


def flipped(links: Variant, chance: random.Random) -> Variant:
    """Return the links with some joints the other way round."""
    return [_flipped(link) if chance.random() < 0.5 else link for link in links]


def _flipped(link: RigidLink) -> RigidLink:
    x, y, z = link.axis
    return replace(link, axis=(-x, -y, -z))


def renamed(links: Variant, chance: random.Random) -> Variant:
    """Return the links with other names for all links and joints."""
    numbers = chance.sample(range(100, 1000), len(links))
    return [
        replace(link, name=f"body{k}", joint=f"axis{k}" if link.joint else "")
        for k, link in zip(numbers, links, strict=True)
    ]


def reordered(links: Variant, chance: random.Random) -> Variant:
    """Return the links in another order, parents first."""
    order, rest = [0], list(range(1, len(links)))
    while rest:
        ready = [i for i in rest if links[i].parent in order]
        order.append(chance.choice(ready))
        rest.remove(order[-1])
    place = {old: new for new, old in enumerate(order)}
    return [
        replace(links[i], parent=None if links[i].parent is None else place[links[i].parent or 0])
        for i in order
    ]


def split(links: Variant, chance: random.Random) -> Variant:
    """Return the links with some of them in two, a fixed joint between."""
    found = list(links)
    for index, link in enumerate(links):
        if link.body is not None and link.body.mass and chance.random() < 0.4:
            share = chance.uniform(0.2, 0.8)
            pose = pose_from(_vector(chance, 0.3), _vector(chance, 3.0))
            rest = _scaled(link.body, 1.0 - share)
            part = seen_from(_scaled(link.body, share), pose.inverse())
            found[index] = replace(link, body=rest)
            name = f"{link.name}_part"
            found.append(
                RigidLink(name, index, f"{name}_joint", "fixed", parent_T_joint=pose, body=part)
            )
    return found


def _scaled(body: MassDistribution, factor: float) -> MassDistribution:
    xx, yy, zz, xy, xz, yz = (factor * each for each in body.moments)
    return MassDistribution(factor * body.mass, body.com, (xx, yy, zz, xy, xz, yz))


def _vector(chance: random.Random, size: float) -> Vector3:
    return chance.uniform(-size, size), chance.uniform(-size, size), chance.uniform(-size, size)


def variant(skeleton: Linkage, seed: int) -> Variant:
    """Return a robot with a random choice of all that does not matter."""
    chance = random.Random(seed)
    links = links_of(skeleton)
    if not skeleton.is_floating:
        links[0] = replace(links[0], body=None)
    changes: list[Callable[[Variant], Variant]] = [
        lambda each: reframed(each, chance, skeleton.is_floating),
        lambda each: flipped(each, chance),
        lambda each: renamed(each, chance),
        lambda each: reordered(each, chance),
        lambda each: split(each, chance),
    ]
    for change in changes:
        if chance.random() < 0.6:
            links = change(links)
    return links


def urdf_of(links: Sequence[RigidLink]) -> str:
    """Return the URDF of links with all their digits."""
    robot = Element("robot", name="variant")
    for link in links:
        element = SubElement(robot, "link", name=link.name)
        if link.body is not None and link.body.mass:
            inertial = SubElement(element, "inertial")
            SubElement(inertial, "origin", xyz=_text(link.body.com), rpy="0 0 0")
            SubElement(inertial, "mass", value=repr(link.body.mass))
            xx, yy, zz, xy, xz, yz = shifted(link.body, -1.0).moments
            names = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
            values = (xx, yy, zz, -xy, -xz, -yz)
            SubElement(inertial, "inertia", dict(zip(names, map(repr, values), strict=True)))
    for link in links[1:]:
        kind = {"revolute": "continuous"}.get(link.joint_kind, link.joint_kind)
        joint = SubElement(robot, "joint", name=link.joint, type=kind)
        angles = fixed_axis_angles(link.parent_T_joint.rotation)
        SubElement(joint, "origin", xyz=_text(link.parent_T_joint.translation), rpy=_text(angles))
        SubElement(joint, "parent", link=links[link.parent or 0].name)
        SubElement(joint, "child", link=link.name)
        SubElement(joint, "axis", xyz=_text(link.axis))
        if kind == "prismatic":
            SubElement(joint, "limit", lower="-1", upper="1", effort="1", velocity="1")
    return tostring(robot, encoding="unicode")


def _text(values: Iterable[float]) -> str:
    return " ".join(map(repr, values))
