"""Meshes and simple shapes of a URDF on the links of a document, matched by their joints."""

import base64
from collections.abc import Iterable, Iterator, Mapping
from math import asin, degrees
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from kindsl.judgement.analysis.twins import read_file
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.model import Model
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.comparison.document_side import described_document
from kindsl.robots.comparison.features import axis_of, lines_apart
from kindsl.robots.comparison.mechanical import MechanicalComparison, compared_mechanics
from kindsl.robots.comparison.restated import body_frame, restated
from kindsl.robots.comparison.twins import TwinFile
from kindsl.robots.interchange.format import FormatError, ReadingChoices
from kindsl.robots.interchange.mesh_files import MeshFile, mesh_file, package_of
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf
from kindsl.robots.interchange.urdf.visuals import LinkVisual, visuals_of_urdf
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.scene.marks import column_major
from kindsl.robots.scene.messages import (
    MeshDataMessage,
    MeshesMessage,
    Part,
    VisualMessage,
    path_of,
)

# Of an axis beside ours: of the robot's size, and as a sine. More is another robot's mesh.
_FAR, _TURNED = 5e-3, 1e-2
_DUST = 1e-9  # metres, or a sine: rounding of the arithmetic, which no message tells
_MOST_VISUALS = 2000
_MOST_BYTES = 256 * 2**20
_SHOWN = 3
_SUFFIX = ".urdf"
_MOST_EMBEDDED = 64 * 2**20


class MeshSource(NamedTuple):
    """A URDF whose meshes can be drawn.

    Attributes:
        name: Of its file, as people know it.
        path: Where it is.
        folder: The folder with all files that it may name, None for that of its package.
        joints: Pairs of our joints and its, where names and axes do not tell.
    """

    name: str
    path: Path
    folder: Path | None = None
    joints: tuple[tuple[str, str], ...] = ()


class LinkMeshes(NamedTuple):
    """The shapes on the links of a document.

    Attributes:
        messages: For the page.
        files: The meshes by their names at the server.
    """

    messages: list[Part]
    files: dict[str, MeshFile]


class _PlacedVisual(NamedTuple):
    """A visual in the frame of our link."""

    link: str
    link_T_visual: RigidPose
    visual: LinkVisual


def twin_source(twins: Iterable[TwinFile]) -> MeshSource | None:
    """Return the first twin that may have meshes."""
    found = (t for t in twins if Path(t.path).suffix.lower() == _SUFFIX and Path(t.path).is_file())
    return next((MeshSource(t.label, Path(t.path), None, t.joints) for t in found), None)


def offered(source: MeshSource) -> list[Part]:
    """Return that meshes can be asked for."""
    return [MeshesMessage(source.name, False, ())]


def link_meshes(source: MeshSource, model: Model, values: Values, skeleton: Linkage) -> LinkMeshes:
    """Return the meshes of a URDF on a document's links, and report those left out."""
    ours = described_document("here", model, values, skeleton)
    try:
        content = source.path.read_bytes()
        choices = ReadingChoices(floating=ours.skeleton.is_floating)
        read = robot_of_urdf(content, source.name, choices)
        visuals = visuals_of_urdf(content)
    except FormatError as error:
        return _nothing(source, str(error))
    except OSError as error:
        return _nothing(source, f"cannot be read: {error.strerror or error}")
    theirs = read_file(str(source.path), source.name, ours.skeleton.is_floating)
    if isinstance(theirs, str):
        return _nothing(source, theirs)
    found = compared_mechanics(ours, theirs, dict(source.joints))
    refused = dict(_refused(ours.skeleton, theirs.skeleton, found, source.name))
    placed = list(_placed(ours.skeleton, read.robot, found, visuals, refused))
    if not visuals:
        return _nothing(source, "has no visuals")
    return _drawn(source, placed[:_MOST_VISUALS], list(dict.fromkeys(refused.values())))


def mesh_data(files: dict[str, MeshFile]) -> Iterator[MeshDataMessage]:
    """Yield the content of meshes, for a page without a server."""
    room = _MOST_EMBEDDED
    for name, file in files.items():
        content = file.read()
        room -= len(content or b"")
        if content is not None and room >= 0:
            data = base64.b64encode(content).decode("ascii")
            yield MeshDataMessage(path_of("mesh-data", name), name, data)


def _nothing(source: MeshSource, problem: str) -> LinkMeshes:
    told = f"{source.name}: {problem}"
    return LinkMeshes([MeshesMessage(source.name, True, (told,))], {})


