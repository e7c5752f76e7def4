
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
@TYPES@
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
