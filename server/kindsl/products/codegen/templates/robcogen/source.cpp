// @stamp.origin@
// @stamp.licence@
// All code is in the header; this file is there for build files that name it.
#include "@header@.h"
