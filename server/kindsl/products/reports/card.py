"""A model's page for a wiki or a paper: the contents of its document, and its health."""

from collections.abc import Iterator
from math import degrees
from typing import Any

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.body_doubts import body_doubts
from kindsl.judgement.analysis.settings import pose_named
from kindsl.judgement.rules.inertia.shapes import shape_doubts
from kindsl.language.text.phrases import counted
from kindsl.mechanics.rigid.body import principal_moments_about_com
from kindsl.mechanics.rigid.pose import PLAIN, RigidPose, angles
from kindsl.products.reports.columns import PARAMETER_UNITS, number
from kindsl.products.reports.drawing.robot import robot_drawing
from kindsl.products.reports.joint_transforms import joint_transform
from kindsl.products.reports.page.blocks import (
    Block,
    Figure,
    Heading,
    Matrix,
    Page,
    Paragraph,
    Table,
)
from kindsl.products.reports.robot_facts import branches, mass_text, robot_facts
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.mechanism.total_mass import unknown_bodies
from kindsl.robots.scene.picture import Picture, picture


def card_page(analysis: Analysis, pose: str | None = None) -> Page:
    """Return the page of a document, pictured in a pose or at zero; of a broken one, a part.

    Raises:
        PoseError: The configuration has no such pose for this robot.
    """
    facts = robot_facts(analysis)
    shown = picture(analysis.model, analysis.context.values, None)
    blocks = [*_heading(facts, shown, analysis, pose), *_tree(facts)]
    if shown.skeleton is not None:
        blocks += [*_joints(shown.skeleton), *_masses(shown.skeleton, facts, analysis)]
        blocks += _frames(shown.skeleton)
    return (*blocks, *_parameters(facts), *_transforms(analysis), *_health(facts))


def shown_skeleton(analysis: Analysis) -> Linkage | None:
    """Return the drawable bodies of a document, None if there are none."""
    return picture(analysis.model, analysis.context.values, None).skeleton


def _heading(
    facts: dict[str, Any], shown: Picture, analysis: Analysis, pose: str | None
) -> Iterator[Block]:
    yield Heading(facts["robot"] or "(unnamed)", 1)
    base = "floating" if facts["floating"] else "fixed"
    dof = counted(facts["dof"], "degree")
    yield Paragraph(f"{base} base, {dof} of freedom, mass {mass_text(facts)}")
    if shown.message:
        yield Paragraph(shown.message)
    if shown.skeleton is not None:
        place = "At zero" if pose is None else f"In pose '{pose}'"
        caption = f"{place}: bodies, joints with their axes, frames (green), centres of mass (gold)"
        posed = _in_pose(shown.skeleton, analysis, pose)
        doubts = body_doubts(analysis, analysis.findings)
        yield Figure("robot", robot_drawing(posed, doubts=doubts), caption)


def _in_pose(skeleton: Linkage, analysis: Analysis, pose: str | None) -> Linkage:
    if pose is None:
        return skeleton
    joints = [str(joint.name) for joint in analysis.model.joints]
    values = pose_named(analysis.settings, pose, joints)
    return skeleton.moved_to([values.get(joint, 0.0) for joint in skeleton.joint_names])


def _tree(facts: dict[str, Any]) -> Iterator[Block]:
    yield Heading("Tree")
    header = ("link", "id", "joint", "kind", "mass / kg", "frames")
    rows = tuple(
        (
            "  " * len(are_last) + (body["name"] or "(unnamed)"),
            "" if body["id"] is None else str(body["id"]),
            body["joint"] or "",
            body["joint_type"] or "",
            number(body["mass"]),
            ", ".join(body["frames"]),
        )
        for are_last, body in branches(facts)
    )
    yield Table(header, rows, frozenset((1, 4)))


