{% import "parameters.h" as parameters %}
#include <limits>

@opening@

{% for group, listed in robot.kinematic.items() %}
@parameters.struct("Params_" ~ group, listed)@
{% endfor %}
{% for group, listed in robot.kinematic.items() %}
@parameters.getter("ParamsGetter_" ~ group, listed)@
{% endfor %}
/** Tells the values that parameters had when this was generated; NaN where they had none. */
class DefaultParamsGetter : public ParamsGetter_lengths, public ParamsGetter_angles {
public:
    DefaultParamsGetter() { resetDefaults(); }
    void resetDefaults()
    {
        lengths.defaults();
        angles.defaults();
    }
{% for group, listed in robot.kinematic.items() %}@parameters.methods(listed, group)@{% endfor %}

private:
    Params_lengths lengths;
    Params_angles angles;
};

@closing@
