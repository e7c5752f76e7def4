"""Inverse kinematics by Gauss-Newton: joint positions at which the hook has a given pose."""

import numpy as np

import kindsl

robot = kindsl.load("crane.kindsl").mechanism()
goal = robot.forward_kinematics([0.4, 0.7, 0.3])["hook"]
q = np.array([0.0, 0.5, 0.2])
for step in range(50):
    error = kindsl.pose_error(robot.forward_kinematics(q)["hook"], goal)
    print(step, f"{np.linalg.norm(error):.1e}")
    if np.linalg.norm(error) < 1e-9:
        break
    velocity = np.linalg.lstsq(robot.jacobian(q, "hook"), error, rcond=None)[0]
    q = robot.integrate(q, velocity, 1.0)
print(q.round(9))
