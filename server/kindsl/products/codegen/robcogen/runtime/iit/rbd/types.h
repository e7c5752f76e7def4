// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_TYPES_H_
#define IIT_RBD_TYPES_H_
// The headers that have short names for the types of one type of numbers.

#include <iit/rbd/InertiaMatrix.h>
#include <iit/rbd/rbd.h>

#endif
