#include "declarations.h"

@opening@
namespace kernels {

@functions|join("\n")@
}
@closing@
