#include "declarations.h"
#include "transforms.h"
#include "inverse_dynamics.h"
#include "forward_dynamics.h"
#include "jsim.h"
#include "inertia_properties.h"
#include "jacobians.h"
#include <@"iit/rbd/scalar_traits.h" if robot.has_names_of_0_5 else "iit/rbd/traits/TraitSelector.h"@>

@opening@
namespace tpl {

/** All types of this robot. */
template <typename SCALAR>
struct Traits {
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW

    typedef SCALAR S;
    typedef @"iit::rbd::ScalarTraits<SCALAR>" if robot.has_names_of_0_5 else "typename iit::rbd::tpl::TraitSelector<SCALAR>::Trait"@ Trait;
    typedef Trait ScalarTraits;
    typedef typename @space@::tpl::JointState<SCALAR> JointState;

    typedef @space@::JointIdentifiers JointID;
    typedef @space@::LinkIdentifiers LinkID;

    typedef @space@::tpl::HomogeneousTransforms<Trait> HomogeneousTransforms;
    typedef @space@::tpl::MotionTransforms<Trait> MotionTransforms;
    typedef @space@::tpl::ForceTransforms<Trait> ForceTransforms;
    typedef @space@::tpl::Jacobians<Trait> Jacobians;

    typedef @space@::dyn::tpl::InertiaProperties<Trait> InertiaProperties;
    typedef @space@::dyn::tpl::ForwardDynamics<Trait> FwdDynEngine;
    typedef @space@::dyn::tpl::InverseDynamics<Trait> InvDynEngine;
    typedef @space@::dyn::tpl::JSIM<Trait> JSIM;

    static const int joints_count = @space@::jointsCount;
    static const int links_count = @space@::linksCount;
    static const bool floating_base = @'true' if robot.is_floating else 'false'@;

    static inline const JointID* orderedJointIDs() { return @space@::orderedJointIDs; }
    static inline const LinkID* orderedLinkIDs() { return @space@::orderedLinkIDs; }
};

template <typename SCALAR>
const int Traits<SCALAR>::joints_count;
template <typename SCALAR>
const int Traits<SCALAR>::links_count;
template <typename SCALAR>
const bool Traits<SCALAR>::floating_base;

}

typedef tpl::Traits<@real@> Traits;

@closing@
