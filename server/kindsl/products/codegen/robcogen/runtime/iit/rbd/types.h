#ifndef IIT_RBD_TYPES_H_
#define IIT_RBD_TYPES_H_
// Short names of the types for one type of numbers.

#include "InertiaMatrix.h"
#include "rbd.h"

namespace iit {
namespace rbd {

template <typename S>
using Velocity = typename Core<S>::VelocityVector;
template <typename S>
using Force = typename Core<S>::ForceVector;
template <typename S>
using Mat33 = typename Core<S>::Matrix33;
template <typename S>
using Mat66 = typename Core<S>::Matrix66;
template <typename S>
using Vec3 = typename Core<S>::Vector3;
template <typename S>
using Vec6 = typename Core<S>::Vector6;
template <typename S>
using InertiaMat = tpl::InertiaMatrixDense<S>;

}
}

#endif
