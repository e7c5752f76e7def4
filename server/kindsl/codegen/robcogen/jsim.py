"""`jsim.h` and `jsim.impl.h`: the joint-space inertia matrix."""

from kindsl.codegen.robcogen.engines import parameters, parameters_first
from kindsl.codegen.robcogen.robot import GeneratedRobot
from kindsl.dynamics.generation.composite_bodies import joint_space_inertia
from kindsl.dynamics.generation.vectors import transpose

_TEXT = """
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
"""

_BLOCK_TYPES = """\
    typedef const Eigen::Block<const MatrixType, 6, @NJ@> BlockF_t;
    typedef const Eigen::Block<const MatrixType, @NJ@, @NJ@> BlockFixedBase_t;
"""

_BLOCKS = """
    /** The inertia of all bodies together. */
    const InertiaMatrix& getWholeBodyInertia() const
    {
        whole = this->template topLeftCorner<6, 6>();
        return whole;
    }
    /** What joint accelerations take of the base's wrench. */
    const BlockF_t getF() const
    {
        return static_cast<const MatrixType&>(*this).template block<6, @NJ@>(0, 6);
    }
    /** The joints' part, as if the base were fixed. */
    const BlockFixedBase_t getFixedBaseBlock() const
    {
        return static_cast<const MatrixType&>(*this).template block<@NJ@, @NJ@>(6, 6);
    }
"""


def jsim(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    M = joint_space_inertia(robot.tree, robot.library.inputs.q)
    kernels = robot.matrix_kernels("joint_space_inertia", transpose(M))
    body = robot.filled(
        _TEXT,
        BLOCK_TYPES=robot.filled(_BLOCK_TYPES) if robot.is_floating else "",
        BLOCKS=robot.filled(_BLOCKS) if robot.is_floating else "",
        BEFORE=", ".join(map(str, _before(robot))),
        WHOLE="    mutable InertiaMatrix whole;\n" if robot.is_floating else "",
        PARAMETERS=parameters(robot, "frcTransf->"),
        P=parameters_first(robot),
    )
    includes = [
        "<cmath>", "<iit/rbd/rbd.h>", "<iit/rbd/StateDependentMatrix.h>",
        "<iit/rbd/robcogen_commons.h>", "<iit/rbd/traits/DoubleTrait.h>", '"declarations.h"',
        '"transforms.h"', '"inertia_properties.h"', '"jsim.impl.h"',
    ]  # fmt: skip
    text = robot.kernels(kernels)
    return {
        "jsim.h": robot.header("jsim.h", includes, body),
        "jsim.impl.h": robot.header("jsim.impl.h", ['"declarations.h"'], text),
    }


def _before(robot: GeneratedRobot) -> list[int]:
    """Return the velocity variable before each on the way to the base, -1 for the first."""
    first = 6 if robot.is_floating else 0
    parents = robot.tree.parents
    # A link's variable is `first + link - 1`; a floating base's last is 5, a fixed base has none.
    return [*range(-1, first - 1), *(first + parents[i] - 1 for i in robot.tree.links())]
