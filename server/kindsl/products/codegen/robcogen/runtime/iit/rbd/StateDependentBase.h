// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_STATEDEPENDENTBASE_H_
#define IIT_RBD_STATEDEPENDENTBASE_H_
// What depends on a state; the class derived from it has the function `update`.

#include <iit/rbd/rbd.h>

namespace iit {
namespace rbd {

template <class State, class Actual>
class StateDependentBase {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    const Actual& operator()(const State& state)
    {
        return static_cast<Actual*>(this)->update(state);
    }
    const Actual& update(const State& state);
};

}
}

#endif
