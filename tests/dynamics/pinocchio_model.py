"""The same mechanism and quantities in pinocchio, in our order: angular part first."""

import numpy as np
import pinocchio as pin

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.inertia import point_inertia

ANGULAR_FIRST = [3, 4, 5, 0, 1, 2]


class PinocchioModel:
    """Evaluates one configuration at a time."""

    def __init__(self, bodies: Bodies, gravity: Array) -> None:
        self.bodies = bodies
        self.model = pin.Model()
        self.model.gravity.linear = gravity
        root = 0
        if bodies.is_floating:
            root = self.model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "root")
            self.model.appendBodyToJoint(root, self._inertia(0), pin.SE3.Identity())
        joints = {0: root}
        depth_first = _depth_first(bodies)
        for link in depth_first:
            parent = bodies.parents[link - 1]
            is_revolute = bodies.joint_kinds[link - 1] == "revolute"
            joint = pin.JointModelRZ() if is_revolute else pin.JointModelPZ()
            placement = pin.SE3(bodies.p_R_j[link - 1], bodies.p_r_j[link - 1])
            name = bodies.joint_names[link - 1]
            joints[link] = self.model.addJoint(joints[parent], joint, placement, name)
            self.model.appendBodyToJoint(joints[link], self._inertia(link), pin.SE3.Identity())
        self._joints = joints
        for frame in bodies.frames:
            placement = pin.SE3(frame.body_R_frame, frame.body_r_frame)
            added = pin.Frame(frame.name, joints[frame.body], 0, placement, pin.FrameType.OP_FRAME)
            self.model.addFrame(added)
        self.data = self.model.createData()
        first = 6 if bodies.is_floating else 0
        # Where each of our velocities is among pinocchio's, and the reverse for joints.
        places = [first + depth_first.index(link) for link, _ in bodies.links()]
        self.order = [*ANGULAR_FIRST[:first], *places]
        self._joint_order = [link - 1 for link in depth_first]
        # pinocchio knows rotors; friction is added here.
        if bodies.drives is not None:
            self.model.armature = self.v_of(np.zeros(6), bodies.drives.armature)

    def poses(self, q: Array) -> dict[str, Array]:
        pin.framesForwardKinematics(self.model, self.data, self.q_of(q))
        poses = {
            name: self.data.oMi[self._joints[joint]].homogeneous
            for joint, name in enumerate(self.bodies.link_names, start=1)
        }
        for frame in self.bodies.frames:
            poses[frame.name] = self.data.oMf[self.model.getFrameId(frame.name)].homogeneous
        return poses

    def frame_jacobian(self, q: Array, name: str) -> Array:
        frame = self.model.getFrameId(name)
        J = pin.computeFrameJacobian(self.model, self.data, self.q_of(q), frame, pin.LOCAL)
        return np.reshape(J, (6, -1))[ANGULAR_FIRST][:, self.order]

    def joint_space_inertia(self, q: Array) -> Array:
        M = self._symmetric(pin.crba(self.model, self.data, self.q_of(q)))
        return M[np.ix_(self.order, self.order)]

    def bias_torque(self, q: Array, qd: Array, base_velocity: Array) -> Array:
        v = self.v_of(base_velocity, qd)
        bias = pin.nonLinearEffects(self.model, self.data, self.q_of(q), v)[self.order]
        return bias + np.concatenate((np.zeros(len(bias) - len(qd)), self._friction(qd)))

    def inverse_dynamics(
        self, q: Array, qd: Array, qdd: Array, base_velocity: Array
    ) -> tuple[Array, Array]:
        """Return joint forces and base acceleration (zero for a fixed base)."""
        first = len(self.order) - len(q)
        M, bias = self.joint_space_inertia(q), self.bias_torque(q, qd, base_velocity)
        wrench = bias[:first] + M[:first, first:] @ qdd
        base_acceleration = -np.linalg.solve(M[:first, :first], wrench) if first else np.zeros(6)
        a = self.v_of(base_acceleration, qdd)
        v = self.v_of(base_velocity, qd)
        tau = pin.rnea(self.model, self.data, self.q_of(q), v, a)[self.order][first:]
        return tau + self._friction(qd), base_acceleration

    def forward_dynamics(
        self, q: Array, qd: Array, tau: Array, base_velocity: Array
    ) -> tuple[Array, Array]:
        v, force = (self.v_of(base_velocity, qd), self.v_of(np.zeros(6), tau - self._friction(qd)))
        a = pin.aba(self.model, self.data, self.q_of(q), v, force)[self.order]
        first = len(self.order) - len(q)
        return a[first:], a[:first] if first else np.zeros(6)

    def center_of_mass(self, q: Array) -> Array:
        """Return that of the moving bodies only if the base is fixed."""
        return pin.centerOfMass(self.model, self.data, self.q_of(q)).copy()

    def center_of_mass_jacobian(self, q: Array) -> Array:
        return pin.jacobianCenterOfMass(self.model, self.data, self.q_of(q))[:, self.order]

    def kinetic_energy(self, q: Array, qd: Array, base_velocity: Array) -> float:
        v = self.v_of(base_velocity, qd)
        return float(pin.computeKineticEnergy(self.model, self.data, self.q_of(q), v))

    def _friction(self, qd: Array) -> Array:
        drives = self.bodies.drives
        return drives.force(qd, 0.0 * qd) if drives is not None else 0.0 * qd

    def centroidal_momentum_matrix(self, q: Array) -> Array:
        A = pin.computeCentroidalMap(self.model, self.data, self.q_of(q))
        return np.reshape(A, (6, -1))[ANGULAR_FIRST][:, self.order]

    def centroidal_momentum_drift(self, q: Array, qd: Array, base_velocity: Array) -> Array:
        v = self.v_of(base_velocity, qd)
        rate = np.reshape(pin.dccrba(self.model, self.data, self.q_of(q), v), (6, -1)) @ v
        return rate[ANGULAR_FIRST]

    def frame_motion(
        self, q: Array, qd: Array, qdd: Array, v0: Array, a0: Array, name: str
    ) -> tuple[Array, Array]:
        """Return velocity and acceleration of a frame's origin, in its own coordinates."""
        v, a = self.v_of(v0, qd), self.v_of(a0, qdd)
        pin.forwardKinematics(self.model, self.data, self.q_of(q), v, a)
        pin.updateFramePlacements(self.model, self.data)
        frame = self.model.getFrameId(name)
        asked = (self.model, self.data, frame, pin.LOCAL)
        motions = (pin.getFrameVelocity(*asked), pin.getFrameClassicalAcceleration(*asked))
        velocity, acceleration = (motion.vector[ANGULAR_FIRST] for motion in motions)
        return velocity, acceleration

    def joint_space_inertia_inverse(self, q: Array) -> Array:
        n = len(self.order)
        found = pin.computeMinverse(self.model, self.data, self.q_of(q))
        inverse = self._symmetric(np.reshape(found, (n, n)))
        return inverse[np.ix_(self.order, self.order)]

    def coriolis_matrix(self, q: Array, qd: Array, base_velocity: Array) -> Array:
        v = self.v_of(base_velocity, qd)
        C = pin.computeCoriolisMatrix(self.model, self.data, self.q_of(q), v)
        return np.reshape(C, (len(v), -1))[np.ix_(self.order, self.order)]

    def constrained_forward_dynamics(
        self, q: Array, qd: Array, tau: Array, base_velocity: Array, names: list[str], rows: slice
    ) -> tuple[Array, Array, Array]:
        """Return accelerations, the base's first, what acts on frames, and their inertia."""
        v, force = (self.v_of(base_velocity, qd), self.v_of(np.zeros(6), tau - self._friction(qd)))
        jacobians, drifts = [], []
        for name in names:
            _, drift = self.frame_motion(q, qd, 0.0 * qd, base_velocity, np.zeros(6), name)
            frame = self.model.getFrameId(name)
            R = self.data.oMf[frame].rotation
            turned = np.kron(np.eye(2), R)
            J = pin.computeFrameJacobian(self.model, self.data, self.q_of(q), frame, pin.LOCAL)
            jacobians.append((turned @ np.reshape(J, (6, -1))[ANGULAR_FIRST])[rows])
            drifts.append((turned @ drift)[rows])
        J, drift = np.concatenate(jacobians), np.concatenate(drifts)
        a = pin.forwardDynamics(self.model, self.data, self.q_of(q), v, force, J, drift, 0.0)
        forces = self.data.lambda_c.copy()
        M_inverse = np.linalg.inv(self._symmetric(pin.crba(self.model, self.data, self.q_of(q))))
        return a[self.order], forces, np.linalg.inv(J @ M_inverse @ J.T)

    @staticmethod
    def _symmetric(M: Array) -> Array:
        upper = np.triu(M)
        return upper + np.triu(upper, 1).T

    def _inertia(self, body: int) -> pin.Inertia:
        mass, com = self.bodies.masses[body], self.bodies.coms[body]
        return pin.Inertia(mass, com, self.bodies.inertias[body] - point_inertia(mass, com))

    def q_of(self, q: Array) -> Array:
        base = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0] if self.bodies.is_floating else []
        return np.concatenate((base, q[self._joint_order]))

    def v_of(self, base: Array, joints: Array) -> Array:
        ordered = joints[self._joint_order]
        return (
            np.concatenate((base[ANGULAR_FIRST], ordered)) if self.bodies.is_floating else ordered
        )


def _depth_first(bodies: Bodies) -> list[int]:
    """Return the links in the order that pinocchio's algorithms rely on."""
    order: list[int] = []
    waiting = [0]
    while waiting:
        body = waiting.pop()
        waiting += [link for link, parent in bodies.links() if parent == body]
        order += [body] if body else []
    return order
