"""Forward dynamics of the random trees with a fixed base gives MuJoCo's numbers."""

from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest
from tests.dynamics.random_bodies import tree_of_seed
from tests.support.amount import usually

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanics.spatial.arrays import Array
from kindsl.mechanics.spatial.inertia import point_inertia

# MuJoCo stores inertia by principal axes, which costs a few digits; orders of magnitude remain.
TOLERANCE = 1e-8


@pytest.mark.parametrize("block", range(5))
def test_random_trees_accelerate_as_in_mujoco(block: int) -> None:
    for seed in range(60 * block, 60 * block + 60, usually(10, thoroughly=2)):
        bodies, generator = tree_of_seed(seed)
        assert not bodies.is_floating
        q, qd, tau = generator.uniform(-2.0, 2.0, (3, bodies.n_links))
        qdd = Mechanics(bodies).forward_dynamics(q, qd, tau)
        expected = _accelerations(bodies, q, qd, tau)
        error = abs(qdd - expected).max() / max(1.0, abs(expected).max())
        assert error < TOLERANCE, f"seed {seed}: {error:.1e}"


def _accelerations(bodies: Bodies, q: Array, qd: Array, tau: Array) -> Array:
    model = mujoco.MjModel.from_xml_string(_mjcf(bodies))
    data = mujoco.MjData(model)
    joints = [model.joint(name) for name in bodies.joint_names]
    positions = [joint.qposadr[0] for joint in joints]
    velocities = [joint.dofadr[0] for joint in joints]
    data.qpos[positions] = q
    data.qvel[velocities] = qd
    data.qfrc_applied[velocities] = tau
    mujoco.mj_forward(model, data)
    return data.qacc[velocities].copy()


def _mjcf(bodies: Bodies) -> str:
    root = ElementTree.Element("mujoco")
    ElementTree.SubElement(root, "compiler", angle="radian", balanceinertia="false")
    option = ElementTree.SubElement(root, "option", gravity="0 0 -9.81")
    ElementTree.SubElement(option, "flag", contact="disable", constraint="disable")
    elements = [ElementTree.SubElement(root, "worldbody")]
    for link, parent in bodies.links():
        quaternion = np.zeros(4)
        mujoco.mju_mat2Quat(quaternion, bodies.p_R_j[link - 1].ravel())
        element = ElementTree.SubElement(
            elements[parent], "body", pos=_text(bodies.p_r_j[link - 1]), quat=_text(quaternion)
        )
        kind = "hinge" if bodies.joint_kinds[link - 1] == "revolute" else "slide"
        name = bodies.joint_names[link - 1]
        ElementTree.SubElement(element, "joint", name=name, type=kind, axis="0 0 1")
        mass, com = bodies.masses[link], bodies.coms[link]
        I = bodies.inertias[link] - point_inertia(mass, com)  # noqa: E741
        moments = np.array([I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[0, 2], I[1, 2]])
        ElementTree.SubElement(
            element, "inertial", pos=_text(com), mass=repr(float(mass)), fullinertia=_text(moments)
        )
        elements.append(element)
    return ElementTree.tostring(root, encoding="unicode")


def _text(values: Array) -> str:
    return " ".join(map(repr, values.tolist()))
