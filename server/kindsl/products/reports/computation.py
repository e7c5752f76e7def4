"""Poses, inertia and forces in many configurations at once, as for `kindsl compute`."""

from collections.abc import Iterator, Mapping, Sequence
from io import BytesIO
from typing import Any, NamedTuple

import numpy as np

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.mechanics.spatial.arrays import Array
from kindsl.products.reports.motions import Motion
from kindsl.products.reports.robot_facts import missing_facts
from kindsl.robots.mechanism.build import Mechanism


class Results(NamedTuple):
    """The computed quantities; leading dimension k is the configurations'.

    Attributes:
        analysis: The document.
        mechanism: Its bodies.
        inputs: `q`, `qd`, ... by name, shape (k, n) or (k, 6).
        poses: `base_T_x` (k, 4, 4) of each link and frame x by name.
        jacobians: (k, 6, nv) of each link and frame by name.
        quantities: The others by name, in the order of the JSON.
    """

    analysis: Analysis
    mechanism: Mechanism
    inputs: dict[str, Array]
    poses: Mapping[str, Array]
    jacobians: dict[str, Array]
    quantities: dict[str, Array]

    @property
    def n_configurations(self) -> int:
        """The number of configurations."""
        return len(self.inputs["q"])

    def head(self) -> dict[str, Any]:
        """Return what is the same for all configurations."""
        bodies, values = self.mechanism.bodies, self.analysis.context.values
        names = (bodies.base_name, *bodies.link_names)
        missing = missing_facts(self.analysis.model, values)
        return {
            "robot": self.analysis.model.name,
            "floating": bodies.is_floating,
            **({"missing_masses": missing} if missing else {}),
            "parameters": {str(p.name): values.get(p.name) for p in self.analysis.model.parameters},
            "links": [
                {
                    "name": bodies.link_names[link - 1],
                    "id": link,
                    "parent": names[parent],
                    "joint": bodies.joint_names[link - 1],
                    "joint_type": bodies.joint_kinds[link - 1],
                }
                for link, parent in bodies.links()
            ],
        }

    def as_json(self) -> dict[str, Any]:
        """Return everything as plain data."""
        return {**self.head(), "configurations": list(self._configurations())}

    def as_npz(self) -> bytes:
        """Return everything as a NumPy archive; names of links and joints are in it."""
        bodies = self.mechanism.bodies
        names = {
            "link_names": np.array(bodies.link_names),
            "joint_names": np.array(bodies.joint_names),
            "pose_names": np.array(list(self.poses)),
        }
        stacks = {
            "poses": np.stack(list(self.poses.values()), axis=1),
            "jacobians": np.stack(list(self.jacobians.values()), axis=1),
        }
        archive = BytesIO()
        np.savez(archive, **names, **self.inputs, **stacks, **self.quantities)  # type: ignore[arg-type]
        return archive.getvalue()

    def _configurations(self) -> Iterator[dict[str, Any]]:
        links = frozenset(self.mechanism.bodies.link_names)
        for k in range(self.n_configurations):
            poses = {name: pose[k].tolist() for name, pose in self.poses.items()}
            yield {
                **{name: values[k].tolist() for name, values in self.inputs.items()},
                "link_poses": {name: pose for name, pose in poses.items() if name in links},
                "frame_poses": {name: pose for name, pose in poses.items() if name not in links},
                **{name: _listed(values[k]) for name, values in self.quantities.items()},
                "jacobians": {name: J[k].tolist() for name, J in self.jacobians.items()},
            }


def _listed(values: Array) -> Any:
    """Return numbers as lists, None for what is not defined."""
    return None if np.isnan(values).any() else values.tolist()


def compute(
    analysis: Analysis,
    mechanism: Mechanism,
    motions: Sequence[Motion],
    gravity: Sequence[float],
    *,
    is_forward: bool,
) -> Results:
    """Return all quantities for all configurations.

    Gravity is in base coordinates, m/s^2. Forward, accelerations follow from forces.

    Raises:
        ValueError: A quantity is not defined: nothing resists a motion.
    """
    q = np.array([motion.q for motion in motions])
    inputs = {"q": q, "qd": np.array([motion.qd for motion in motions])}
    if mechanism.bodies.is_floating:
        inputs["base_velocity"] = np.array([motion.base_velocity for motion in motions])
    given = "tau" if is_forward else "qdd"
    inputs[given] = np.array([getattr(motion, given) for motion in motions])
    poses = mechanism.forward_kinematics(q)
    jacobians = {name: mechanism.jacobian(q, name) for name in poses}
    found = _quantities(mechanism, inputs, gravity)
    return Results(analysis, mechanism, inputs, poses, jacobians, found)


def _quantities(
    mechanism: Mechanism, inputs: dict[str, Array], gravity: Sequence[float]
) -> dict[str, Array]:
    q, qd = inputs["q"], inputs["qd"]
    base_velocity = inputs.get("base_velocity")
    found = {
        "mass": np.full(len(q), mechanism.total_mass()),
        "com": _centre_of_mass(mechanism, q),
        "joint_space_inertia": mechanism.joint_space_inertia(q),
        "gravity_torque": mechanism.gravity_torque(q, gravity),
        "bias_torque": mechanism.bias_torque(q, qd, base_velocity, gravity),
    }
    if "tau" in inputs:
        answer = mechanism.forward_dynamics(q, qd, inputs["tau"], base_velocity, gravity)
        return {**found, **_answered("qdd", answer)}
    inverse = mechanism.inverse_dynamics(q, qd, inputs["qdd"], base_velocity, gravity)
    return {**found, **_answered("inverse_dynamics", inverse)}


def _centre_of_mass(mechanism: Mechanism, q: Array) -> Array:
    """Return the centre of mass (k, 3), NaN for a robot that weighs nothing."""
    has_mass = np.any(mechanism.bodies.masses)
    return mechanism.center_of_mass(q) if has_mass else np.full((len(q), 3), np.nan)


def _answered(name: str, answer: Array | tuple[Array, Array]) -> dict[str, Array]:
    """Return an answer by name; of a floating base it has two parts."""
    if isinstance(answer, tuple):
        return {name: answer[0], "base_acceleration": answer[1]}
    return {name: answer}
