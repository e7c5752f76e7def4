"""The one interface to all quantities of a mechanism."""

# Signatures in `help` are as short as they are written here.
from __future__ import annotations

import numpy as np
import numpy.typing as npt

from kindsl.mechanics.dynamics import center_of_mass as masses
from kindsl.mechanics.dynamics import energy
from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.arguments import (
    JointVector,
    check_mass,
    checked,
    common_batch_shape,
    placed_frame,
    vectors,
)
from kindsl.mechanics.dynamics.evaluation.book import Request
from kindsl.mechanics.dynamics.evaluation.forms import Forms
from kindsl.mechanics.dynamics.evaluation.results import (
    ActuatedTorque,
    FloatingConfiguration,
    FreeMotion,
    FreeMotionTorque,
    Poses,
)
from kindsl.mechanics.dynamics.evaluation.singular import not_finite, too_large
from kindsl.mechanics.dynamics.evaluation.whole_body import AT_REST, GRAVITY, WholeBody
from kindsl.mechanics.dynamics.forward_kinematics import joint_poses
from kindsl.mechanics.dynamics.jacobian import jacobian, relative_jacobian
from kindsl.mechanics.dynamics.quantities import (
    ACCELERATING,
    JOINT_VECTORS,
    KEYWORDS,
    STANDARD_GRAVITY,
    Quantity,
    SingularInertiaError,
)
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.exponential import pose_array, pose_of_motion

# The names that generated functions have for arguments.
IN_CODE = {keyword: name for name, keyword in KEYWORDS.items()} | {"external_forces": "fext"}
# What ready code raises if it is not there yet, or for arguments that need a closer look.
NOT_READY = (
    AttributeError, KeyError, OverflowError, TypeError, ValueError, ZeroDivisionError,
)  # fmt: skip


