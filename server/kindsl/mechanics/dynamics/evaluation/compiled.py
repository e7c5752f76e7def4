"""The same interface as `Mechanics`, computed by compiled code."""

# Signatures in `help` are as short as they are written here.
from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.arguments import JointVector
from kindsl.mechanics.dynamics.evaluation.compiled_whole_body import CompiledWholeBody
from kindsl.mechanics.dynamics.evaluation.extension import Extension, Method, not_direct
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.evaluation.results import Poses
from kindsl.mechanics.dynamics.evaluation.row_forms import RowForms
from kindsl.mechanics.dynamics.evaluation.singular import singular_inertia
from kindsl.mechanics.dynamics.evaluation.whole_body import WholeBody
from kindsl.mechanics.dynamics.generation.robot import robot_of
from kindsl.mechanics.dynamics.quantities import SingularInertiaError
from kindsl.mechanics.spatial.arrays import Array

# Methods that answer by themselves for float64 arrays of the right shape.
DIRECT = (
    "joint_space_inertia", "inverse_dynamics", "forward_dynamics", "gravity_torque", "bias_torque",
    "kinetic_energy", "potential_energy", "center_of_mass", "center_of_mass_jacobian",
)  # fmt: skip
# The methods that are compiled on their first use, by group.
LATER = {
    "derivatives": (
        "inverse_dynamics_derivatives", "forward_dynamics_derivatives", "regressor",
    ),
    "control": (
        "centroidal_momentum_matrix", "centroidal_momentum_drift", "joint_space_inertia_inverse",
        "coriolis_matrix",
    ),
}  # fmt: skip
LATER_METHODS = tuple(name for names in LATER.values() for name in names)


class CompiledMechanics(CompiledWholeBody):
    """Mechanics compiled for one mechanism.

    Methods take and return what those of `Mechanics` do; those of dynamics and masses also take
    `out`, an array (or a tuple of arrays for several results) that is filled and returned.
    Derivatives, and what controllers of the whole body need, are compiled on their first use.
    """

    __slots__ = ("_extension", "_jacobians", "_pose_entries",
                 *DIRECT, *LATER_METHODS)  # fmt: skip

    def __init__(self, bodies: Bodies, threads: int = 1) -> None:
        """Compile, or find what was compiled before.

        Args:
            bodies: The mechanism.
            threads: How many threads share the work of large batches.

        Raises:
            CompileError: There is no C compiler, or it fails.
            SingularInertiaError: If nothing resists a motion in any configuration.
        """
        super().__init__(bodies)
        robot = robot_of(bodies)
        try:
            self._extension = Extension(robot, "plain")
        except SingularInertiaError:
            raise singular_inertia(bodies, np.zeros(bodies.n_links)) from None
        self._generated = RowForms(self._extension, bodies.is_floating, threads)  # type: ignore[assignment]
        self._forms = self._generated  # type: ignore[assignment]
        for name in DIRECT:
            if name in self._extension.names:
                general = partial(_general, getattr(Mechanics, name), self)
                setattr(self, name, self._extension.bind(name, general, threads == 1))
            else:
                setattr(self, name, partial(getattr(Mechanics, name), self))
        for group, names in LATER.items():
            for name in names:
                setattr(self, name, partial(_first_call, self, group, name))
        self._pose_entries = self._extension.bind("poses", not_direct, True)
        self._jacobians = {
            name: self._extension.bind(f"jacobian_{number}", not_direct, True)
            for number, name in enumerate(self._pose_indices)
        }

    def forward_kinematics(self, q: JointVector) -> Poses:
        """Return `base_T_x` (..., 4, 4) of each link and frame x by name, links first."""
        entries = self._pose_entries(q)
        if entries is None:
            return super().forward_kinematics(q)
        return Poses(self._pose_indices, entries if entries.ndim == 3 else entries.swapaxes(0, 1))

    def jacobian(self, q: JointVector, name: str) -> Array:
        """Return the geometric Jacobian (..., 6, nv) of a link or frame; see `Mechanics`."""
        compiled = self._jacobians.get(name)
        answer: Array | None = compiled(q) if compiled is not None else None
        if answer is not None:
            return answer
        return super().jacobian(q, name)


def _general(method: Method, owner: Mechanics, *arguments: Any, **named: Any) -> Any:
    """Answer in Python, for arguments of any shape; with a clear error for wrong ones."""
    out = named.pop("out", None)
    answer = method(owner, *arguments, **named)
    if out is None:
        return answer
    pairs = zip(answer, out, strict=True) if isinstance(answer, tuple) else [(answer, out)]
    for values, place in pairs:
        if np.shape(place) != np.shape(values):
            raise ValueError(f"'out' has shape {np.shape(place)}, expected {np.shape(values)}")
        place[...] = values
    return out


def _first_call(
    owner: CompiledMechanics, group: str, name: str, *arguments: Any, **named: Any
) -> Any:
    """Answer by compiled code, which takes this function's place, and is made if it is not there.

    Who asked for the method before that keeps this function.
    """
    extension = owner.compiled_later(group)
    for each in LATER[group]:
        method: Method = partial(_general, getattr(WholeBody, each), owner)
        if each in extension.names:
            method = extension.bind(each, method, True)
        setattr(owner, each, method)
    return getattr(owner, name)(*arguments, **named)
