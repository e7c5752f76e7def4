"""Expected results of generated functions, from the mechanics that this program itself uses."""

import random
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from types import MappingProxyType

import numpy as np

from kindsl.language.semantics.transforms import LINK_PREFIX
from kindsl.mechanics.dynamics.bodies import Bodies, BodyFrame
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.generation.function import Function
from kindsl.mechanics.dynamics.joints import solve
from kindsl.mechanics.spatial.arrays import Array

Values = Mapping[str, Array]
NOTHING: Mapping[str, float] = MappingProxyType({})


def sample(bodies: Bodies, seed: int = 1) -> dict[str, Array]:
    """Return some values of all arguments, by their names in code; equal seeds, equal values."""
    generator = random.Random(seed)
    n = bodies.n_links
    lengths = {"q": n, "qd": n, "qdd": n, "tau": n, "v0": 6, "a0": 6, "fext": 6 * (n + 1)}
    values = {
        name: np.array([round(generator.uniform(-1.0, 1.0), 3) for _ in range(length)])
        for name, length in lengths.items()
    }
    return {**values, "g": np.array([0.3, -0.2, -9.7])}


def independent_contacts(mechanics: Mechanics, q: Array, contacts: Sequence[str]) -> Array:
    """Return one for each contact that holds what those before it do not hold, zero for others."""
    active, held = np.zeros(len(contacts)), np.zeros((0, mechanics.bodies.n_velocities))
    for number, name in enumerate(contacts):
        rows = np.concatenate((held, mechanics.jacobian(q, name)[3:]))
        if np.linalg.matrix_rank(rows, tol=1e-6) == len(rows):
            active[number], held = 1.0, rows
    return active


