
namespace iit {
namespace @NS@ {
namespace tpl {

/** All types of this robot. */
template <typename SCALAR>
struct Traits {
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW

    typedef SCALAR S;
    typedef typename iit::rbd::tpl::TraitSelector<SCALAR>::Trait Trait;
    typedef Trait ScalarTraits;
    typedef typename iit::@NS@::tpl::JointState<SCALAR> JointState;

    typedef iit::@NS@::JointIdentifiers JointID;
    typedef iit::@NS@::LinkIdentifiers LinkID;

    typedef iit::@NS@::tpl::HomogeneousTransforms<Trait> HomogeneousTransforms;
    typedef iit::@NS@::tpl::MotionTransforms<Trait> MotionTransforms;
    typedef iit::@NS@::tpl::ForceTransforms<Trait> ForceTransforms;
    typedef iit::@NS@::tpl::Jacobians<Trait> Jacobians;

    typedef iit::@NS@::dyn::tpl::InertiaProperties<Trait> InertiaProperties;
    typedef iit::@NS@::dyn::tpl::ForwardDynamics<Trait> FwdDynEngine;
    typedef iit::@NS@::dyn::tpl::InverseDynamics<Trait> InvDynEngine;
    typedef iit::@NS@::dyn::tpl::JSIM<Trait> JSIM;

    static const int joints_count = iit::@NS@::jointsCount;
    static const int links_count = iit::@NS@::linksCount;
    static const bool floating_base = @FLOATING@;

    static inline const JointID* orderedJointIDs() { return iit::@NS@::orderedJointIDs; }
    static inline const LinkID* orderedLinkIDs() { return iit::@NS@::orderedLinkIDs; }
};

template <typename SCALAR>
const int Traits<SCALAR>::joints_count;
template <typename SCALAR>
const int Traits<SCALAR>::links_count;
template <typename SCALAR>
const bool Traits<SCALAR>::floating_base;

}

typedef tpl::Traits<double> Traits;

}
}
