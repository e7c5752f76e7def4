"""Writes the reference documents of our own and pinocchio's numbers for them.

Usage: python -m tests.dynamics.write_reference
"""

import json
from pathlib import Path
from typing import Any

import numpy as np
from tests.dynamics.pinocchio_model import PinocchioModel
from tests.dynamics.reference_robots import Robot, bodies, document, random_robot

FOLDER = Path(__file__).parents[1] / "fixtures" / "reference"
ROBOTS = (
    random_robot("gantry", 11, 7, is_floating=False),
    random_robot("crawler", 12, 9, is_floating=True),
    random_robot("tower", 19, 14, is_floating=False),
)
GRAVITY = np.array([0.0, 0.0, -9.81])


def reference(robot: Robot) -> dict[str, Any]:
    """Return the numbers of a robot at rest at zero and in two random motions."""
    numbers = bodies(robot)
    model = PinocchioModel(numbers, GRAVITY)
    generator = np.random.default_rng(len(robot.parts))
    zero = np.zeros((3, numbers.n_links))
    motions = [zero, *generator.uniform(-1.0, 1.0, (2, 3, numbers.n_links))]
    bases = [np.zeros(6), *generator.uniform(-1.0, 1.0, (2, 6))]
    cases = [
        _case(model, robot, *motion, base) for motion, base in zip(motions, bases, strict=True)
    ]
    return {
        "source": f"{robot.name}.kindsl",
        "floating": robot.is_floating,
        "configurations": cases,
    }


def main() -> None:
    """Write a document and its numbers for each robot."""
    for robot in ROBOTS:
        (FOLDER / f"{robot.name}.kindsl").write_text(document(robot), encoding="utf-8")
        text = json.dumps(reference(robot), indent=1)
        (FOLDER / f"{robot.name}.json").write_text(text + "\n", encoding="utf-8")


def _case(
    model: PinocchioModel,
    robot: Robot,
    q: np.ndarray,
    qd: np.ndarray,
    qdd: np.ndarray,
    base_velocity: np.ndarray,
) -> dict[str, Any]:
    base_velocity = base_velocity * robot.is_floating
    links = model.bodies.link_names
    poses = {name: pose.tolist() for name, pose in model.poses(q).items()}
    tau, base_acceleration = model.inverse_dynamics(q, qd, qdd, base_velocity)
    return {
        "q": q.tolist(),
        "qd": qd.tolist(),
        "qdd": qdd.tolist(),
        "base_vel": base_velocity.tolist() if robot.is_floating else None,
        "base_acc": base_acceleration.tolist() if robot.is_floating else None,
        "poses": {name: pose for name, pose in poses.items() if name in links},
        "frame_poses": {name: pose for name, pose in poses.items() if name not in links},
        "M": model.joint_space_inertia(q).tolist(),
        "tau": tau.tolist(),
        "gravity_torque": model.bias_torque(q, 0.0 * q, np.zeros(6)).tolist(),
        "bias": model.bias_torque(q, qd, base_velocity).tolist(),
    }


if __name__ == "__main__":
    main()