def _refused(
    ours: Linkage, theirs: Linkage, found: MechanicalComparison, name: str
) -> Iterator[tuple[int, str]]:
    """Yield the other's bodies that get no mesh, and why: no match, or an axis elsewhere."""
    other = restated(ours, theirs, found)
    size = max((sum(c * c for c in p.translation) ** 0.5 for p in ours.zero_poses), default=1.0)
    our_body = {its: body for body, its in found.matching.theirs.items()}
    for its, joint in enumerate(theirs.joint_names, 1):
        body = our_body.get(its)
        if body is None:
            yield its, f"meshes of joint '{joint}' of {name} left out: it matches none here"
            continue
        link, own_kind = ours.link_names[body - 1], ours.joint_kinds[body - 1]
        kind = theirs.joint_kinds[its - 1]
        poses = ours.placements[body - 1], other.placements[its - 1]
        sine, distance = lines_apart(*(axis_of(own_kind, pose) for pose in poses))
        if kind != own_kind:
            yield its, f"meshes of '{link}' left out: its joint is {kind} in {name}"
        elif sine > _TURNED or distance > _FAR * (size or 1.0):
            turned = f"{degrees(asin(min(1.0, sine))):.3g}°" if sine > _DUST else ""
            gap = f"{1e3 * distance:.3g} mm" if distance > _DUST else ""
            away = f"{' and '.join(filter(None, (gap, turned)))} away in {name}"
            yield its, f"meshes of '{link}' left out: the axis of its joint is {away}"


def _placed(
    ours: Linkage,
    robot: Linkage,
    found: MechanicalComparison,
    visuals: Iterable[LinkVisual],
    refused: dict[int, str],
) -> Iterator[_PlacedVisual]:
    our_body = {its: body for body, its in found.matching.theirs.items()}
    places = {
        part.name: (its, part.pose)
        for its, body in enumerate(robot.bodies)
        for part in body.parts
        if part.is_link
    }
    for visual in visuals:
        its, body_T_link = places.get(visual.link, (None, IDENTITY))
        if its is None or its in refused or its not in our_body:
            continue
        body = our_body[its]
        pose = body_frame(found, body).then(body_T_link).then(visual.link_T_visual)
        yield _PlacedVisual(ours.body_names[body], pose, visual)


def _drawn(source: MeshSource, placed: list[_PlacedVisual], problems: list[str]) -> LinkMeshes:
    files, lost = _files(source, [each.visual.file for each in placed])
    names = {address: name for name, (address, _) in files.items()}
    messages = [
        VisualMessage(
            path=path_of("meshes", str(index)),
            link=link,
            form=visual.form,
            size=visual.size,
            matrix=column_major(pose),
            file=names.get(visual.file, ""),
        )
        for index, (link, pose, visual) in enumerate(placed)
        if not visual.file or visual.file in names
    ]
    head = MeshesMessage(source.name, True, (*problems, *_losses(lost)))
    return LinkMeshes([head, *messages], {name: file for name, (_, file) in files.items()})


def _files(
    source: MeshSource, addresses: Iterable[str]
) -> tuple[dict[str, tuple[str, MeshFile]], dict[str, str]]:
    """Return the files by their names at the server, and why others are left out, by address."""
    folder = source.folder or package_of(source.path)
    files: dict[str, tuple[str, MeshFile]] = {}
    lost: dict[str, str] = {}
    total = 0
    for address in filter(None, dict.fromkeys(addresses)):
        file = mesh_file(address, source.path, folder)
        problem, stamp = file.problem(), 0
        if not problem:
            stat = file.path.stat()
            total, stamp = total + stat.st_size, stat.st_mtime_ns
        if problem or total > _MOST_BYTES:
            lost[address] = problem or f"beyond {_MOST_BYTES // 2**20} MB in all"
        else:
            name = f"{len(files)}-{stamp:x}{file.path.suffix.lower()}"
            files[name] = address, file
    return files, lost


def _losses(lost: Mapping[str, str]) -> Iterator[str]:
    for problem in dict.fromkeys(lost.values()):
        names = [PurePosixPath(address).name for address, why in lost.items() if why == problem]
        some = ", ".join(names[:_SHOWN]) + (", ..." if names[_SHOWN:] else "")
        plural = "mesh" if len(names) == 1 else "meshes"
        yield f"{len(names)} {plural} left out, {problem}: {some}"
