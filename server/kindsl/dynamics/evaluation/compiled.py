"""The same interface as `Mechanics`, computed by compiled code."""

# Signatures in `help` are as short as they are written here.
from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from kindsl.dynamics.bodies import Bodies
from kindsl.dynamics.constrained_forward_dynamics import WORST_CONDITION
from kindsl.dynamics.evaluation.arguments import JointVector
from kindsl.dynamics.evaluation.compiling import compiled_module
from kindsl.dynamics.evaluation.kernels import RESULT_CLASSES, kernels_of
from kindsl.dynamics.evaluation.mechanics import Mechanics
from kindsl.dynamics.evaluation.request import Request
from kindsl.dynamics.evaluation.results import ConstrainedMotion, Poses
from kindsl.dynamics.evaluation.singular import singular_inertia
from kindsl.dynamics.evaluation.whole_body import WholeBody
from kindsl.dynamics.generation.emitters.extension import MODULE, extension_source
from kindsl.dynamics.generation.jacobians import feet
from kindsl.dynamics.generation.robot import Robot, robot_of
from kindsl.dynamics.quantities import STANDARD_GRAVITY, SingularInertiaError
from kindsl.spatial.arrays import Array

Method = Callable[..., Any]
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
# A thread is worth its start from about so many configurations on.
ROWS_PER_THREAD = 500


