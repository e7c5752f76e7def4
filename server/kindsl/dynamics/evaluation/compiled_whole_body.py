"""Motions of frames and contacts, computed by compiled code."""

# Signatures in `help` are as short as they are written here.
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from kindsl.dynamics.bodies import Bodies
from kindsl.dynamics.constrained_forward_dynamics import WORST_CONDITION
from kindsl.dynamics.evaluation.arguments import JointVector
from kindsl.dynamics.evaluation.extension import Extension, not_direct
from kindsl.dynamics.evaluation.mechanics import Mechanics
from kindsl.dynamics.evaluation.results import ConstrainedMotion
from kindsl.dynamics.generation.jacobians import feet
from kindsl.dynamics.generation.robot import robot_of
from kindsl.dynamics.quantities import STANDARD_GRAVITY
from kindsl.spatial.arrays import Array


class CompiledWholeBody(Mechanics):
    """The methods about frames; each group is compiled on its first use."""

    __slots__ = ("_feet", "_later")

    def __init__(self, bodies: Bodies) -> None:
        """Compile nothing yet."""
        super().__init__(bodies)
        self._feet = [foot.name for foot in feet(robot_of(bodies))]
        self._later: dict[str, Extension] = {}

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
            run = self.compiled_later("control").bind("contact_dynamics", not_direct, True)
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
        extension = self.compiled_later("frame_motions")
        answer: Array | None = extension.bind(f"{kind}_{number}", not_direct, True)(*arguments)
        return answer

    def compiled_later(self, group: str) -> Extension:
        """Return the functions of a group, compiled when it is asked for first."""
        if group not in self._later:
            # A robot of its own: what is compiled depends on nothing that was recorded before.
            self._later[group] = Extension(robot_of(self.bodies), group)
        return self._later[group]
