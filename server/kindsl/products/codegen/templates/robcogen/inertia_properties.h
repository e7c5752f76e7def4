
namespace iit {
namespace @NS@ {
namespace dyn {

using InertiaMatrix = iit::rbd::InertiaMatrixDense;

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

@CONSTRUCTION@
    ~InertiaProperties() {}

@GETTERS@
    Scalar getTotalMass() const { return @TOTAL@; }

private:
    void compute()
    {
        Scalar m[@SIZE@];
@PARAMETERS@        kernels::inertia_properties<TRAIT>(@P@m);
@CALLS@    }

    static void set(const Scalar* m, Vec3d& com, IMatrix& tensor)
    {
        typename CoreS::Matrix33 moments;
        moments << m[4], m[5], m[6], m[5], m[7], m[8], m[6], m[8], m[9];
        com << m[1], m[2], m[3];
        tensor.fill(m[0], com, moments);
    }

@MEMBERS@@VALUES@};

}

using InertiaProperties = tpl::InertiaProperties<rbd::DoubleTrait>;

}
}
}
