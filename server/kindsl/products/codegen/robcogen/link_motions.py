"""The motions of links that inverse dynamics was asked for, computed when a getter asks."""

from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.engines import parameters
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

# The statements that keep a motion for the getters.
KEEP_MOTION = """\
        q_v = unaligned(q);
        qd_v = unaligned(qd);
        isVelocityKnown = false;
        asked = MOTION;
"""

_STATE = template("robcogen/link_motions_state.h")
_PASSES = template("robcogen/link_motions.h")
_GETTERS = template("robcogen/link_getters.h")

_BASE_GETTER = """\
    const Force& getForce_@NAME@() const
    {
        bringForces();
        return forces[@ID@];
    }
"""


def getters(robot: GeneratedRobot) -> str:
    """Return the functions that tell velocities, accelerations and forces."""
    ids = robot.body_ids
    texts = [robot.filled(_BASE_GETTER, NAME=robot.bodies[0], ID=ids[0])] * robot.is_floating
    texts += [robot.filled(_GETTERS, NAME=robot.bodies[i], ID=ids[i]) for i in robot.tree.links()]
    return "".join(texts)


def link_motions(robot: GeneratedRobot) -> str:
    """Return the functions behind the getters and the members that they read."""
    kinds = robot.tree.kinds
    axes = (f"iit::rbd::{'AZ' if k == 'revolute' else 'LZ'}" for k in kinds)
    *first, last = robot.inertial_bodies
    inertia = "".join(f"        case {i}: return {_tensor(robot, i)};\n" for i in first)
    return robot.filled(
        _PASSES + _STATE,
        PARAMETERS=parameters(robot),
        PARENTS=", ".join(map(str, robot.tree.parents)),
        AXES=", ".join(axes),
        INERTIA=f"{inertia}        default: return {_tensor(robot, last)};\n",
        FIRST=robot.inertial_bodies[0],
    )


def _tensor(robot: GeneratedRobot, body: int) -> str:
    return f"inertiaProps->getTensor_{robot.bodies[body]}()"
