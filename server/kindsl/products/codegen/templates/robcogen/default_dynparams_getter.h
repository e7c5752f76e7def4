{% import "parameters.h" as parameters %}
#include <Eigen/Core>
#include "dynamics_parameters.h"

@opening@
namespace dyn {

/** Tells the values that parameters had when this was generated; NaN where they had none. */
class DefaultParamsGetter : public RuntimeParamsGetter {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    DefaultParamsGetter() { resetDefaults(); }
    ~DefaultParamsGetter() {}
    void resetDefaults() { values.defaults(); }
@parameters.methods(robot.inertial, "values")@
private:
    RuntimeInertiaParams values;
};

}
@closing@
