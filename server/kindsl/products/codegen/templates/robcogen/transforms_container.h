
/** @WHAT@ */
template <typename TRAIT>
class @CLASS@ {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    typedef typename TRAIT::Scalar Scalar;
    typedef Scalar SCALAR;
    typedef iit::rbd::Core<Scalar> CoreS;
    typedef JointState<Scalar> JState;
    class Dummy {};
    typedef typename @BASE@<Scalar, Dummy>::MatrixType MatrixType;
    static_assert(!MatrixType::IsRowMajor,
        "these transforms are stored by columns; do not define EIGEN_DEFAULT_TO_ROW_MAJOR");

@TYPES@
@CONSTRUCTION@
@MEMORY@
@MEMBERS@
@VALUES@};
