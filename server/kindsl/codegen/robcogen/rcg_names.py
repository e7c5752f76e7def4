"""The names of RobCoGen 0.5, all in `NAME::rcg`: a header that the others include."""

from kindsl.codegen.robcogen.robot import GeneratedRobot

LAYOUT = "robcogen-0.5"

_TYPES = """
namespace iit {
namespace @NS@ {
namespace dyn {
}
}
}

namespace @NS@ {
namespace rcg {

using namespace iit::@NS@;
using namespace iit::@NS@::dyn;
using iit::rbd::g;

typedef iit::rbd::DoubleTraits ScalarTraits;
typedef ScalarTraits::Scalar Scalar;
typedef iit::rbd::Core<Scalar> TypesGen;
typedef TypesGen::ForceVector Force;
typedef TypesGen::VelocityVector Velocity;
typedef TypesGen::VelocityVector Acceleration;
typedef TypesGen::Matrix66 Matrix66;
typedef TypesGen::Column6D Column6;
typedef TypesGen::Vector3 Vector3;
typedef iit::rbd::InertiaMat<Scalar> InertiaMatrix;

template <int R, int C>
using Matrix = iit::rbd::PlainMatrix<Scalar, R, C>;

}
}
"""

_CONSTANTS = """
#error "constants are in the code: change the document and generate again, or use parameters"
"""


def rcg_names(robot: GeneratedRobot) -> dict[str, str]:
    """Return the header of types, and one that tells why there are no constants."""
    types = ["<iit/rbd/scalar_traits.h>", "<iit/rbd/types.h>"]
    return {
        "rbd_types.h": robot.header("rbd_types.h", types, robot.filled(_TYPES)),
        "model_constants.h": robot.header("model_constants.h", [], _CONSTANTS),
    }
