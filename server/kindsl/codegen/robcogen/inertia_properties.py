"""`inertia_properties.h` and `inertia_properties.impl.h`: masses, centres and moments of links."""

from kindsl.codegen.robcogen.parameters import names_of
from kindsl.codegen.robcogen.robot import GeneratedRobot
from kindsl.dynamics.generation.terms import Scalar
from kindsl.semantics.declarations import ValueKind

_TEXT = """
namespace iit {
namespace @NS@ {
namespace dyn {

using InertiaMatrix = iit::rbd::InertiaMatrixDense;

namespace tpl {

/** Mass, centre of mass and inertia of each link, in its own frame. */
template <typename TRAIT>
class InertiaProperties {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    typedef typename TRAIT::Scalar Scalar;
    typedef Scalar SCALAR;
    typedef iit::rbd::Core<Scalar> CoreS;
    typedef iit::rbd::tpl::InertiaMatrixDense<Scalar> IMatrix;
    typedef Eigen::Matrix<Scalar, 3, 1> Vec3d;

@CONSTRUCTION@
    ~InertiaProperties() {}

@GETTERS@
    Scalar getTotalMass() const { return @TOTAL@; }

private:
    void compute()
    {
        Scalar m[@SIZE@];
@PARAMETERS@        kernels::inertia_properties<TRAIT>(@P@m);
@CALLS@    }

    static void set(const Scalar* m, Vec3d& com, IMatrix& tensor)
    {
        typename CoreS::Matrix33 moments;
        moments << m[4], m[5], m[6], m[5], m[7], m[8], m[6], m[8], m[9];
        com << m[1], m[2], m[3];
        tensor.fill(m[0], com, moments);
    }

@MEMBERS@@VALUES@};

}

using InertiaProperties = tpl::InertiaProperties<rbd::DoubleTrait>;

}
}
}
"""

_CONSTRUCTION = """\
    InertiaProperties() { compute(); }
    void updateParameters(const RuntimeInertiaParams&) {}
"""

_WITH_PARAMETERS = """\
    /** With the values that parameters had when this was generated; NaN where they had none. */
    InertiaProperties() : getter(nullptr) { compute(); }
    explicit InertiaProperties(const RuntimeParamsGetter& values) : getter(&values)
    {
        updateParameters();
    }
    /** Asks for the values again. */
    void updateParameters()
    {
        if (getter != nullptr) {
@READ@        }
        compute();
    }
    void updateParameters(const RuntimeInertiaParams& fresh)
    {
        values = fresh;
        compute();
    }
    /** Fills in those of all parameters that inertia depends on. */
    void parameters(Scalar* p) const
    {
@LISTED@    }
"""


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
        P="p, " if robot.has_parameters else "",
        CALLS="".join(f"        set(m + {10 * k}, com_{n}, tensor_{n});\n" for k, n in named),
        MEMBERS="".join(f"    IMatrix tensor_{n};\n    Vec3d com_{n};\n" for _, n in named),
        VALUES=members,
    )
    includes = [
        "<iit/rbd/rbd.h>", "<iit/rbd/InertiaMatrix.h>", "<iit/rbd/utils.h>",
        "<iit/rbd/traits/DoubleTrait.h>", '"declarations.h"', '"dynamics_parameters.h"',
        '"inertia_properties.impl.h"',
    ]  # fmt: skip
    kernels = robot.kernels([robot.kernel("inertia_properties", {}, {"m": values})])
    name = "inertia_properties.impl.h"
    return {
        "inertia_properties.h": robot.header("inertia_properties.h", includes, body),
        name: robot.header(name, ['"declarations.h"'], kernels),
    }


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
