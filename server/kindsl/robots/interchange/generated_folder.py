"""The robot in a folder that `kindsl generate` wrote: its manifest records the numbers."""

import json
from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path
from typing import Any

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.comparison.side import ComparedSide, exactly_turned, written_joints
from kindsl.robots.comparison.written import WrittenInertia
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.mechanism.linkage import BodyPart, Linkage, RigidBody, checked

MANIFEST = "kindsl-generated.json"
KEY = "robot"
# Build files and texts, which anybody may edit.
_WITHOUT_NUMBERS = (".md", ".txt")


def robot_record(linkage: Linkage) -> dict[str, object]:
    """Return a robot as plain data: SI units, poses as a translation and the rotation's rows."""
    names = linkage.body_names
    masses = [mass.numbers for mass in linkage.masses]
    return {
        "base": linkage.base_name,
        "floating": linkage.is_floating,
        "base_inertia": masses[0],
        "links": [
            {
                "name": body.name,
                "joint": body.joint,
                "kind": body.kind,
                "parent": names[body.parent or 0],
                "pose": list(body.placement.numbers),
                "inertia": mass,
            }
            for body, mass in zip(linkage.bodies[1:], masses[1:], strict=True)
        ],
        "frames": [
            {"name": f.name, "link": names[f.body], "pose": list(f.pose.numbers)}
            for f in linkage.frames
        ],
    }


def described_generated(folder: Path, label: str) -> ComparedSide:
    """Return the robot of a folder that `kindsl generate` wrote.

    Raises:
        FormatError: Its manifest is not one, or an earlier version wrote it, without numbers; or
            somebody edited the code.
        OSError: It cannot be read.
    """
    try:
        record = json.loads((folder / MANIFEST).read_text("utf-8"))
        skeleton = _linkage(record[KEY])
        edited = _edited(folder, record.get("files", {}))
    except KeyError:
        raise FormatError(f"'{MANIFEST}' has no numbers: generate the code again") from None
    except (ValueError, TypeError, AttributeError):
        raise FormatError(f"'{MANIFEST}' is not a manifest of generated code") from None
    if edited is not None:
        message = f"'{edited}' was edited after it was generated, so its numbers are not known"
        raise FormatError(f"{message}: generate the code again")
    bodies = zip(skeleton.body_names, skeleton.masses, strict=True)
    inertias = tuple(
        (WrittenInertia(name, body.numbers),) if body.mass else () for name, body in bodies
    )
    return exactly_turned(ComparedSide(label, skeleton, inertias, written_joints(skeleton)))


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


def _linkage(robot: Mapping[str, Any]) -> Linkage:
    links, frames = robot["links"], robot["frames"]
    base = {"name": robot["base"], "inertia": robot["base_inertia"]}
    names = [base["name"], *(link["name"] for link in links)]
    named = ((str(each["name"]), map(float, each["inertia"])) for each in (base, *links))
    parts = [[BodyPart(name, mass=MassDistribution.of(ten))] for name, ten in named]
    for f in frames:
        part = BodyPart(str(f["name"]), _pose(f["pose"]), is_link=False)
        parts[names.index(f["link"])].append(part)
    carried = (
        RigidBody(
            tuple(own),
            names.index(link["parent"]),
            str(link["joint"]),
            link["kind"],
            _pose(link["pose"]),
        )
        for own, link in zip(parts[1:], links, strict=True)
    )
    return checked(Linkage((RigidBody(tuple(parts[0])), *carried), bool(robot["floating"])))


def _pose(numbers: list[float]) -> RigidPose:
    x, y, z, *rest = map(float, numbers)
    a, b, c, d, e, f, g, h, i = rest
    return RigidPose(((a, b, c), (d, e, f), (g, h, i)), (x, y, z))
