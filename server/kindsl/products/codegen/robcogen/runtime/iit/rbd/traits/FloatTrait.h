// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_TRAITS_FLOATTRAIT_H_
#define IIT_RBD_TRAITS_FLOATTRAIT_H_

#include <iit/rbd/scalar_traits.h>

#endif
