"""Derivatives, and quantities that controllers of the whole body ask for, as methods."""

# Signatures in `help` are as short as they are written here.
from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.centroidal_momentum import (
    centroidal_momentum_drift,
    centroidal_momentum_matrix,
)
from kindsl.mechanics.dynamics.constrained_forward_dynamics import constrained_forward_dynamics
from kindsl.mechanics.dynamics.coriolis_matrix import coriolis_matrix
from kindsl.mechanics.dynamics.evaluation.arguments import (
    NOTHING,
    JointVector,
    check_mass,
    checked,
    common_batch_shape,
    placed_frame,
)
from kindsl.mechanics.dynamics.evaluation.results import ConstrainedMotion
from kindsl.mechanics.dynamics.evaluation.singular import not_finite, singular_inertia
from kindsl.mechanics.dynamics.forward_dynamics_derivatives import (
    ForwardDynamicsDerivatives,
    forward_dynamics_derivatives,
)
from kindsl.mechanics.dynamics.frame_motion import frame_motion
from kindsl.mechanics.dynamics.inverse_dynamics import newton_euler
from kindsl.mechanics.dynamics.inverse_dynamics_derivatives import (
    InverseDynamicsDerivatives,
    inverse_dynamics_derivatives,
)
from kindsl.mechanics.dynamics.jacobian import jacobian
from kindsl.mechanics.dynamics.joint_space_inertia import inertia_of, joint_space_inertia
from kindsl.mechanics.dynamics.joints import uniform_acceleration
from kindsl.mechanics.dynamics.posture import Posture, posture
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY
from kindsl.mechanics.dynamics.regressor import inertial_parameters, regressor
from kindsl.mechanics.spatial.arrays import Array

AT_REST, GRAVITY = np.zeros(6), np.array(STANDARD_GRAVITY)


