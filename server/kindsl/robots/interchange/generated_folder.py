"""The robot in a folder that `kindsl generate` wrote: its manifest records the numbers."""

import json
from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path
from typing import Any

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.comparison.written import (
    Described,
    WrittenInertia,
    exactly_turned,
    written_frame,
)
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.mechanism.skeleton import AttachedFrame, Skeleton

MANIFEST = "kindsl-generated.json"
KEY = "robot"
# Build files and texts, which anybody may edit.
_WITHOUT_NUMBERS = (".md", ".txt")


def robot_record(skeleton: Skeleton) -> dict[str, object]:
    """Return a robot as plain data: SI units, poses as a translation and the rotation's rows."""
    links = zip(
        skeleton.link_names,
        skeleton.joint_names,
        skeleton.joint_kinds,
        skeleton.parents,
        skeleton.placements,
        skeleton.masses[1:],
        strict=True,
    )
    return {
        "base": skeleton.base_name,
        "floating": skeleton.is_floating,
        "base_inertia": _inertia_record(skeleton.masses[0]),
        "links": [
            {
                "name": name,
                "joint": joint,
                "kind": kind,
                "parent": skeleton.body_names[parent],
                "pose": list(pose.numbers),
                "inertia": _inertia_record(body),
            }
            for name, joint, kind, parent, pose, body in links
        ],
        "frames": [
            {
                "name": frame.name,
                "link": skeleton.body_names[frame.body],
                "pose": list(frame.pose.numbers),
            }
            for frame in skeleton.frames
        ],
    }


def described_generated(folder: Path, label: str) -> Described:
    """Return the robot of a folder that `kindsl generate` wrote.

    Raises:
        FormatError: Its manifest is not one, or an earlier version wrote it, without numbers; or
            somebody edited the code.
        OSError: It cannot be read.
    """
    try:
        record = json.loads((folder / MANIFEST).read_text("utf-8"))
        skeleton = _skeleton(record[KEY])
        edited = _edited(folder, record.get("files", {}))
    except KeyError:
        raise FormatError(f"'{MANIFEST}' has no numbers: generate the code again") from None
    except (ValueError, TypeError, AttributeError):
        raise FormatError(f"'{MANIFEST}' is not a manifest of generated code") from None
    if edited is not None:
        message = f"'{edited}' was edited after it was generated, so its numbers are not known"
        raise FormatError(f"{message}: generate the code again")
    bodies = zip(skeleton.body_names, skeleton.masses, strict=True)
    poses = zip(skeleton.joint_names, skeleton.placements, strict=True)
    inertias = tuple((_inertia(name, body),) if body.mass else () for name, body in bodies)
    return exactly_turned(label, skeleton, inertias, tuple(written_frame(*each) for each in poses))


def digest(content: bytes) -> str:
    """Return the SHA-256 of something, in hexadecimal digits."""
    return sha256(content).hexdigest()


def _edited(folder: Path, files: Mapping[str, str]) -> str | None:
    """Return a file of code that is not as it was generated, whatever its line ends."""
    for name, expected in files.items():
        path = folder / name
        if path.suffix in _WITHOUT_NUMBERS or not path.is_file():
            continue
        content = path.read_bytes()
        if expected not in (digest(content), digest(content.replace(b"\r\n", b"\n"))):
            return name
    return None


def _inertia_record(body: MassDistribution) -> list[float]:
    return [body.mass, *body.com, *body.moments]


def _inertia(name: str, body: MassDistribution) -> WrittenInertia:
    values = tuple(_inertia_record(body))
    turn = IDENTITY.rotation
    return WrittenInertia(name, IDENTITY, turn, False, 1.0, values, (None,) * len(values))


def _skeleton(robot: Mapping[str, Any]) -> Skeleton:
    links, frames = robot["links"], robot["frames"]
    names = [robot["base"], *(link["name"] for link in links)]
    return Skeleton(
        str(robot["base"]),
        tuple(str(link["name"]) for link in links),
        tuple(str(link["joint"]) for link in links),
        tuple(link["kind"] for link in links),
        tuple(names.index(link["parent"]) for link in links),
        tuple(_pose(link["pose"]) for link in links),
        (_body(robot["base_inertia"]), *(_body(link["inertia"]) for link in links)),
        bool(robot["floating"]),
        tuple(
            AttachedFrame(str(f["name"]), names.index(f["link"]), _pose(f["pose"])) for f in frames
        ),
    )


def _pose(numbers: list[float]) -> RigidPose:
    x, y, z, *rest = map(float, numbers)
    a, b, c, d, e, f, g, h, i = rest
    return RigidPose(((a, b, c), (d, e, f), (g, h, i)), (x, y, z))


def _body(numbers: list[float]) -> MassDistribution:
    mass, x, y, z, *moments = map(float, numbers)
    xx, yy, zz, xy, xz, yz = moments
    return MassDistribution(mass, (x, y, z), (xx, yy, zz, xy, xz, yz))
