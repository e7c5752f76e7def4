// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_STATEDEPENDENTMATRIX_H_
#define IIT_RBD_STATEDEPENDENTMATRIX_H_
// A matrix that depends on a state.

#include <iostream>

#include <iit/rbd/StateDependentBase.h>
#include <iit/rbd/rbd.h>

namespace iit {
namespace rbd {

template <class State, int Rows, int Cols, class ActualMatrix>
class StateDependentMatrix : public StateDependentBase<State, ActualMatrix>,
                             public PlainMatrix<typename State::Scalar, Rows, Cols> {
private:
    typedef PlainMatrix<typename State::Scalar, Rows, Cols> Base;

public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    typedef typename Base::Scalar Scalar;
    typedef typename Base::Index Index;
    typedef Base MatrixType;

    StateDependentMatrix() {}
    ~StateDependentMatrix() {}
    StateDependentMatrix(const StateDependentMatrix&) = default;
    StateDependentMatrix& operator=(const StateDependentMatrix&) = default;

    template <typename Other>
    StateDependentMatrix& operator=(const MatrixBase<Other>& other)
    {
        Base::operator=(other);
        return *this;
    }

    using StateDependentBase<State, ActualMatrix>::operator();
    using Base::operator();
    using Base::setZero;
};

}
}

#endif
