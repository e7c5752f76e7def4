#include <Eigen/Dense>
#include <iit/rbd/rbd.h>
#include <iit/rbd/InertiaMatrix.h>
#include <iit/rbd/utils.h>
#include <iit/rbd/robcogen_commons.h>
#include <iit/rbd/@trait_header@>
#include "declarations.h"
#include "inertia_properties.h"
#include "transforms.h"
#include "link_data_map.h"
#include "@file@.impl.h"

@opening@
namespace dyn {
namespace tpl {

/**
 * @about@
 *
 * Overloads without q take the joint positions that the transforms have. Forces on links are in the
 * links' coordinates.
 */
template <typename TRAIT>
class @name_of_class@ {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    typedef typename TRAIT::Scalar Scalar;
    typedef Scalar SCALAR;
    typedef iit::rbd::Core<Scalar> CoreS;
    typedef typename CoreS::ForceVector Force;
    typedef LinkDataMap<Force> ExtForces;
    typedef typename CoreS::VelocityVector Velocity;
    typedef typename CoreS::VelocityVector Acceleration;
    typedef typename CoreS::Column6D Column6DS;
    typedef typename CoreS::Matrix66 Matrix66s;
    typedef typename CoreS::Matrix66 Matrix66S;
    typedef iit::rbd::tpl::InertiaMatrixDense<Scalar> InertiaMatrix;
    typedef @space@::tpl::JointState<Scalar> JointState;
    typedef @space@::tpl::MotionTransforms<TRAIT> MTransforms;
    typedef InertiaProperties<TRAIT> IProperties;
    static_assert(sizeof(ExtForces) == sizeof(Scalar) * 6 * linksCount,
        "the forces on all links must lie one after the other in memory");

{% block calls %}{% endblock %}

    /** Updates the transforms across joints. */
    void setJointStatus(const JointState& q) const
    {
{% for i in links %}
        xm->@robot.across(i)@(q);
{% endfor %}
    }

{% block rest %}{% endblock %}

    static const Scalar* first(const ExtForces& fext)
    {
        return fext[orderedLinkIDs[0]].data();
    }

    JointState jointStatus() const
    {
        JointState q;
        xm->loadJointStatus(q);
        return q;
    }

    IProperties* inertiaProps;
    MTransforms* xm;

    static const ExtForces zeroExtForces;
};

template <typename TRAIT>
const typename @name_of_class@<TRAIT>::ExtForces
    @name_of_class@<TRAIT>::zeroExtForces(@name_of_class@<TRAIT>::Force::Zero());

}

typedef tpl::@name_of_class@<@trait@> @name_of_class@;

}
@closing@