class Mechanics(WholeBody):
    """Kinematics and dynamics of a tree of bodies.

    Leading dimensions of all arguments are batches and broadcast. What concerns joints is in the
    order of the links, or a mapping by their names, in which those that are zero may be missing.
    All vectors are in base coordinates, and gravity is to be given so too. A floating base adds six
    rows before the joints', angular then linear. Results of large batches are views whose memory
    runs along the batch.

    All methods raise ValueError for arguments of a wrong shape or with values that are not finite.
    """

    __slots__ = ("_forms", "_pose_indices", "bodies")

    def __init__(self, bodies: Bodies, *, generates_code: bool = True) -> None:
        """Take over a tree of bodies.

        Args:
            bodies: The tree.
            generates_code: Whether to write code for it, which takes ten times as long as a few
                answers do without, and answers ten times sooner from then on.
        """
        self.bodies = bodies
        self._forms = Forms(bodies, generates_code=generates_code)
        names = (*bodies.link_names, *(frame.name for frame in bodies.frames))
        self._pose_indices = {name: index for index, name in enumerate(names)}

    @property
    def joint_names(self) -> tuple[str, ...]:
        """The joints, in the order of all joint vectors."""
        return self.bodies.joint_names

    @property
    def link_names(self) -> tuple[str, ...]:
        """The links; each joint supports the link of the same index."""
        return self.bodies.link_names

    @property
    def n_joints(self) -> int:
        """Number of joints."""
        return self.bodies.n_links

    def forward_kinematics(self, q: JointVector) -> Poses:
        """Return `base_T_x` (..., 4, 4) of each link and frame x by name, links first."""
        poses = self._poses(q)
        n = poses.ndim - 3
        return Poses(self._pose_indices, poses.transpose((n, *range(n), n + 1, n + 2)))

    def joint_poses(self, q: JointVector) -> dict[str, Array]:
        """Return `base_T_j` (..., 4, 4) of each joint frame j by the joint's name.

        The joint turns about, or slides along, the z axis.
        """
        poses = joint_poses(self.bodies, self._body_poses(q))
        return dict(zip(self.bodies.joint_names, np.moveaxis(poses, -3, 0), strict=True))

    def jacobian(self, q: JointVector, name: str) -> Array:
        """Return the geometric Jacobian (..., 6, nv) of a link or frame.

        It gives the velocity relative to the world in that frame's orientation, at its origin.

        Raises:
            ValueError: If there is no such link or frame.
        """
        body, body_T_frame = placed_frame(self.bodies, name)
        poses = self._body_poses(q)
        return jacobian(self.bodies, poses, body, poses[..., body, :, :] @ body_T_frame)

    def relative_jacobian(self, q: JointVector, base: str, target: str) -> Array:
        """Return the Jacobian (..., 6, nv) of one link or frame relative to another.

        It gives the velocity of the target's origin as the base sees it, in the base's coordinates;
        only the joints between both have columns that are not zero.

        Raises:
            ValueError: If there is no such link or frame.
        """
        poses, placed = self._body_poses(q), []
        for name in (base, target):
            body, body_T_frame = placed_frame(self.bodies, name)
            placed.append((body, poses[..., body, :, :] @ body_T_frame))
        return relative_jacobian(self.bodies, poses, *placed)

    def center_of_mass(self, q: JointVector) -> Array:
        """Return the centre of mass of all that moves, shape (..., 3), metres.

        A floating base moves; the mass of a fixed one counts nowhere.

        Raises:
            ValueError: If the total mass is zero.
        """
        check_mass(self.bodies)
        return masses.center_of_mass(self.bodies, self._body_poses(q))

    def center_of_mass_jacobian(self, q: JointVector) -> Array:
        """Return the Jacobian (..., 3, nv) of the centre of mass.

        Raises:
            ValueError: If the total mass is zero.
        """
        check_mass(self.bodies)
        return masses.center_of_mass_jacobian(self.bodies, self._body_poses(q))

    def total_mass(self) -> float:
        """Return the mass of all that moves, a floating base included, kg."""
        return float(np.sum(self.bodies.masses))

    def subtree_masses(self) -> dict[str, float]:
        """Return each body's mass with all that it carries by the body's name, kg, base first."""
        names = (self.bodies.base_name, *self.bodies.link_names)
        return dict(zip(names, masses.subtree_masses(self.bodies).tolist(), strict=True))

    def joint_space_inertia(self, q: JointVector) -> Array:
        """Return the joint-space inertia (..., nv, nv)."""
        entries = self._evaluate("joint_space_inertia", (q,))
        nv = self.bodies.n_velocities
        return entries.reshape((*entries.shape[:-1], nv, nv))

    def inverse_dynamics(
        self,
        q: JointVector,
        qd: JointVector,
        qdd: JointVector,
        base_velocity: npt.ArrayLike | None = None,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
        *,
        external_forces: npt.ArrayLike | None = None,
        base_acceleration: npt.ArrayLike | None = None,
    ) -> Array | FreeMotionTorque | ActuatedTorque:
        """Return the joint forces that a motion takes.

        Args:
            q: Joint positions, shape (..., n), radians and metres.
            qd: Joint velocities, shape (..., n).
            qdd: Joint accelerations, shape (..., n).
            base_velocity: Of a floating base, shape (..., 6); None is rest.
            gravity: Shape (..., 3), m/s^2.
            external_forces: The wrench on each body, the base's first, moment then force about the
                body's origin in its own coordinates, shape (..., n + 1, 6).
            base_acceleration: Of a floating base, spatial, shape (..., 6); None where it moves
                freely.

        Returns:
            With a fixed base `tau` (..., n), N m and N; with a floating base
            `(tau, base_acceleration)` of free motion, or `(tau, base_wrench)` for a given
            acceleration.

        Raises:
            SingularInertiaError: If nothing resists a freely floating base's motion.
        """
        loads = base_acceleration, external_forces
        entries = self._evaluate("inverse_dynamics", (q, qd, qdd), base_velocity, gravity, *loads)
        if not self.bodies.is_floating:
            return entries
        kind = FreeMotionTorque if base_acceleration is None else ActuatedTorque
        return kind(entries[..., :-6], entries[..., -6:])

    def forward_dynamics(
        self,
        q: JointVector,
        qd: JointVector,
        tau: JointVector,
        base_velocity: npt.ArrayLike | None = None,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
        *,
        external_forces: npt.ArrayLike | None = None,
    ) -> Array | FreeMotion:
        """Return the accelerations under joint forces.

        Args:
            q: Joint positions, shape (..., n), radians and metres.
            qd: Joint velocities, shape (..., n).
            tau: Joint forces, shape (..., n), N m and N.
            base_velocity: Of a floating base, shape (..., 6); None is rest.
            gravity: Shape (..., 3), m/s^2.
            external_forces: The wrench on each body, see `inverse_dynamics`.

        Returns:
            With a fixed base `qdd` (..., n); with a floating base always
            `(qdd, base_acceleration)`.

        Raises:
            SingularInertiaError: If nothing resists a motion.
        """
        entries = self._evaluate(
            "forward_dynamics", (q, qd, tau), base_velocity, gravity, None, external_forces
        )
        if not self.bodies.is_floating:
            return entries
        return FreeMotion(entries[..., :-6], entries[..., -6:])

    def gravity_torque(self, q: JointVector, gravity: npt.ArrayLike = STANDARD_GRAVITY) -> Array:
        """Return the forces (..., nv) that hold the mechanism at rest."""
        return self._evaluate("gravity_torque", (q,), None, gravity)

    def bias_torque(
        self,
        q: JointVector,
        qd: JointVector,
        base_velocity: npt.ArrayLike | None = None,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
    ) -> Array:
        """Return the forces (..., nv) at zero acceleration, gravity's included."""
        return self._evaluate("bias_torque", (q, qd), base_velocity, gravity)

    def kinetic_energy(
        self, q: JointVector, qd: JointVector, base_velocity: npt.ArrayLike | None = None
    ) -> Array:
        """Return the kinetic energy (...), joule."""
        q, qd, v, _ = self._motion({"q": q, "qd": qd}, {"base_velocity": base_velocity})
        return energy.kinetic_energy(self.bodies, q, qd, v)

    def potential_energy(self, q: JointVector, gravity: npt.ArrayLike = STANDARD_GRAVITY) -> Array:
        """Return the potential energy (...), joule, zero for all mass at the base's origin."""
        q, g = self._motion({"q": q}, gravity=gravity)
        return energy.potential_energy(self.bodies, self._body_poses(q), g)

    def integrate(
        self,
        q: JointVector,
        qd: JointVector,
        dt: float,
        base_pose: npt.ArrayLike | None = None,
        base_velocity: npt.ArrayLike | None = None,
    ) -> Array | FloatingConfiguration:
        """Return the configuration after moving at constant velocities for a time.

        Args:
            q: Joint positions, shape (..., n), radians and metres.
            qd: Joint velocities, shape (..., n).
            dt: The time, s.
            base_pose: Of a floating base in the world, shape (..., 4, 4); None is the world's.
            base_velocity: Of a floating base, in its moving coordinates, shape (..., 6).

        Returns:
            With a fixed base `q` (..., n); with a floating base always `(q, base_pose)`, so that
            `kindsl.pose_error` of both base poses is `dt * base_velocity`.
        """
        given = checked(self.bodies, {"q": q, "qd": qd}, {"base_velocity": base_velocity})
        (dt,) = vectors("dt", [dt], 1).tolist()
        if base_pose is not None and not self.bodies.is_floating:
            raise ValueError("'base_pose' is given, but the base is fixed")
        pose = pose_array("base_pose", np.eye(4) if base_pose is None else base_pose)
        entries = pose.reshape((*pose.shape[:-2], 16))
        shape = common_batch_shape(given | {"base_pose": entries})
        moved = np.zeros((*shape, self.n_joints)) + given["q"] + dt * given["qd"]
        if not self.bodies.is_floating:
            return moved
        step = pose_of_motion(dt * given.get("base_velocity", AT_REST))
        return FloatingConfiguration(moved, np.zeros((*shape, 4, 4)) + pose @ step)

    def _evaluate(
        self,
        quantity: Quantity,
        joint_vectors: tuple[JointVector, ...],
        base_velocity: npt.ArrayLike | None = None,
        gravity: npt.ArrayLike = STANDARD_GRAVITY,
        base_acceleration: npt.ArrayLike | None = None,
        external_forces: npt.ArrayLike | None = None,
    ) -> Array:
        is_plain = base_acceleration is None and external_forces is None
        if base_velocity is None and gravity is STANDARD_GRAVITY and is_plain:
            # A single answer if code is ready and nothing is wrong, without a slow check.
            try:
                return self._forms.at_rest[quantity](*joint_vectors)
            except NOT_READY:
                pass
        names = JOINT_VECTORS[quantity]
        base = {"base_velocity": base_velocity, "base_acceleration": base_acceleration}
        joints = dict(zip(names, joint_vectors, strict=True))
        given = checked(self.bodies, joints, base, gravity, external_forces)
        arrays = {name: given[name] for name in names}
        vectors = {"v0": AT_REST, "g": GRAVITY} | {IN_CODE.get(k, k): x for k, x in given.items()}
        function = f"{quantity}_actuated" if "a0" in vectors else quantity
        request = Request(function, common_batch_shape(given), vectors)
        try:
            with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
                entries = self._forms.evaluate(request)
        except (SingularInertiaError, ZeroDivisionError, np.linalg.LinAlgError):
            raise not_finite(self.bodies, arrays) from None
        except OverflowError:
            raise too_large(arrays) from None
        if quantity in ACCELERATING and not np.isfinite(entries).all():
            raise not_finite(self.bodies, arrays)
        return entries

    def _poses(self, q: JointVector) -> Array:
        """Return `base_T_x` (..., poses, 4, 4) of the links, then of the frames."""
        entries = self._evaluate("poses", (q,))
        return entries.reshape((*entries.shape[:-1], entries.shape[-1] // 16, 4, 4))

    def _body_poses(self, q: JointVector) -> Array:
        """Return `base_T_body` (..., n + 1, 4, 4), the base first."""
        named = self._poses(q)
        poses = np.empty((*named.shape[:-3], self.bodies.n_links + 1, 4, 4))
        poses[..., 0, :, :] = np.eye(4)
        poses[..., 1:, :, :] = named[..., : self.bodies.n_links, :, :]
        return poses
