// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_TRANSFORMSBASE_H_
#define IIT_RBD_TRANSFORMSBASE_H_
// Transforms and Jacobians that depend on a state.

#include <iit/rbd/StateDependentMatrix.h>

namespace iit {
namespace rbd {

template <class State, class ActualMatrix>
class RotationTransformBase : public StateDependentMatrix<State, 3, 3, ActualMatrix> {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

template <class State, class ActualMatrix>
class HomogeneousTransformBase : public StateDependentMatrix<State, 4, 4, ActualMatrix> {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

template <class State, class ActualMatrix>
class SpatialTransformBase : public StateDependentMatrix<State, 6, 6, ActualMatrix> {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

template <class State, int Cols, class ActualMatrix>
class JacobianBase : public StateDependentMatrix<State, 6, Cols, ActualMatrix> {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

}
}

#endif
