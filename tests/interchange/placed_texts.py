"""Placed robots as MJCF, SDF and URDF, in one of many ways to say it."""

from collections.abc import Sequence

import numpy as np
from tests.interchange.placed_robots import PlacedBody, fixed_axis_angles, quaternion, random_pose

from kindsl.mechanics.spatial.arrays import Array

Bodies = Sequence[PlacedBody]
WORLD = np.eye(4)


def mjcf(bodies: Bodies) -> str:
    """Return the plainest of all: poses by quaternions, each in the parent's frame."""
    return f'<mujoco model="placed"><worldbody>{_mjcf_bodies(bodies, -1)}</worldbody></mujoco>'


def _mjcf_bodies(bodies: Bodies, parent: int) -> str:
    return "".join(_mjcf_body(bodies, i) for i, b in enumerate(bodies) if b.parent == parent)


def _mjcf_body(bodies: Bodies, index: int) -> str:
    body = bodies[index]
    parent = WORLD if body.parent < 0 else bodies[body.parent].pose
    R = _in(body.pose, body.inertial)[:3, :3]
    I = R @ body.tensor @ R.T  # noqa: E741
    moments = _text([I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[0, 2], I[1, 2]])
    com = _text(_in(body.pose, body.inertial)[:3, 3])
    return (
        f'<body name="{body.name}" {_mjcf_pose(_in(parent, body.pose))}>{_mjcf_joint(body)}'
        f'<inertial pos="{com}" mass="{body.mass!r}" fullinertia="{moments}"/>'
        f'<site name="f_{body.name}" {_mjcf_pose(_in(body.pose, body.frame))}/>'
        f"{_mjcf_bodies(bodies, index)}</body>"
    )


def _mjcf_joint(body: PlacedBody) -> str:
    if body.kind == "free":
        return "<freejoint/>"
    if body.kind == "fixed":
        return ""
    kind = "hinge" if body.kind == "revolute" else "slide"
    R = body.pose[:3, :3]
    at, axis = _text(R.T @ (body.anchor - body.pose[:3, 3])), _text(R.T @ body.axis)
    return f'<joint name="j_{body.name}" type="{kind}" pos="{at}" axis="{axis}"/>'


def _mjcf_pose(pose: Array) -> str:
    x, y, z, w = quaternion(pose[:3, :3])
    return f'pos="{_text(pose[:3, 3])}" quat="{_text([w, x, y, z])}"'


def sdf(bodies: Bodies, chance: np.random.Generator) -> str:
    """Return a model whose own pose is anywhere, with poses relative to anything."""
    model = random_pose(chance)
    attributes, placed = "", model
    if chance.integers(2):
        attributes, placed = ' placement_frame="f_b0"', bodies[0].frame
    known = {"": model, "__model__": model}
    parts = [_sdf_pose(placed, {"": WORLD}, chance)]
    for body in bodies:
        parent = "world" if body.parent < 0 else bodies[body.parent].name
        pose = _sdf_pose(body.pose, known, chance)
        inertial = _sdf_pose(_in(body.pose, body.inertial), {"": WORLD}, chance)
        parts.append(f'<link name="{body.name}">{pose}<inertial>{inertial}{_sdf_mass(body)}'
                     "</inertial></link>")  # fmt: skip
        known[body.name] = body.pose
        if body.kind != "free":
            parts.append(_sdf_joint(body, parent, known, chance))
        frame = _sdf_pose(body.frame, known | {"": body.pose}, chance)
        parts.append(f'<frame name="f_{body.name}" attached_to="{body.name}">{frame}</frame>')
        known[f"f_{body.name}"] = body.frame
    head, *rest = parts
    chance.shuffle(rest)
    body_text = "".join((head, *rest))
    return f'<sdf version="1.9"><model name="placed"{attributes}>{body_text}</model></sdf>'


def _sdf_joint(
    body: PlacedBody, parent: str, known: dict[str, Array], chance: np.random.Generator
) -> str:
    at = random_pose(chance)
    at[:3, 3] = body.anchor
    pose = _sdf_pose(at, known | {"": body.pose}, chance)
    ends = f"<parent>{parent}</parent><child>{body.name}</child>"
    axis = ""
    if body.kind != "fixed":
        frames = known | {"": at}
        name = str(chance.choice(list(frames)))
        attribute = f' expressed_in="{name}"' if name else ""
        along = _text(frames[name][:3, :3].T @ body.axis)
        axis = f"<axis><xyz{attribute}>{along}</xyz></axis>"
    return f'<joint name="j_{body.name}" type="{body.kind}">{pose}{ends}{axis}</joint>'


