"""LQR at a pose: torques that hold the crane where it is, and bring it back from nearby."""

import numpy as np

import kindsl

robot = kindsl.load("crane.kindsl").mechanism()
pose, rest, dt = np.array([0.0, 0.5, 0.2]), np.zeros(3), 0.01
holding = robot.gravity_torque(pose)
by_q, by_qd, by_tau = robot.forward_dynamics_derivatives(pose, rest, holding)

# One step of semi-implicit Euler, linear about the pose: first the velocities, then the positions.
one = np.eye(3)
velocities = np.hstack((dt * by_q, one + dt * by_qd))
A = np.vstack((np.hstack((one, 0.0 * one)) + dt * velocities, velocities))
B = np.vstack((dt * dt * by_tau, dt * by_tau))

# The discrete Riccati equation, by going back in time until the cost no longer changes.
P = Q = np.diag([100.0] * 3 + [1.0] * 3)
for _ in range(2000):
    K = np.linalg.solve(1.0 * one + B.T @ P @ B, B.T @ P @ A)
    P = Q + A.T @ P @ (A - B @ K)

q, qd = pose + np.array([0.3, -0.2, 0.1]), rest
for step in range(301):
    if step % 100 == 0:
        print(f"{step * dt:.0f} s: {np.abs(q - pose).max():.4f}")
    tau = holding - K @ np.concatenate((q - pose, qd))
    qd = qd + dt * robot.forward_dynamics(q, qd, tau)
    q = robot.integrate(q, qd, dt)
