"""The same interface as `Mechanics`, computed by compiled code."""

# Signatures in `help` are as short as they are written here.
from __future__ import annotations

import math
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial, wraps
from typing import Any

import numpy as np
import numpy.typing as npt

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.constrained_forward_dynamics import WORST_CONDITION
from kindsl.mechanics.dynamics.evaluation.arguments import JointVector
from kindsl.mechanics.dynamics.evaluation.book import Request, rows_of
from kindsl.mechanics.dynamics.evaluation.kernels import (
    GROUPS,
    Extension,
    Method,
    signature_with_out,
)
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.evaluation.results import ConstrainedMotion, Poses
from kindsl.mechanics.dynamics.evaluation.singular import singular_inertia
from kindsl.mechanics.dynamics.generation.jacobians import feet
from kindsl.mechanics.dynamics.generation.robot import robot_of
from kindsl.mechanics.dynamics.quantities import KEYWORDS, STANDARD_GRAVITY, SingularInertiaError
from kindsl.mechanics.spatial.arrays import Array

# Methods that answer by themselves for float64 arrays of the right shape, by group.
METHODS = {
    "plain": ("inverse_dynamics", "forward_dynamics"),
    "bias": ("gravity_torque", "bias_torque"),
    "masses": (
        "joint_space_inertia", "kinetic_energy", "potential_energy", "center_of_mass",
        "center_of_mass_jacobian",
    ),
    "derivatives": (
        "inverse_dynamics_derivatives", "forward_dynamics_derivatives", "regressor",
    ),
    "control": (
        "centroidal_momentum_matrix", "centroidal_momentum_drift", "joint_space_inertia_inverse",
        "coriolis_matrix",
    ),
}  # fmt: skip
# A thread is worth its start from about so many configurations on.
ROWS_PER_THREAD = 500


class CompiledMechanics(Mechanics):
    """Mechanics compiled for one mechanism.

    Methods take and return what those of `Mechanics` do; those of dynamics and masses also take
    `out`, an array (or a tuple of arrays for several results) that is filled and returned.
    All but poses, inverse and forward dynamics is compiled on its first use.
    """

    def __init__(self, bodies: Bodies, threads: int = 1) -> None:
        """Compile, or find what was compiled before.

        Args:
            threads: How many threads share the work of large batches.

        Raises:
            CompileError: There is no C compiler, or it fails.
            SingularInertiaError: If nothing resists a motion in any configuration.
        """
        super().__init__(bodies)
        self._extensions: dict[str, Extension] = {}
        self._threads = threads
        self._feet = [foot.name for foot in feet(robot_of(bodies))]
        self._forms = _Rows(self, threads)  # type: ignore[assignment]
        try:
            self._pose_entries = self._group("plain").bind("poses")
        except SingularInertiaError:
            raise singular_inertia(bodies, np.zeros(bodies.n_links)) from None
        self._bind("plain")

    def _group(self, group: str) -> Extension:
        """Return the functions of a group, compiled when it is asked for first."""
        if group not in self._extensions:
            # A robot of its own: what is compiled depends on nothing that was recorded before.
            self._extensions[group] = Extension(robot_of(self.bodies), group)
        return self._extensions[group]

    def _bind(self, group: str) -> None:
        """Let compiled functions answer instead of this class's methods."""
        extension = self._group(group)
        batches = group not in ("plain", "bias", "masses") or self._threads == 1
        for name in METHODS[group]:
            method: Method = partial(_general, getattr(Mechanics, name), self)
            if name in extension.kernels:
                method = extension.bind(name, method, batches=batches)
            setattr(self, name, method)

    def forward_kinematics(self, q: JointVector) -> Poses:
        """Return `base_T_x` (..., 4, 4) of each link and frame x by name, links first."""
        entries = self._pose_entries(q)
        if entries is None:
            return super().forward_kinematics(q)
        return Poses(self._pose_indices, entries if entries.ndim == 3 else entries.swapaxes(0, 1))

    def jacobian(self, q: JointVector, name: str) -> Array:
        """Return the geometric Jacobian (..., 6, nv) of a link or frame; see `Mechanics`."""
        answer = self._of_target("jacobians", "jacobian", name, (q,))
        return super().jacobian(q, name) if answer is None else answer

    def constrained_forward_dynamics(
        self,
        q: JointVector,
        qd: JointVector,
        tau: JointVector,
        contacts: Sequence[str],
        base_velocity: npt.ArrayLike | None = None,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
        *,
        is_rigid: bool = False,
    ) -> ConstrainedMotion:
        """Return the accelerations while frames are held; compiled for feet, see `Mechanics`."""
        if not is_rigid and contacts and {*contacts} <= {*self._feet}:
            run = self._group("control").bind("contact_dynamics")
            active = np.array([float(foot in contacts) for foot in self._feet])
            given = gravity if gravity is not STANDARD_GRAVITY else None
            found = run(q, qd, tau, active, base_velocity, given)
            if found is not None and (motion := self._held(found, contacts)) is not None:
                return motion
        return super().constrained_forward_dynamics(
            q, qd, tau, contacts, base_velocity, gravity, is_rigid=is_rigid
        )

    def _held(self, found: tuple[Array, ...], contacts: Sequence[str]) -> ConstrainedMotion | None:
        """Return what concerns contacts of the answer for all feet, None if it is not sound."""
        qdd, *base, forces, Lambda = found
        places = [self._feet.index(name) for name in contacts]
        rows = [3 * place + axis for place in places for axis in range(3)]
        chosen = Lambda[..., rows, :][..., rows]
        if not (np.linalg.cond(chosen) < WORST_CONDITION).all():
            return None
        a0 = base[0] if base else np.zeros((*qdd.shape[:-1], 6))
        return ConstrainedMotion(qdd, a0, forces[..., places, :], chosen)

    def _of_frame(
        self,
        kind: str,
        name: str,
        joints: Sequence[JointVector],
        base: Sequence[npt.ArrayLike | None],
    ) -> Array:
        answer = self._of_target("frame_motions", kind, name, (*joints, *base))
        return super()._of_frame(kind, name, joints, base) if answer is None else answer

    def _of_target(
        self, group: str, kind: str, name: str, arguments: Sequence[object]
    ) -> Array | None:
        """Return what a kernel of a link or frame answers, None where Python has to look."""
        number = self._pose_indices.get(name)
        if number is None:
            return None
        answer: Array | None = self._group(group).bind(f"{kind}_{number}")(*arguments)
        return answer


