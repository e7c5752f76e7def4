
namespace iit {
namespace @NS@ {

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

@TYPES@
@CONSTRUCTION@
@MEMBERS@@VALUES@};

}

using Jacobians = tpl::Jacobians<rbd::DoubleTrait>;

}
}
