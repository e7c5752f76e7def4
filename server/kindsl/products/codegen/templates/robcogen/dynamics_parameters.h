{% import "parameters.h" as parameters %}
#include <limits>

@opening@
namespace dyn {

/** The parameters of links' inertia. */
@parameters.struct("RuntimeInertiaParams", robot.inertial)@
/** What tells their values. */
@parameters.getter("RuntimeParamsGetter", robot.inertial)@
}
@closing@
