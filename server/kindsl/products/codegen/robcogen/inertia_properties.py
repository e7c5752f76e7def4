"""`inertia_properties.h` and `inertia_properties.impl.h`: masses, centres and moments of links."""

from kindsl.language.semantics.declarations import ValueKind
from kindsl.mechanics.dynamics.generation.terms import Scalar
from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.parameters import names_of
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

_TEXT = template("robcogen/inertia_properties.h")

_CONSTRUCTION = """\
    InertiaProperties() { compute(); }
    void updateParameters(const RuntimeInertiaParams&) {}
"""

_WITH_PARAMETERS = template("robcogen/inertia_properties_parameters.h")


def inertia_properties(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    named = [(number, robot.bodies[i]) for number, i in enumerate(robot.inertial_bodies)]
    getters = "".join(
        f"    const IMatrix& getTensor_{n}() const {{ return tensor_{n}; }}\n"
        f"    Scalar getMass_{n}() const {{ return tensor_{n}.getMass(); }}\n"
        f"    const Vec3d& getCOM_{n}() const {{ return com_{n}; }}\n"
        for _, n in named
    )
    values = [value for i in robot.inertial_bodies for value in ten_of(robot, i)]
    construction, parameters, members = _parameters(robot)
    body = robot.filled(
        _TEXT,
        CONSTRUCTION=construction,
        GETTERS=getters,
        TOTAL=" + ".join(f"getMass_{n}()" for _, n in named),
        SIZE=len(values),
        PARAMETERS=parameters,
        CALLS="".join(f"        set(m + {10 * k}, com_{n}, tensor_{n});\n" for k, n in named),
        MEMBERS="".join(f"    IMatrix tensor_{n};\n    Vec3d com_{n};\n" for _, n in named),
        VALUES=members,
    )
    includes = [
        "<iit/rbd/rbd.h>", "<iit/rbd/InertiaMatrix.h>", "<iit/rbd/utils.h>",
        "<iit/rbd/traits/DoubleTrait.h>", '"declarations.h"', '"dynamics_parameters.h"',
    ]  # fmt: skip
    kernel = robot.kernel("inertia_properties", {}, {"m": values})
    return robot.headers("inertia_properties", includes, body, [kernel])


def ten_of(robot: GeneratedRobot, body: int) -> list[Scalar]:
    """Return mass, centre, and the upper triangle of the inertia about the origin."""
    moments = robot.library.robot.bodies[body]
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = moments.inertia()
    is_massless = isinstance(moments.mass, float) and not moments.mass
    centre = [0.0 if is_massless else x / moments.mass for x in moments.first]
    return [moments.mass, *centre, xx, xy, xz, yy, yz, zz]


def _parameters(robot: GeneratedRobot) -> tuple[str, str, str]:
    """Return how the class gets parameters, lists all of them, and the members that keep them."""
    if not robot.has_parameters:
        return _CONSTRUCTION, "", ""
    names = names_of(robot, ValueKind.DYNAMICS)
    construction = robot.filled(
        _WITH_PARAMETERS,
        READ="".join(f"            values.{n} = getter->getValue_{n}();\n" for _, n in names),
        LISTED="".join(f"        p[{i}] = Scalar(values.{n});\n" for i, n in names)
        or "        (void)p;\n",
    )
    array = (
        f"        Scalar p[{len(robot.library.robot.parameters)}] = {{}};\n        parameters(p);\n"
    )
    members = "    RuntimeInertiaParams values;\n    const RuntimeParamsGetter* getter;\n"
    return construction, array, members