def _joints(skeleton: Linkage) -> Iterator[Block]:
    if not skeleton.n_links:
        return
    yield Heading("Joints")
    header = ("joint", "kind", "from", "to", "translation / m", "rotation / deg")
    rows = tuple(
        (
            skeleton.joint_names[link - 1],
            skeleton.joint_kinds[link - 1],
            skeleton.body_names[parent],
            skeleton.body_names[link],
            *_pose_cells(skeleton.placements[link - 1]),
        )
        for link, parent in skeleton.links()
    )
    yield Table(header, rows)


def _masses(skeleton: Linkage, facts: dict[str, Any], analysis: Analysis) -> Iterator[Block]:
    yield Heading("Masses")
    header = ("link", "mass / kg", "CoM / m", "principal moments / kg m²", "shape")
    first = 0 if skeleton.base_mass_counts else 1
    bodies = list(zip(skeleton.body_names, skeleton.masses, strict=True))[first:]
    unknown = unknown_bodies(analysis.model, analysis.context.values)
    written = {body["name"]: body["mass"] for _, body in branches(facts)}
    moments = [principal_moments_about_com(body) for _, body in bodies]
    rows = tuple(
        (name, number(written.get(name)), "-", "-", "-")
        if name in unknown
        else (name, number(body.mass), triple(body.com), triple(own), _shape(analysis, name))
        for (name, body), own in zip(bodies, moments, strict=True)
    )
    yield Table(header, rows, frozenset((1,)))


def _shape(analysis: Analysis, name: str) -> str:
    """Return the doubts about a body in a word or two, or a dash."""
    body = analysis.model.body_named[name]
    doubts = shape_doubts(body, analysis.model.tree.joints_on(body), analysis.context)
    reported = (doubt for at, doubt in doubts if not analysis.is_silenced(doubt.code, at))
    return ", ".join(doubt.kind for doubt in reported) or "-"


def _frames(skeleton: Linkage) -> Iterator[Block]:
    if not skeleton.frames:
        return
    yield Heading("Frames")
    header = ("frame", "link", "translation / m", "rotation / deg")
    rows = tuple(
        (frame.name, skeleton.body_names[frame.body], *_pose_cells(frame.pose))
        for frame in skeleton.frames
    )
    yield Table(header, rows)


def _parameters(facts: dict[str, Any]) -> Iterator[Block]:
    if not facts["parameters"]:
        return
    yield Heading("Parameters")
    header = ("parameter", "kind", "value", "minimum", "maximum", "bound by")
    rows = tuple(
        (
            parameter["name"],
            parameter["kind"],
            number(parameter["value"], PARAMETER_UNITS[parameter["kind"]]),
            number(parameter["min"]),
            number(parameter["max"]),
            parameter["origin"] or "nothing",
        )
        for parameter in facts["parameters"]
    )
    yield Table(header, rows, frozenset((2, 3, 4)))


def _transforms(analysis: Analysis) -> Iterator[Block]:
    matrices = []
    for edge in analysis.model.tree.edges:
        if edge.joint is None:
            continue
        rows = joint_transform(edge.joint, analysis.context.values)
        if rows is not None:
            ends = f"{edge.predecessor.name} to {edge.child.link}"
            label = f"{edge.joint.name}, from {ends}:"
            matrices.append(Matrix(label, rows))
    if matrices:
        yield Heading("Transforms")
        yield Paragraph(
            "Each takes the link's coordinates to its predecessor's; q is the joint's variable."
        )
        yield from matrices


def _health(facts: dict[str, Any]) -> Iterator[Block]:
    health = facts["health"]
    yield Heading("Health")
    yield Paragraph(health["verdict"])
    if health["findings"]:
        rows = tuple(
            (f"{f['line']}:{f['column']}", f["severity"], f["code"], f["message"])
            for f in health["findings"]
        )
        yield Table(("place", "severity", "rule", "finding"), rows)


def _pose_cells(pose: RigidPose) -> tuple[str, str]:
    turned = angles(pose.rotation, PLAIN)
    return triple(pose.translation), triple(tuple(map(degrees, turned)))


def triple(values: tuple[float, ...]) -> str:
    """Return numbers for people as `(x, y, z)`."""
    return f"({', '.join(f'{value:z.6g}' for value in values)})"