class WholeBody:
    """Derivatives, momentum, motions of frames, contacts: what `Mechanics` has for controllers.

    In derivatives a floating base adds six rows, the wrench on it or its spatial acceleration, and
    six columns before the joints': small turns, then shifts of the base about its own axes (only
    gravity feels the turns, nothing the shifts), and changes of its velocity, acceleration or
    wrench. All are in base coordinates, which move with the base: velocities and accelerations of
    the base keep their components while it is displaced. Accelerations of frames have that of the
    origin as a point, in the frame's coordinates.
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
        q, qd, qdd, v, a, g = self._motion({"q": q, "qd": qd, "qdd": qdd}, base, gravity)
        return regressor(self.bodies, q, qd, qdd, v, a - uniform_acceleration(g))

    def inertial_parameters(self) -> Array:
        """Return the inertial parameters that the regressor multiplies, ten a moving body.

        Mass, mass times centre of mass, then the entries xx, xy, yy, xz, yz, zz of the inertia
        tensor about the body's origin; a floating base's first.
        """
        return inertial_parameters(self.bodies)

    def _motion(
        self,
        joints: Mapping[str, JointVector],
        base: Mapping[str, npt.ArrayLike | None] = NOTHING,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
    ) -> list[Array]:
        """Return all arguments checked, with one batch shape."""
        given = checked(self.bodies, joints, base, gravity)
        shape = common_batch_shape(given)
        standard = {**dict.fromkeys(base, AT_REST), "gravity": GRAVITY}
        arrays = [{**standard, **given}[name] for name in (*joints, *standard)]
        return [np.broadcast_to(a, (*shape, a.shape[-1])) for a in arrays]

    def centroidal_momentum_matrix(self, q: JointVector) -> Array:
        """Return `A` (..., 6, nv), with the momentum about the CoM `A @ (base velocity, qd)`.

        The angular part comes first, in base coordinates, N m s and N s.

        Raises:
            ValueError: If the total mass is zero.
        """
        check_mass(self.bodies)
        q, _ = self._motion({"q": q})
        return centroidal_momentum_matrix(self.bodies, q)

    def centroidal_momentum_drift(
        self, q: JointVector, qd: JointVector, base_velocity: npt.ArrayLike | None = None
    ) -> Array:
        """Return the rate (..., 6) of momentum about the CoM at zero acceleration.

        The rate under accelerations is `centroidal_momentum_matrix(q) @ a` more.

        Raises:
            ValueError: If the total mass is zero.
        """
        check_mass(self.bodies)
        q, qd, v, _ = self._motion({"q": q, "qd": qd}, {"base_velocity": base_velocity})
        return centroidal_momentum_drift(self.bodies, q, qd, v)

    def frame_velocity(
        self, q: JointVector, qd: JointVector, name: str, base_velocity: npt.ArrayLike | None = None
    ) -> Array:
        """Return the velocity (..., 6) of a link or frame: `jacobian @ (base velocity, qd)`.

        It is relative to the world, in the frame's own coordinates, at its origin.

        Raises:
            ValueError: If there is no such link or frame.
        """
        return self._of_frame("velocity", name, (q, qd), (base_velocity,))

    def frame_acceleration(
        self,
        q: JointVector,
        qd: JointVector,
        qdd: JointVector,
        name: str,
        base_velocity: npt.ArrayLike | None = None,
        base_acceleration: npt.ArrayLike | None = None,
    ) -> Array:
        """Return the acceleration (..., 6) of a link or frame.

        It is `jacobian @ (base acceleration, qdd) + frame_acceleration_drift`: angular acceleration
        and that of its origin, relative to the world, in the frame's own coordinates.

        Raises:
            ValueError: If there is no such link or frame.
        """
        base = (base_velocity, base_acceleration)
        return self._of_frame("acceleration", name, (q, qd, qdd), base)

    def frame_acceleration_drift(
        self, q: JointVector, qd: JointVector, name: str, base_velocity: npt.ArrayLike | None = None
    ) -> Array:
        """Return the acceleration (..., 6) of a link or frame at zero acceleration: `Jd qd`.

        Raises:
            ValueError: If there is no such link or frame.
        """
        return self._of_frame("acceleration_drift", name, (q, qd), (base_velocity,))

    def joint_space_inertia_inverse(self, q: JointVector) -> Array:
        """Return the inverse (..., nv, nv) of the joint-space inertia.

        Raises:
            SingularInertiaError: If nothing resists a motion.
        """
        q, _ = self._motion({"q": q})
        try:
            inverse = np.linalg.inv(joint_space_inertia(self.bodies, q))
        except np.linalg.LinAlgError:
            raise singular_inertia(self.bodies, q) from None
        if not np.isfinite(inverse).all():
            raise not_finite(self.bodies, {"q": q})
        return np.asarray(inverse, dtype=np.float64)

    def coriolis_matrix(
        self, q: JointVector, qd: JointVector, base_velocity: npt.ArrayLike | None = None
    ) -> Array:
        """Return `C` (..., nv, nv), with the bias torque `C @ (base velocity, qd)` and gravity's.

        `C + C.T` is the rate of the joint-space inertia. Friction of joints is not in `C`.
        """
        q, qd, v, _ = self._motion({"q": q, "qd": qd}, {"base_velocity": base_velocity})
        return coriolis_matrix(self.bodies, q, qd, v)

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
        """Return the accelerations under joint forces while frames are held.

        The origins of the frames do not accelerate; where they are to stay, velocities must be such
        that they do not move.

        Args:
            q: Joint positions, shape (..., n), radians and metres.
            qd: Joint velocities, shape (..., n).
            tau: Joint forces, shape (..., n), N m and N.
            contacts: The k links or frames that are held.
            base_velocity: Of a floating base, shape (..., 6); None is rest.
            gravity: Shape (..., 3), m/s^2.
            is_rigid: Whether the frames may not turn either.

        Raises:
            SingularInertiaError: If nothing resists a motion.
            ValueError: If there is no such link or frame, or contacts hold the same motion.
        """
        joints, base = {"q": q, "qd": qd, "tau": tau}, {"base_velocity": base_velocity}
        q, qd, tau, v, g = self._motion(joints, base, gravity)
        first = self.bodies.n_velocities - self.bodies.n_links
        state, rest = posture(self.bodies, q), np.zeros_like(qd)
        bias = newton_euler(state, qd, rest, v, -uniform_acceleration(g))
        forces = np.concatenate((np.zeros((*tau.shape[:-1], first)), tau), axis=-1) - bias
        rows = slice(0 if is_rigid else 3, 6)
        J, drift = self._contacts(contacts, state, qd, v, rows)
        try:
            with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
                found = constrained_forward_dynamics(inertia_of(state), forces, J, drift)
        except np.linalg.LinAlgError:
            raise singular_inertia(self.bodies, q) from None
        a, along, Lambda = found
        if not np.isfinite(a).all():
            raise not_finite(self.bodies, {"q": q, "qd": qd, "tau": tau})
        base_acceleration = a[..., :first] if first else np.zeros((*q.shape[:-1], 6))
        shape = (*q.shape[:-1], len(contacts), rows.stop - rows.start)
        return ConstrainedMotion(a[..., first:], base_acceleration, along.reshape(shape), Lambda)

    def _contacts(
        self, names: Sequence[str], state: Posture, qd: Array, v: Array, rows: slice
    ) -> tuple[Array, Array]:
        """Return the frames' Jacobian and drift in base coordinates, one below the other."""
        rest, batch = np.zeros_like(qd), qd.shape[:-1]
        jacobians, drifts = [], []
        for name in names:
            body, body_T_frame = placed_frame(self.bodies, name)
            base_T_frame = state.poses[..., body, :, :] @ body_T_frame
            _, drift = frame_motion(state, qd, rest, v, np.zeros(6), body, body_T_frame)
            turned = np.zeros((*batch, 6, 6))
            turned[..., :3, :3] = turned[..., 3:, 3:] = base_T_frame[..., :3, :3]
            J = turned @ jacobian(self.bodies, state.poses, body, base_T_frame)
            jacobians.append(J[..., rows, :])
            drifts.append((turned @ drift[..., None])[..., rows, 0])
        if not jacobians:
            return np.zeros((*batch, 0, self.bodies.n_velocities)), np.zeros((*batch, 0))
        return np.concatenate(jacobians, axis=-2), np.concatenate(drifts, axis=-1)

    def _of_frame(
        self,
        kind: str,
        name: str,
        joints: Sequence[JointVector],
        base: Sequence[npt.ArrayLike | None],
    ) -> Array:
        """Return the velocity, the acceleration or its drift of a frame.

        Args:
            kind: `velocity`, `acceleration` or `acceleration_drift`.
            name: The link or frame.
            joints: Joint positions, velocities and, for `acceleration`, accelerations.
            base: Velocity and, for `acceleration`, acceleration of a floating base.
        """
        q, qd, qdd, v, a, _ = self._motion(
            dict(zip(("q", "qd", "qdd"), (*joints, {}), strict=False)),
            dict(zip(("base_velocity", "base_acceleration"), (*base, None), strict=False)),
        )
        body, body_T_frame = placed_frame(self.bodies, name)
        state = posture(self.bodies, q)
        velocity, acceleration = frame_motion(state, qd, qdd, v, a, body, body_T_frame)
        return velocity if kind == "velocity" else acceleration