class CompiledMechanics(Mechanics):
    """Mechanics compiled for one mechanism.

    Methods take and return what those of `Mechanics` do; those of dynamics and masses also take
    `out`, an array (or a tuple of arrays for several results) that is filled and returned.
    Derivatives, and what controllers of the whole body need, are compiled on their first use.
    """

    __slots__ = ("_extension", "_feet", "_jacobians", "_later", "_pose_entries", "_threads",
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
        self._threads = threads
        try:
            self._extension = _Extension(robot, "plain")
        except SingularInertiaError:
            raise singular_inertia(bodies, np.zeros(bodies.n_links)) from None
        self._generated = _Forms(self)  # type: ignore[assignment]
        self._forms = self._generated  # type: ignore[assignment]
        for name in DIRECT:
            if name in self._extension.names:
                general = partial(_general, getattr(Mechanics, name), self)
                setattr(self, name, self._extension.bind(name, general, threads == 1))
            else:
                setattr(self, name, partial(getattr(Mechanics, name), self))
        self._feet = [foot.name for foot in feet(robot)]
        self._later: dict[str, _Extension] = {}
        for group, names in LATER.items():
            for name in names:
                setattr(self, name, partial(_first_call, self, group, name))
        self._pose_entries = self._extension.bind("poses", _not_direct, True)
        self._jacobians = {
            name: self._extension.bind(f"jacobian_{number}", _not_direct, True)
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

    def frame_velocity(
        self,
        q: JointVector,
        qd: JointVector,
        name: str,
        base_velocity: npt.ArrayLike | None = None,
    ) -> Array:
        """Return the velocity (..., 6) of a link or frame; see `Mechanics`."""
        answer = self._of_frame("velocity", name, q, qd, base_velocity)
        return super().frame_velocity(q, qd, name, base_velocity) if answer is None else answer

    def frame_acceleration(
        self,
        q: JointVector,
        qd: JointVector,
        qdd: JointVector,
        name: str,
        base_velocity: npt.ArrayLike | None = None,
        base_acceleration: npt.ArrayLike | None = None,
    ) -> Array:
        """Return the acceleration (..., 6) of a link or frame; see `Mechanics`."""
        given = (q, qd, qdd, base_velocity, base_acceleration)
        answer = self._of_frame("acceleration", name, *given)
        if answer is not None:
            return answer
        return super().frame_acceleration(q, qd, qdd, name, base_velocity, base_acceleration)

    def frame_acceleration_drift(
        self,
        q: JointVector,
        qd: JointVector,
        name: str,
        base_velocity: npt.ArrayLike | None = None,
    ) -> Array:
        """Return the acceleration (..., 6) at zero acceleration; see `Mechanics`."""
        answer = self._of_frame("acceleration_drift", name, q, qd, base_velocity)
        if answer is not None:
            return answer
        return super().frame_acceleration_drift(q, qd, name, base_velocity)

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
            run = self._compiled_later("control").bind("contact_dynamics", _not_direct, True)
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

    def _of_frame(self, kind: str, name: str, *arguments: object) -> Array | None:
        """Return what compiled code tells of a frame, None if Python should look."""
        number = self._pose_indices.get(name)
        if number is None:
            return None
        extension = self._compiled_later("frame_motions")
        answer: Array | None = extension.bind(f"{kind}_{number}", _not_direct, True)(*arguments)
        return answer

    def _compiled_later(self, group: str) -> _Extension:
        if group not in self._later:
            # A robot of its own: what is compiled depends on nothing that was recorded before.
            self._later[group] = _Extension(robot_of(self.bodies), group)
        return self._later[group]


class _Extension:
    """A compiled module and the names in it."""

    def __init__(self, robot: Robot, group: str) -> None:
        kernels = kernels_of(robot, group)
        self.names = frozenset(kernel.name for kernel in kernels)
        self.shapes = {
            kernel.name: [result.shape for result in kernel.results] for kernel in kernels
        }
        source = extension_source(robot.graph, kernels, STANDARD_GRAVITY)
        self._module = compiled_module(MODULE, source)

    def bind(self, name: str, general: Method, batches: bool) -> Method:
        """Return a compiled function that calls `general` for what it does not take."""
        bound: Method = self._module.bind(name, general, RESULT_CLASSES.get(name), batches)
        return bound


class _Forms:
    """The forms for questions that a compiled function does not answer directly."""

    def __init__(self, owner: CompiledMechanics) -> None:
        self.at_rest: dict[str, Method] = {}
        self.pose_entries = None
        self._extension = owner._extension
        self._threads = owner._threads
        self._is_floating = owner.bodies.is_floating

    def evaluate(self, request: Request) -> Array:
        """Return a quantity's entries in one row per configuration, shape (..., entries)."""
        name = request.quantity
        vectors = [*request.joint_vectors]
        has_base = name in ("inverse_dynamics", "forward_dynamics", "bias_torque")
        if has_base and self._is_floating:
            vectors.append(request.base_velocity)
        if name not in ("poses", "joint_space_inertia"):
            vectors.append(request.gravity)
        size = math.prod(request.batch_shape)
        rows = [_rows(vector, request.batch_shape, size) for vector in vectors]
        rows[0] = np.ascontiguousarray(np.broadcast_to(rows[0], (size, rows[0].shape[-1])))
        run = self._extension.bind(name, _refuse, True)
        if has_base and not self._is_floating:
            run = partial(_at_fixed_base, run)
        shapes = self._extension.shapes[name]
        outs = tuple(np.empty((size, *shape)) for shape in shapes)
        _run_in_threads(run, rows, outs, self._threads)
        entries = np.concatenate([out.reshape((size, -1)) for out in outs], axis=1)
        return entries.reshape((*request.batch_shape, entries.shape[-1]))


def _at_fixed_base(run: Method, *arguments: Array, out: object) -> object:
    *joints, gravity = arguments
    return run(*joints, None, gravity, out=out)


def _run_in_threads(run: Method, rows: list[Array], outs: tuple[Array, ...], threads: int) -> None:
    size = len(outs[0])
    parts = max(1, min(threads, size // ROWS_PER_THREAD))
    edges = [size * k // parts for k in range(parts + 1)]

    def part(k: int) -> None:
        chosen = slice(edges[k], edges[k + 1])
        given = [row[chosen] if row.ndim == 2 else row for row in rows]
        results = tuple(out[chosen] for out in outs)
        run(*given, out=results if len(results) > 1 else results[0])

    if parts == 1:
        part(0)
        return
    with ThreadPoolExecutor(parts) as pool:
        list(pool.map(part, range(parts)))


def _rows(vector: Array, batch_shape: tuple[int, ...], size: int) -> Array:
    """Return one vector for all, or one row a configuration."""
    if vector.ndim == 1:
        return np.ascontiguousarray(vector)
    full = np.broadcast_to(vector, (*batch_shape, vector.shape[-1]))
    return np.ascontiguousarray(full.reshape((size, vector.shape[-1])))


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
    extension = owner._compiled_later(group)
    for each in LATER[group]:
        method: Method = partial(_general, getattr(WholeBody, each), owner)
        if each in extension.names:
            method = extension.bind(each, method, True)
        setattr(owner, each, method)
    return getattr(owner, name)(*arguments, **named)


def _not_direct(*_: object, **__: object) -> None:
    """Tell that Python has to look at the arguments."""


def _refuse(*_: object, **__: object) -> None:
    # What Python has checked is only refused for results that are not finite.
    raise ZeroDivisionError
