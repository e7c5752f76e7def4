"""Motions of frames and contacts, computed by compiled code."""

# Signatures in `help` are as short as they are written here.
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.constrained_forward_dynamics import WORST_CONDITION
from kindsl.mechanics.dynamics.evaluation.arguments import JointVector
from kindsl.mechanics.dynamics.evaluation.extension import Extension, not_direct
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.dynamics.evaluation.results import ConstrainedMotion
from kindsl.mechanics.dynamics.generation.jacobians import feet
from kindsl.mechanics.dynamics.generation.robot import robot_of
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY
from kindsl.mechanics.spatial.arrays import Array


class CompiledWholeBody(Mechanics):
    """The methods about frames; each group is compiled on its first use."""

    __slots__ = ("_feet", "_later")

    def __init__(self, bodies: Bodies) -> None:
        """Compile nothing yet."""
        super().__init__(bodies)
        self._feet = [foot.name for foot in feet(robot_of(bodies))]
        self._later: dict[str, Extension] = {}

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

    def _of_frame(
        self,
        kind: str,
        name: str,
        joints: Sequence[JointVector],
        base: Sequence[npt.ArrayLike | None],
    ) -> Array:
        number = self._pose_indices.get(name)
        if number is not None:
            extension = self.compiled_later("frame_motions")
            run = extension.bind(f"{kind}_{number}", not_direct, True)
            answer: Array | None = run(*joints, *base)
            if answer is not None:
                return answer
        return super()._of_frame(kind, name, joints, base)

    def compiled_later(self, group: str) -> Extension:
        """Return the functions of a group, compiled when it is asked for first."""
        if group not in self._later:
            # A robot of its own: what is compiled depends on nothing that was recorded before.
            self._later[group] = Extension(robot_of(self.bodies), group)
        return self._later[group]
