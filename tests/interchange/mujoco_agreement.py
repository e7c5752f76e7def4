"""How far MuJoCo's numbers for a robot are from ours; joints, bodies and sites have our names."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import mujoco
import numpy as np

from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.spatial.arrays import Array

GRAVITY = np.array([0.0, 0.0, -9.81])


class Gap(NamedTuple):
    """Greatest differences, each over the greatest entry of its kind or one, if that is more."""

    poses: float
    inertia: float
    bias: float


class State(NamedTuple):
    """Joint values and velocities by index, and of a floating base its pose and velocity in it."""

    q: Array
    qd: Array
    world_R_base: Array
    world_r_base: Array
    v_base: Array


def gap(ours: Mechanics, model: Any, chance: np.random.Generator) -> Gap:
    """Return the differences in a random state, of all poses."""
    return _gap(ours, model, chance, tuple(ours.forward_kinematics([0.0] * ours.n_joints)))


def gap_of_imported(ours: Mechanics, model: Any, chance: np.random.Generator) -> Gap:
    """Return the differences where our links have other frames than their bodies.

    In ours they are at their joints, and turned to their axes.
    """
    names = [model.body(body).name for body in range(model.nbody)]
    names += [model.site(site).name for site in range(model.nsite)]
    frames = [frame.name for frame in ours.bodies.frames]
    return _gap(ours, model, chance, [name for name in frames if name in names])


def _gap(ours: Mechanics, model: Any, chance: np.random.Generator, names: Sequence[str]) -> Gap:
    n = ours.n_joints
    q, qd = chance.uniform(-1, 1, (2, n))
    quaternion = chance.normal(size=4)
    R = np.zeros(9)
    mujoco.mju_quat2Mat(R, quaternion / np.linalg.norm(quaternion))
    state = State(q, qd, R.reshape(3, 3), chance.uniform(-1, 1, 3), chance.uniform(-1, 1, 6))
    data = mujoco.MjData(model)
    _set(model, data, ours, state)
    mujoco.mj_forward(model, data)
    M = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, M)
    B = _their_velocity_to_ours(model, ours, state)
    M_ours = ours.joint_space_inertia(q)
    return Gap(
        _pose_gap(ours, model, data, q, names),
        _relative(B.T @ M_ours @ B, M),
        _relative(B.T @ _bias(ours, M_ours, state), data.qfrc_bias),
    )


def _set(model: Any, data: Any, ours: Mechanics, state: State) -> None:
    for name, value, rate in zip(ours.joint_names, state.q, state.qd, strict=True):
        data.joint(name).qpos[0] = value
        data.joint(name).qvel[0] = rate
    if ours.bodies.is_floating:
        quaternion = np.zeros(4)
        mujoco.mju_mat2Quat(quaternion, np.ascontiguousarray(state.world_R_base).ravel())
        data.qpos[:7] = [*state.world_r_base, *quaternion]
        data.qvel[:6] = [*(state.world_R_base @ state.v_base[3:]), *state.v_base[:3]]


def _their_velocity_to_ours(model: Any, ours: Mechanics, state: State) -> Array:
    """Return B with `our velocity = B @ their velocity`: theirs is linear first, in the world."""
    n_base = 6 if ours.bodies.is_floating else 0
    B = np.zeros((model.nv, model.nv))
    if n_base:
        B[:3, 3:6] = np.eye(3)
        B[3:6, :3] = state.world_R_base.T
    for i, name in enumerate(ours.joint_names):
        B[n_base + i, model.joint(name).dofadr[0]] = 1.0
    return B


def _bias(ours: Mechanics, M: Array, state: State) -> Array:
    """Return our bias where their acceleration is zero: ours turns with the base's coordinates."""
    if not ours.bodies.is_floating:
        return ours.bias_torque(state.q, state.qd)
    gravity = state.world_R_base.T @ GRAVITY
    bias = ours.bias_torque(state.q, state.qd, base_velocity=state.v_base, gravity=gravity)
    return np.asarray(bias - M[:, 3:6] @ np.cross(state.v_base[:3], state.v_base[3:]))


def _pose_gap(ours: Mechanics, model: Any, data: Any, q: Array, names: Sequence[str]) -> float:
    poses = ours.forward_kinematics(q)
    base = _pose(data.body(ours.bodies.base_name)) if ours.bodies.is_floating else None
    worst = 0.0
    bodies = {model.body(body).name for body in range(model.nbody)}
    for name in names:
        pose, theirs = poses[name], _pose(data.body(name) if name in bodies else data.site(name))
        if base is not None:
            theirs = np.linalg.inv(base) @ theirs
        worst = max(worst, _relative(pose, theirs))
    return worst


def _pose(thing: Any) -> Array:
    T = np.eye(4)
    T[:3, :3] = thing.xmat.reshape(3, 3)
    T[:3, 3] = thing.xpos
    return T


def _relative(ours: Array, theirs: Array) -> float:
    return float(abs(ours - theirs).max() / max(1.0, abs(theirs).max()))
