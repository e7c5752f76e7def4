
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