class _Rows:
    """Answers questions of any shape: one row a configuration, shared by threads."""

    def __init__(self, owner: CompiledMechanics, threads: int) -> None:
        self.at_rest: dict[str, Method] = {}
        self._owner = owner
        self._threads = threads

    def evaluate(self, request: Request) -> Array:
        """Return a quantity's entries in one row per configuration, shape (..., entries)."""
        has_load = not request.vectors.keys().isdisjoint(("a0", "fext"))
        name = f"{request.function}_loaded" if has_load else request.function
        group = next(group for group, names in GROUPS.items() if request.function in names)
        extension = self._owner._group("loads" if has_load else group)
        kernel = extension.kernels[name]
        given = {KEYWORDS.get(key, key): vector for key, vector in request.vectors.items()}
        nothing = np.zeros(6 * (self._owner.n_joints + 1))
        given["external_forces"] = given.pop("fext", nothing)
        size = math.prod(request.batch_shape)
        rows = [
            _in_rows(given[argument.name], request.batch_shape) if argument.components else None
            for argument in kernel.arguments
        ]
        rows[0] = np.ascontiguousarray(rows_of(given["q"], request.batch_shape))
        outs = tuple(np.empty((size, *result.shape)) for result in kernel.results)
        _run_in_threads(extension.bind(name, _refuse), rows, outs, self._threads)
        entries = np.concatenate(
            [out.reshape((size, math.prod(out.shape[1:]))) for out in outs], axis=1
        )
        return entries.reshape((*request.batch_shape, entries.shape[-1]))


def _in_rows(vector: Array, batch_shape: tuple[int, ...]) -> Array:
    """Return one vector for all, or one row a configuration."""
    return np.ascontiguousarray(vector if vector.ndim == 1 else rows_of(vector, batch_shape))


def _run_in_threads(
    run: Method, rows: list[Array | None], outs: tuple[Array, ...], threads: int
) -> None:
    size = len(outs[0])
    parts = max(1, min(threads, size // ROWS_PER_THREAD))
    edges = [size * k // parts for k in range(parts + 1)]

    def part(k: int) -> None:
        chosen = slice(edges[k], edges[k + 1])
        given = [row[chosen] if row is not None and row.ndim == 2 else row for row in rows]
        results = tuple(out[chosen] for out in outs)
        run(*given, out=results if len(results) > 1 else results[0])

    if parts == 1:
        part(0)
        return
    with ThreadPoolExecutor(parts) as pool:
        list(pool.map(part, range(parts)))


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


def _refuse(*_: object, **__: object) -> None:
    # What Python has checked is only refused for results that are not finite.
    raise ZeroDivisionError


def _compiled_when_called(group: str, name: str) -> Method:
    """Return a method that compiles its group on its first call, and asks what takes its place."""

    @wraps(getattr(Mechanics, name))
    def method(self: CompiledMechanics, *arguments: Any, **named: Any) -> Any:
        if name not in vars(self):
            self._bind(group)
        return vars(self)[name](*arguments, **named)

    method.__signature__ = signature_with_out(getattr(Mechanics, name))  # type: ignore[attr-defined]
    return method


for _group, _names in METHODS.items():
    for _name in _names:
        setattr(CompiledMechanics, _name, _compiled_when_called(_group, _name))
