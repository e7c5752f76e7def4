{% import "parameters.h" as parameters %}
#include <Eigen/Dense>
#include <iit/rbd/rbd.h>
#include <iit/rbd/TransformsBase.h>
#include <iit/rbd/@trait_header@>
#include "declarations.h"
#include "kinematics_parameters.h"
#include "transforms.impl.h"

@opening@

{% for kind in kinds %}
template <typename SCALAR, class M>
class Transform@kind.name@ : public iit::rbd::@"Homogeneous" if kind.letter == "h" else "Spatial"@TransformBase<tpl::JointState<SCALAR>, M> {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

{% endfor %}
namespace tpl {
{% for kind in kinds %}

/** @kind.what@ */
template <typename TRAIT>
class @kind.name@Transforms {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    typedef typename TRAIT::Scalar Scalar;
    typedef Scalar SCALAR;
    typedef iit::rbd::Core<Scalar> CoreS;
    typedef JointState<Scalar> JState;
    class Dummy {};
    typedef typename Transform@kind.name@<Scalar, Dummy>::MatrixType MatrixType;
    static_assert(!MatrixType::IsRowMajor,
        "these transforms are stored by columns; do not define EIGEN_DEFAULT_TO_ROW_MAJOR");

{% for matrix in matrices %}
{% set name = matrix.name %}
{% set joint = across[name] if kind.name == "Motion" and name in across else none %}
    class Type_@name@ : public Transform@kind.name@<Scalar, Type_@name@> {
    public:
        EIGEN_MAKE_ALIGNED_OPERATOR_NEW
        Type_@name@()@" : position(0)" if joint else ""@
        {
            this->setZero();
            kernels::@kind.function@_@name@_constants<TRAIT>(this->data()@kind.coupling@);
            update(JState::Zero());
        }
        const Type_@name@& update(const JState& q)
        {
@parameters.array(matrix, robot)@            kernels::@kind.function@_@name@<TRAIT>(@parameters.first(matrix, robot)@raw(q), this->data()@kind.coupling@);
{% if joint %}
            position = q(@joint - 1@);
{% endif %}
            return *this;
        }
@parameters.kept(matrix, robot)@@"        Scalar position; // of the joint, when this was updated last\n" if joint else ""@    };

{% endfor %}
@parameters.construction(kind.name ~ "Transforms", robot)@
{% if kind.name == "Motion" and across %}
    /** Keeps joint positions for what is computed without any; no matrix changes. */
    void storeJointStatus(const JState& q)
    {
{% for name, joint in across.items() %}
        @name@.position = q(@joint - 1@);
{% endfor %}
    }
    /** Returns the joint positions that each transform was updated with last. */
    void loadJointStatus(JState& q) const
    {
{% for name, joint in across.items() %}
        q(@joint - 1@) = @name@.position;
{% endfor %}
    }
{% endif %}

{% for matrix in matrices %}
    Type_@matrix.name@ @matrix.name@;
{% endfor %}

@parameters.values(matrices, robot)@};
{% endfor %}

}

{% for kind in kinds %}
using @kind.name@Transforms = tpl::@kind.name@Transforms<@trait@>;
{% endfor %}

@closing@
