"""Expected results of generated functions, from the mechanics that this program itself uses.

Not from the book's NumPy: its sines differ in the last digit between processors, so that two
machines would generate two files.
"""

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
from kindsl.mechanics.dynamics.quantities import KEYWORDS
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


# Beside what is held best. The condition of what forces are solved with is its inverse squared, and
# more by the inertia: 1e6 for the feet and fingers of two humanoids, 1e7 with 1e-3, 1e9 with 1e-6.
_NEARLY_HELD = 1e-2


def independent_contacts(mechanics: Mechanics, q: Array, contacts: Sequence[str]) -> Array:
    """Return one for each contact that holds what those before it do not hold, zero for others."""
    active, held = np.zeros(len(contacts)), np.zeros((0, mechanics.bodies.n_velocities))
    for number, name in enumerate(contacts):
        rows = np.concatenate((held, mechanics.jacobian(q, name)[3:]))
        strengths = np.linalg.svd(rows, compute_uv=False)
        if len(strengths) == len(rows) and strengths[-1] > _NEARLY_HELD * strengths[0]:
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
        self._first = mechanics.bodies.n_velocities - mechanics.bodies.n_links

    def results(self, function: Function) -> list[Array]:
        """Return what a function gives without external forces, one array a result."""
        name, about = function.name, function.about
        if name == "foot_jacobians":
            return [self._foot_jacobian(foot) for foot in about]
        if name == "contact_dynamics":
            return self._contact_dynamics(about)
        if name.startswith("pose_"):
            return [self._pose(about[0], about[1])[:3]]
        if len(about) == 2:
            return [self._relative_jacobian(*about)]
        if name.startswith("jacobian_"):
            return [self._jacobian(about[0], is_own=name == f"jacobian_{about[0]}")]
        if name == "poses":
            poses = self.mechanics.forward_kinematics(self.values["q"])
            return [np.array([pose[:3] for pose in poses.values()])]
        if name == "inertia_factorization":
            return _factors(self.mechanics.joint_space_inertia(self.values["q"]))
        if about:
            kind = name.removesuffix(f"_{about[0]}")
            return self._answer(f"frame_{kind}", function, name=about[0])
        return self._answer(name.removesuffix("_actuated"), function)

    def loaded_results(self, function: Function) -> list[Array]:
        """Return what a function gives under external forces."""
        method, wrenches = function.name.removesuffix("_actuated"), self.values["fext"]
        return self._answer(method, function, external_forces=wrenches.reshape(-1, 6))

    def _answer(self, method: str, function: Function, **others: Array | str) -> list[Array]:
        """Return what a method gives for a function's arguments and others."""
        names = (argument.name for argument in function.arguments)
        given = {KEYWORDS.get(name, name): self.values[name] for name in names}
        found = getattr(self.mechanics, method)(**given, **others)
        return [*found] if isinstance(found, tuple) else [np.atleast_1d(found)]

    def _jacobian(self, name: str, is_own: bool) -> Array:
        """Return a Jacobian in the frame's own or in base coordinates."""
        J = self.mechanics.jacobian(self.values["q"], name)
        if is_own:
            return J
        R = self.mechanics.forward_kinematics(self.values["q"])[name][:3, :3]
        return np.concatenate((R @ J[:3], R @ J[3:]))

    def _contact_dynamics(self, contacts: Sequence[str]) -> list[Array]:
        """Return what contacts give of which some are not active: zeros of these."""
        active = np.flatnonzero(self.values["active"]).tolist()
        q, qd, tau, g = (self.values[name] for name in ("q", "qd", "tau", "g"))
        given = [contacts[k] for k in active], self.values["v0"] if self._first else None, g
        found = self.mechanics.constrained_forward_dynamics(q, qd, tau, *given)
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


def _factors(M: Array) -> list[Array]:
    """Return `L` and `D` of `M = L^T D L`, from the last row on."""
    rest, L = M.copy(), np.eye(len(M))
    D = np.zeros(len(M))
    for k in reversed(range(len(M))):
        D[k] = rest[k, k]
        L[k, :k] = rest[k, :k] / D[k]
        rest[:k, :k] -= D[k] * np.outer(L[k, :k], L[k, :k])
    return [L, D]