class Reference:
    """Answers for one configuration of a mechanism.

    Attributes:
        mechanics: The mechanism.
        values: Of all arguments, by their names in code.
        parameters: Values of the parameters that the mechanism has.
    """

    def __init__(
        self, mechanics: Mechanics, values: Values, parameters: Mapping[str, float] = NOTHING
    ) -> None:
        self.mechanics = mechanics
        self.values = values
        self.parameters = parameters
        self._base = values["v0"] if mechanics.bodies.is_floating else None
        self._joints = values["q"], values["qd"], values["qdd"]
        self._first = 6 if mechanics.bodies.is_floating else 0

    def results(self, function: Function) -> list[Array]:
        """Return what a function gives without external forces, one array a result."""
        return self._answer(function, np.zeros(self._first + self.mechanics.bodies.n_links))

    def loaded_results(self, function: Function) -> list[Array]:
        """Return what a function gives under external forces."""
        q, bodies = self.values["q"], self.mechanics.bodies
        forces = self.values["fext"].reshape(-1, 6)
        load = np.zeros(bodies.n_velocities)
        load[: self._first] = forces[0][: self._first]
        for name, force in zip(bodies.link_names, forces[1:], strict=True):
            load += self.mechanics.jacobian(q, name).T @ force
        return self._answer(function, load)

    def _answer(self, function: Function, load: Array) -> list[Array]:
        name = function.name
        if name == "foot_jacobians":
            return [self._foot_jacobian(foot) for foot in function.about]
        if name == "contact_dynamics":
            return self._contact_dynamics(function.about)
        if name.startswith("pose_"):
            return [self._pose(function.about[0], function.about[1])[:3]]
        if len(function.about) == 2:
            return [self._relative_jacobian(*function.about)]
        if name.startswith(("velocity_", "acceleration_")):
            return [self._frame_motion(name, function.about[0])]
        if function.about:
            is_own = name == f"jacobian_{function.about[0]}"
            return [self._jacobian(function.about[0], is_own)]
        if name in ("inverse_dynamics", "inverse_dynamics_actuated", "forward_dynamics"):
            return self._dynamics(name, load)
        return self._by_name(name)

    def _jacobian(self, name: str, is_own: bool) -> Array:
        """Return a Jacobian in the frame's own or in base coordinates."""
        J = self.mechanics.jacobian(self.values["q"], name)
        if is_own:
            return J
        R = self.mechanics.forward_kinematics(self.values["q"])[name][:3, :3]
        return np.concatenate((R @ J[:3], R @ J[3:]))

    def _frame_motion(self, name: str, frame: str) -> Array:
        m, base, (q, qd, qdd) = self.mechanics, self._base, self._joints
        if name == f"velocity_{frame}":
            return m.frame_velocity(q, qd, frame, base)
        if name == f"acceleration_{frame}":
            a0 = self.values["a0"] if base is not None else None
            return m.frame_acceleration(q, qd, qdd, frame, base, a0)
        return m.frame_acceleration_drift(q, qd, frame, base)

    def _contact_dynamics(self, contacts: Sequence[str]) -> list[Array]:
        """Return what contacts give of which some are not active: zeros of these."""
        active = np.flatnonzero(self.values["active"]).tolist()
        q, qd, _ = self._joints
        given = (self.values["tau"], [contacts[k] for k in active], self._base, self.values["g"])
        found = self.mechanics.constrained_forward_dynamics(q, qd, *given)
        forces, size = np.zeros((len(contacts), 3)), 3 * len(contacts)
        forces[active] = found.contact_forces
        Lambda, rows = np.zeros((size, size)), np.flatnonzero(np.repeat(self.values["active"], 3))
        Lambda[np.ix_(rows, rows)] = found.Lambda
        base = [found.base_acceleration] if self._first else []
        return [found.qdd, *base, forces, Lambda]

    def _foot_jacobian(self, name: str) -> Array:
        is_link = name in self.mechanics.bodies.link_names
        support = self._support(f"{LINK_PREFIX}{name}" if is_link else name)
        columns = [self._first + joint - 1 for joint in support[::-1]]
        return self._jacobian(name, is_own=False)[:, columns]

    def _relative_jacobian(self, target: str, base: str) -> Array:
        """Return the columns of the joints between both."""
        J = self._framed.relative_jacobian(self.values["q"], base, target)
        joints = sorted({*self._support(target)} ^ {*self._support(base)})
        return J[:, [self._first + joint - 1 for joint in joints]]

    def _pose(self, target: str, base: str) -> Array:
        """Return `base_T_target`."""
        poses = self._framed.forward_kinematics(self.values["q"])
        relative: Array = np.linalg.inv(poses[base]) @ poses[target]
        return relative

    def _support(self, name: str) -> list[int]:
        bodies = self._framed.bodies
        return bodies.support({frame.name: frame.body for frame in bodies.frames}[name])

    @cached_property
    def _framed(self) -> Mechanics:
        """The mechanism with a frame of each name that a transforms document may have.

        Bodies have numbers for names, which frames take; of equal names the last one counts.
        """
        bodies = self.mechanics.bodies
        joints = zip(bodies.joint_names, bodies.parents, bodies.p_R_j, bodies.p_r_j, strict=True)
        placed = [(f"{LINK_PREFIX}{name}", *place) for name, *place in joints]
        placed += [
            (f"{LINK_PREFIX}{name}", body, np.eye(3), np.zeros(3))
            for body, name in enumerate((bodies.base_name, *bodies.link_names))
        ]
        frames = {name: BodyFrame(name, *place) for name, *place in placed}
        frames |= {frame.name: frame for frame in bodies.frames}
        base, *links = map(str, range(bodies.n_links + 1))
        framed = replace(
            bodies, base_name=base, link_names=tuple(links), frames=tuple(frames.values())
        )
        return Mechanics(framed)

    def _dynamics(self, name: str, load: Array) -> list[Array]:
        """Return forces or accelerations, from `M a + bias = forces + load`."""
        q, qd, g = (self.values[key] for key in ("q", "qd", "g"))
        M = self.mechanics.joint_space_inertia(q)
        rest = self.mechanics.bias_torque(q, qd, self._base, g) - load
        k = self._first
        if name == "forward_dynamics":
            a = solve(M, np.concatenate((np.zeros(k), self.values["tau"])) - rest)
            return [a[k:], a[:k]] if k else [a]
        a0 = self.values["a0"][:k]
        if name == "inverse_dynamics" and k:
            a0 = solve(M[:k, :k], -rest[:k] - M[:k, k:] @ self.values["qdd"])
        forces = M @ np.concatenate((a0, self.values["qdd"])) + rest
        if not k:
            return [forces]
        return [forces[k:], a0 if name == "inverse_dynamics" else forces[:k]]

    def _by_name(self, name: str) -> list[Array]:
        m, base = self.mechanics, self._base
        q, qd, qdd, tau, g = (self.values[key] for key in ("q", "qd", "qdd", "tau", "g"))
        if name == "poses":
            return [np.array([pose[:3] for pose in m.forward_kinematics(q).values()])]
        if name == "inertia_factorization":
            return _factors(m.joint_space_inertia(q))
        a0 = self.values["a0"] if base is not None else None
        arguments: dict[str, tuple[object, ...]] = {
            "joint_space_inertia": (q,),
            "gravity_torque": (q, g),
            "bias_torque": (q, qd, base, g),
            "kinetic_energy": (q, qd, base),
            "potential_energy": (q, g),
            "center_of_mass": (q,),
            "center_of_mass_jacobian": (q,),
            "centroidal_momentum_matrix": (q,),
            "centroidal_momentum_drift": (q, qd, base),
            "joint_space_inertia_inverse": (q,),
            "coriolis_matrix": (q, qd, base),
            "forward_dynamics_derivatives": (q, qd, tau, base, g),
            "inverse_dynamics_derivatives": (q, qd, qdd, base, a0, g),
            "regressor": (q, qd, qdd, base, a0, g),
        }
        found = getattr(m, name)(*arguments[name])
        return [*found] if name.endswith("_derivatives") else [np.atleast_1d(found)]


def _factors(M: Array) -> list[Array]:
    """Return `L` and `D` of `M = L^T D L`, from the last row on."""
    rest, L = M.copy(), np.eye(len(M))
    D = np.zeros(len(M))
    for k in reversed(range(len(M))):
        D[k] = rest[k, k]
        L[k, :k] = rest[k, :k] / D[k]
        rest[:k, :k] -= D[k] * np.outer(L[k, :k], L[k, :k])
    return [L, D]
