
namespace iit {
namespace @NS@ {
namespace dyn {
namespace tpl {

/** The joint-space inertia matrix; a floating base's six rows and columns come first. */
template <typename TRAIT>
class JSIM : public iit::rbd::StateDependentMatrix<
                 iit::@NS@::tpl::JointState<typename TRAIT::Scalar>, @NV@, @NV@, JSIM<TRAIT>> {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW

private:
    typedef iit::rbd::StateDependentMatrix<
        iit::@NS@::tpl::JointState<typename TRAIT::Scalar>, @NV@, @NV@, JSIM<TRAIT>>
        Base;

public:
    typedef typename TRAIT::Scalar Scalar;
    typedef Scalar SCALAR;
    typedef iit::@NS@::tpl::JointState<Scalar> JointState;
    typedef iit::rbd::Core<Scalar> CoreS;
    typedef typename Base::Index Index;
    typedef iit::rbd::PlainMatrix<Scalar, @NV@, @NV@> MatrixType;
@BLOCK_TYPES@    typedef InertiaProperties<TRAIT> IProperties;
    typedef iit::@NS@::tpl::ForceTransforms<TRAIT> FTransforms;
    typedef iit::rbd::tpl::InertiaMatrixDense<Scalar> InertiaMatrix;

    JSIM(IProperties& in, FTransforms& tr) : inertiaProps(&in), frcTransf(&tr)
    {
        this->setZero();
        kernels::joint_space_inertia_constants<TRAIT>(this->data());
        L.setZero();
        Linv.setZero();
        inverse.setZero();
    }
    ~JSIM() {}

    const JSIM& update(const JointState& q)
    {
@PARAMETERS@        kernels::joint_space_inertia<TRAIT>(@P@raw(q), this->data());
        return *this;
    }

    /** Computes L of M = L^T L, lower triangular with the zeros of the branches. */
    void computeL()
    {
        using std::sqrt;
        L = this->template triangularView<Eigen::Lower>();
        for (int k = @NV@ - 1; k >= 0; k--) {
            L(k, k) = sqrt(L(k, k));
            for (int i = before(k); i >= 0; i = before(i)) {
                L(k, i) /= L(k, k);
            }
            for (int i = before(k); i >= 0; i = before(i)) {
                for (int j = i; j >= 0; j = before(j)) {
                    L(i, j) -= L(k, i) * L(k, j);
                }
            }
        }
    }

    /** Computes the inverse, after computeL(). */
    void computeInverse()
    {
        computeLInverse();
        inverse.setZero();
        for (int i = 0; i < @NV@; i++) {
            for (int j = 0; j <= i; j++) {
                for (int k = j; k >= 0; k = before(k)) {
                    inverse(i, j) += Linv(i, k) * Linv(j, k);
                }
                inverse(j, i) = inverse(i, j);
            }
        }
    }

    const MatrixType& getL() const { return L; }
    const MatrixType& getInverse() const { return inverse; }
@BLOCKS@
protected:
    /** Computes the inverse of L, which has the same zeros. */
    void computeLInverse()
    {
        for (int i = 0; i < @NV@; i++) {
            Linv(i, i) = Scalar(1) / L(i, i);
            for (int j = before(i); j >= 0; j = before(j)) {
                Scalar sum(0);
                for (int k = before(i); k >= j; k = before(k)) {
                    sum += L(i, k) * Linv(k, j);
                }
                Linv(i, j) = -Linv(i, i) * sum;
            }
        }
    }

private:
    /** The velocity variable before another on the way to the base, -1 before the first. */
    static int before(int variable)
    {
        static const int found[@NV@] = {@BEFORE@};
        return found[variable];
    }

    IProperties* inertiaProps;
    FTransforms* frcTransf;
    MatrixType L;
    MatrixType Linv;
    MatrixType inverse;
@WHOLE@};

}

typedef tpl::JSIM<rbd::DoubleTrait> JSIM;

}
}
}
