{% set names = robot.bodies[(0 if robot.is_floating else 1):] %}
#include <iit/rbd/rbd.h>
#include <iit/rbd/InertiaMatrix.h>
#include <iit/rbd/utils.h>
#include <iit/rbd/@trait_header@>
#include "declarations.h"
#include "dynamics_parameters.h"
#include "inertia_properties.impl.h"

@opening@
namespace dyn {

using InertiaMatrix = iit::rbd::tpl::InertiaMatrixDense<@real@>;

namespace tpl {

/** Mass, centre of mass and inertia of each link, in its own frame. */
template <typename TRAIT>
class InertiaProperties {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    typedef typename TRAIT::Scalar Scalar;
    typedef Scalar SCALAR;
    typedef iit::rbd::Core<Scalar> CoreS;
    typedef iit::rbd::tpl::InertiaMatrixDense<Scalar> IMatrix;
    typedef Eigen::Matrix<Scalar, 3, 1> Vec3d;

{% if robot.has_parameters %}
    /** With the values that parameters had when this was generated; NaN where they had none. */
    InertiaProperties() : getter(nullptr) { compute(); }
    explicit InertiaProperties(const RuntimeParamsGetter& fresh) : getter(&fresh)
    {
        updateParameters();
    }
    /** Asks for the values again. */
    void updateParameters()
    {
        if (getter != nullptr) {
{% for x in robot.inertial %}
            values.@x.name@ = getter->getValue_@x.name@();
{% endfor %}
        }
        compute();
    }
    void updateParameters(const RuntimeInertiaParams& fresh)
    {
        values = fresh;
        compute();
    }
    /** Fills in those of all parameters that inertia depends on. */
    void parameters(Scalar* p) const
    {
{% for x in robot.inertial %}
        p[@x.place@] = Scalar(values.@x.name@);
{% else %}
        (void)p;
{% endfor %}
    }
{% else %}
    InertiaProperties() { compute(); }
    void updateParameters(const RuntimeInertiaParams&) {}
{% endif %}

    ~InertiaProperties() {}

{% for n in names %}
    const IMatrix& getTensor_@n@() const { return tensor_@n@; }
    Scalar getMass_@n@() const { return tensor_@n@.getMass(); }
    const Vec3d& getCOM_@n@() const { return com_@n@; }
{% endfor %}

    Scalar getTotalMass() const { return getMass_@names|join('() + getMass_')@(); }

private:
    void compute()
    {
        Scalar m[@10 * names|length@];
{% if robot.has_parameters %}
        Scalar p[@robot.library.robot.parameters|length@] = {};
        parameters(p);
{% endif %}
        kernels::inertia_properties<TRAIT>(@p@m);
{% for n in names %}
        set(m + @10 * loop.index0@, com_@n@, tensor_@n@);
{% endfor %}
    }

    static void set(const Scalar* m, Vec3d& com, IMatrix& tensor)
    {
        typename CoreS::Matrix33 moments;
        moments << m[4], m[5], m[6], m[5], m[7], m[8], m[6], m[8], m[9];
        com << m[1], m[2], m[3];
        tensor.fill(m[0], com, moments);
    }

{% for n in names %}
    IMatrix tensor_@n@;
    Vec3d com_@n@;
{% endfor %}
{% if robot.has_parameters %}
    RuntimeInertiaParams values;
    const RuntimeParamsGetter* getter;
{% endif %}
};

}

using InertiaProperties = tpl::InertiaProperties<@trait@>;

}
@closing@
