#include <iit/rbd/scalar_traits.h>
#include <iit/rbd/types.h>

@opening@
namespace dyn {
}
}
}

namespace @robot.space@ {
namespace rcg {

using namespace @space@;
using namespace @space@::dyn;
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
