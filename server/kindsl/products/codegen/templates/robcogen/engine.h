
namespace iit {
namespace @NS@ {
namespace dyn {
namespace tpl {

/**
 * @ABOUT@
 *
 * Overloads without q take the joint positions that the transforms have. Forces on links are in the
 * links' coordinates.
 */
template <typename TRAIT>
class @CLASS@ {
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
    typedef iit::@NS@::tpl::JointState<Scalar> JointState;
    typedef iit::@NS@::tpl::MotionTransforms<TRAIT> MTransforms;
    typedef InertiaProperties<TRAIT> IProperties;
    static_assert(sizeof(ExtForces) == sizeof(Scalar) * 6 * linksCount,
        "the forces on all links must lie one after the other in memory");

@CALLS@
    /** Updates the transforms across joints. */
    void setJointStatus(const JointState& q) const
    {
@UPDATES@    }

@REST@
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
const typename @CLASS@<TRAIT>::ExtForces
    @CLASS@<TRAIT>::zeroExtForces(@CLASS@<TRAIT>::Force::Zero());

}

typedef tpl::@CLASS@<rbd::DoubleTrait> @CLASS@;

}
}
}
