// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_TRAITS_TRAITSELECTOR_H_
#define IIT_RBD_TRAITS_TRAITSELECTOR_H_
// The functions that belong to a type of numbers.

#include <iit/rbd/scalar_traits.h>

namespace iit {
namespace rbd {
namespace tpl {

template <typename SCALAR>
struct TraitSelector {
    typedef AnyTrait<SCALAR> Trait;
};
template <>
struct TraitSelector<double> {
    typedef DoubleTrait Trait;
};
template <>
struct TraitSelector<float> {
    typedef FloatTrait Trait;
};

}
}
}

#endif
