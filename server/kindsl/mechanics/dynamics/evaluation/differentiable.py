"""Derivatives of the dynamics, and the regressor, as methods."""

# Signatures in `help` are as short as they are written here.
from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.arguments import (
    JointVector,
    checked,
    common_batch_shape,
)
from kindsl.mechanics.dynamics.evaluation.singular import not_finite, singular_inertia
from kindsl.mechanics.dynamics.forward_dynamics_derivatives import (
    ForwardDynamicsDerivatives,
    forward_dynamics_derivatives,
)
from kindsl.mechanics.dynamics.inverse_dynamics_derivatives import (
    InverseDynamicsDerivatives,
    inverse_dynamics_derivatives,
)
from kindsl.mechanics.dynamics.posture import posture
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY
from kindsl.mechanics.dynamics.regressor import inertial_parameters, regressor
from kindsl.mechanics.spatial.arrays import Array

AT_REST, GRAVITY = np.zeros(6), np.array(STANDARD_GRAVITY)


class Differentiable:
    """Derivatives of the quantities of `Mechanics`.

    A floating base adds six rows, the wrench on it or its spatial acceleration, and six columns
    before the joints': small turns, then shifts of the base about its own axes (only gravity feels
    the turns, nothing the shifts), and changes of its velocity, acceleration or wrench. All are in
    base coordinates, which move with the base: velocities and accelerations of the base keep their
    components while it is displaced.
    """

    __slots__ = ()

    bodies: Bodies

    def inverse_dynamics_derivatives(
        self,
        q: JointVector,
        qd: JointVector,
        qdd: JointVector,
        base_velocity: npt.ArrayLike | None = None,
        base_acceleration: npt.ArrayLike | None = None,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
    ) -> InverseDynamicsDerivatives:
        """Return what the forces of a given motion change by, three arrays (..., nv, nv).

        Args:
            q: Joint positions, shape (..., n), radians and metres.
            qd: Joint velocities, shape (..., n).
            qdd: Joint accelerations, shape (..., n).
            base_velocity: Of a floating base, shape (..., 6); None is rest.
            base_acceleration: Of a floating base, spatial, shape (..., 6); None is zero.
            gravity: Shape (..., 3), m/s^2.
        """
        base = {"base_velocity": base_velocity, "base_acceleration": base_acceleration}
        arrays = self._motion({"q": q, "qd": qd, "qdd": qdd}, base, gravity)
        return inverse_dynamics_derivatives(posture(self.bodies, arrays[0]), *arrays[1:])

    def forward_dynamics_derivatives(
        self,
        q: JointVector,
        qd: JointVector,
        tau: JointVector,
        base_velocity: npt.ArrayLike | None = None,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
    ) -> ForwardDynamicsDerivatives:
        """Return what accelerations under given forces change by, three arrays (..., nv, nv).

        Args:
            q: Joint positions, shape (..., n), radians and metres.
            qd: Joint velocities, shape (..., n).
            tau: Joint forces, shape (..., n), N m and N.
            base_velocity: Of a floating base, shape (..., 6); None is rest.
            gravity: Shape (..., 3), m/s^2.

        Raises:
            SingularInertiaError: If nothing resists a motion.
        """
        joints = {"q": q, "qd": qd, "tau": tau}
        arrays = self._motion(joints, {"base_velocity": base_velocity}, gravity)
        try:
            with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
                derivatives = forward_dynamics_derivatives(self.bodies, *arrays)
        except np.linalg.LinAlgError:
            raise singular_inertia(self.bodies, arrays[0]) from None
        if not all(np.isfinite(entries).all() for entries in derivatives):
            raise not_finite(self.bodies, dict(zip(joints, arrays, strict=False)))
        return derivatives

    def regressor(
        self,
        q: JointVector,
        qd: JointVector,
        qdd: JointVector,
        base_velocity: npt.ArrayLike | None = None,
        base_acceleration: npt.ArrayLike | None = None,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
    ) -> Array:
        """Return `Y` (..., nv, 10 k), with the forces of a motion `Y @ inertial_parameters()`.

        Arguments are those of `inverse_dynamics_derivatives`; k is the number of moving bodies.
        The forces are those of the bodies, without rotors and friction of joints.
        """
        base = {"base_velocity": base_velocity, "base_acceleration": base_acceleration}
        joints = {"q": q, "qd": qd, "qdd": qdd}
        q, qd, qdd, base_velocity, base_acceleration, g = self._motion(joints, base, gravity)
        relative = base_acceleration.copy()
        relative[..., 3:] -= g
        return regressor(self.bodies, q, qd, qdd, base_velocity, relative)

    def inertial_parameters(self) -> Array:
        """Return the inertial parameters that the regressor multiplies, ten a moving body.

        Mass, mass times centre of mass, then the entries xx, xy, yy, xz, yz, zz of the inertia
        tensor about the body's origin; a floating base's first.
        """
        return inertial_parameters(self.bodies)

    def _motion(
        self,
        joints: Mapping[str, JointVector],
        base: Mapping[str, npt.ArrayLike | None],
        gravity: npt.ArrayLike,
    ) -> list[Array]:
        """Return all arguments checked, with one batch shape."""
        given = checked(self.bodies, joints, base, gravity)
        shape = common_batch_shape(given)
        standard = {**dict.fromkeys(base, AT_REST), "gravity": GRAVITY}
        arrays = [{**standard, **given}[name] for name in (*joints, *standard)]
        return [np.broadcast_to(a, (*shape, a.shape[-1])) for a in arrays]
