// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_EIGEN_TRAITS_H_
#define IIT_RBD_EIGEN_TRAITS_H_
// Transforms are for Eigen what their matrices are.

#include <iit/rbd/TransformsBase.h>

namespace Eigen {
namespace internal {

template <typename State, typename M>
struct traits<iit::rbd::HomogeneousTransformBase<State, M>>
    : traits<typename iit::rbd::HomogeneousTransformBase<State, M>::MatrixType> {};

template <typename State, typename M>
struct traits<iit::rbd::RotationTransformBase<State, M>>
    : traits<typename iit::rbd::RotationTransformBase<State, M>::MatrixType> {};

}
}

#endif
