{% import "parameters.h" as parameters %}
#include <iit/rbd/rbd.h>
#include <iit/rbd/TransformsBase.h>
#include <iit/rbd/@trait_header@>
#include "declarations.h"
#include "kinematics_parameters.h"
#include "jacobians.impl.h"

@opening@

template <typename SCALAR, int COLS, class M>
class JacobianT : public iit::rbd::JacobianBase<tpl::JointState<SCALAR>, COLS, M> {};

namespace tpl {

/** Velocities of frames relative to others and in their coordinates, angular before linear. */
template <typename TRAIT>
class Jacobians {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    typedef typename TRAIT::Scalar Scalar;
    typedef Scalar SCALAR;
    typedef iit::rbd::Core<Scalar> CoreS;
    typedef JointState<Scalar> JState;

{% for matrix in matrices %}
{% set name = matrix.name %}
    class Type_@name@ : public JacobianT<Scalar, @matrix.columns@, Type_@name@> {
    public:
        EIGEN_MAKE_ALIGNED_OPERATOR_NEW
        Type_@name@()
        {
            this->setZero();
            kernels::@name@_constants<TRAIT>(this->data());
            update(JState::Zero());
        }
        const Type_@name@& update(const JState& q)
        {
@parameters.array(matrix, robot)@            kernels::@name@<TRAIT>(@parameters.first(matrix, robot)@raw(q), this->data());
            return *this;
        }
@parameters.kept(matrix, robot)@    };

{% else %}

{% endfor %}
@parameters.construction("Jacobians", robot)@
{% for matrix in matrices %}
    Type_@matrix.name@ @matrix.name@;
{% endfor %}
@parameters.values(matrices, robot)@};

}

using Jacobians = tpl::Jacobians<@trait@>;

@closing@
