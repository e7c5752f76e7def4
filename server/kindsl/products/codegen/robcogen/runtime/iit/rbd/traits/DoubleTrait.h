// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_TRAITS_DOUBLETRAIT_H_
#define IIT_RBD_TRAITS_DOUBLETRAIT_H_

#include <iit/rbd/scalar_traits.h>

#endif
