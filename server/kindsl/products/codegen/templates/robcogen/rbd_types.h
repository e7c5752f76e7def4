#include <iit/rbd/InertiaMatrix.h>
#include <iit/rbd/rbd.h>
#include <iit/rbd/scalar_traits.h>

@opening@
{% if has_rcg_namespace %}
namespace dyn {
}
@closing@

namespace @robot.space@ {
namespace rcg {

using namespace @space@;
using namespace @space@::dyn;
{% endif %}
using iit::rbd::g;

typedef @trait@ ScalarTraits;
typedef ScalarTraits::Scalar Scalar;
typedef iit::rbd::Core<Scalar> TypesGen;
typedef TypesGen::ForceVector Force;
typedef TypesGen::VelocityVector Velocity;
typedef TypesGen::VelocityVector Acceleration;
typedef TypesGen::Matrix66 Matrix66;
typedef TypesGen::Column6D Column6;
typedef TypesGen::Vector3 Vector3;
typedef iit::rbd::tpl::InertiaMatrixDense<Scalar> InertiaMatrix;

template <int R, int C>
using Matrix = iit::rbd::PlainMatrix<Scalar, R, C>;

{% if has_rcg_namespace %}
}
}
{% else %}
@closing@
{% endif %}
