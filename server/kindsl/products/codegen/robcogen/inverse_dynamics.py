"""`inverse_dynamics.h` and `inverse_dynamics.impl.h`."""

from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.engines import Engine, engine_headers, parameters
from kindsl.products.codegen.robcogen.inverse_dynamics_kernels import inverse_dynamics_kernels
from kindsl.products.codegen.robcogen.link_motions import KEEP_MOTION, getters, link_motions
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

_CONSTRUCTION = """\
    InverseDynamics(IProperties& in, MTransforms& tr) : inertiaProps(&in), xm(&tr)
    {
        velocities = Velocity::Zero();
        accelerations = Acceleration::Zero();
        forces = Force::Zero();
    }
"""

_ABSENT = """\
    template <typename... A>
    void @METHOD@(A&&...)
    {
        static_assert(kernels::Never<void(A...)>::value,
            "there are no passes to call: id and its like compute everything at once");
    }
"""


def inverse_dynamics_headers(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    file = f"robcogen/inverse_dynamics_{'floating' if robot.is_floating else 'fixed'}"
    calls, computing = template(f"{file}.h"), template(f"{file}_private.h")
    absent = ["secondPass_fullyActuated"] if robot.is_floating else ["firstPass", "secondPass"]
    parts = (
        getters(robot),
        "protected:\n",
        *(robot.filled(_ABSENT, METHOD=method) for method in absent),
        "\nprivate:\n",
        robot.filled(computing, KEEP=KEEP_MOTION, PARAMETERS=parameters(robot)),
        link_motions(robot),
    )
    engine = Engine(
        "InverseDynamics",
        "The joint forces of a motion. What the getters tell is computed when they are asked.",
        f"{_CONSTRUCTION}\n{robot.filled(calls)}",
        "".join(parts),
    )
    return engine_headers(robot, "inverse_dynamics", engine, inverse_dynamics_kernels(robot))