def _sdf_mass(body: PlacedBody) -> str:
    places = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
    moments = "".join(f"<i{n}>{float(body.tensor[at])!r}</i{n}>" for n, at in places.items())
    return f"<mass>{body.mass!r}</mass><inertia>{moments}</inertia>"


def _sdf_pose(pose: Array, frames: dict[str, Array], chance: np.random.Generator) -> str:
    """Return a pose relative to one of the frames, each given in the world."""
    name = str(chance.choice(list(frames)))
    pose = _in(frames[name], pose)
    attributes = f' relative_to="{name}"' if name else ""
    way = chance.integers(3)
    if way == 0:
        turn = quaternion(pose[:3, :3]) * chance.uniform(0.5, 2.0)
        attributes += ' rotation_format="quat_xyzw"'
    else:
        turn = fixed_axis_angles(pose[:3, :3])
        if way == 1:
            turn, attributes = np.degrees(turn), attributes + ' degrees="true"'
    return f"<pose{attributes}>{_text([*pose[:3, 3], *turn])}</pose>"


def urdf(bodies: Bodies, chance: np.random.Generator) -> str:
    """Return links whose frames are at their joints, as a URDF has them, on a link `world`."""
    parts = ['<link name="world"/>']
    frames = [_urdf_frame(body) for body in bodies]
    for body, frame in zip(bodies, frames, strict=True):
        parent = WORLD if body.parent < 0 else frames[body.parent]
        parent_name = "world" if body.parent < 0 else bodies[body.parent].name
        kind = "floating" if body.kind == "free" else body.kind
        parts += [
            f'<link name="{body.name}">{_urdf_inertial(body, frame, chance)}</link>',
            _urdf_joint(f"j_{body.name}", kind, parent_name, body.name, _in(parent, frame),
                        frame[:3, :3].T @ body.axis, chance),
            f'<link name="f_{body.name}"/>',
            _urdf_joint(f"jf_{body.name}", "fixed", body.name, f"f_{body.name}",
                        _in(frame, body.frame), np.ones(3), chance),
        ]  # fmt: skip
    chance.shuffle(parts)
    return f'<robot name="placed">{"".join(parts)}</robot>'


def _urdf_frame(body: PlacedBody) -> Array:
    frame = np.array(body.pose)
    if body.kind in ("revolute", "prismatic"):
        frame[:3, 3] = body.anchor
    return frame


def _urdf_joint(
    name: str, kind: str, parent: str, child: str, pose: Array, axis: Array,
    chance: np.random.Generator,
) -> str:  # fmt: skip
    limit = '<limit lower="-9" upper="9" effort="9" velocity="9"/>'
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'{_urdf_origin(pose, chance)}<axis xyz="{_text(axis)}"/>{limit}</joint>'
    )


def _urdf_inertial(body: PlacedBody, frame: Array, chance: np.random.Generator) -> str:
    I = body.tensor.tolist()  # noqa: E741
    moments = f'ixx="{I[0][0]}" ixy="{I[0][1]}" ixz="{I[0][2]}" iyy="{I[1][1]}"'
    return (
        f'<inertial>{_urdf_origin(_in(frame, body.inertial), chance)}<mass value="{body.mass!r}"/>'
        f'<inertia {moments} iyz="{I[1][2]}" izz="{I[2][2]}"/></inertial>'
    )


def _urdf_origin(pose: Array, chance: np.random.Generator) -> str:
    R = pose[:3, :3]
    turn = f'rpy="{_text(fixed_axis_angles(R))}"'
    if chance.integers(2):
        turn = f'quat_xyzw="{_text(quaternion(R))}"'
    return f'<origin xyz="{_text(pose[:3, 3])}" {turn}/>'


def _in(frame: Array, pose: Array) -> Array:
    return np.asarray(np.linalg.inv(frame) @ pose)


def _text(values: Array | list[float]) -> str:
    return " ".join(repr(float(value)) for value in values)
