#include <cmath>
#include <iit/rbd/rbd.h>
#include <iit/rbd/StateDependentMatrix.h>
#include <iit/rbd/robcogen_commons.h>
#include <iit/rbd/@trait_header@>
#include "declarations.h"
#include "transforms.h"
#include "inertia_properties.h"
#include "jsim.impl.h"

@opening@
namespace dyn {
namespace tpl {

/** The joint-space inertia matrix; a floating base's six rows and columns come first. */
template <typename TRAIT>
class JSIM : public iit::rbd::StateDependentMatrix<
                 @space@::tpl::JointState<typename TRAIT::Scalar>, @robot.n_velocities@, @robot.n_velocities@, JSIM<TRAIT>> {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW

private:
    typedef iit::rbd::StateDependentMatrix<
        @space@::tpl::JointState<typename TRAIT::Scalar>, @robot.n_velocities@, @robot.n_velocities@, JSIM<TRAIT>>
        Base;

public:
    typedef typename TRAIT::Scalar Scalar;
    typedef Scalar SCALAR;
    typedef @space@::tpl::JointState<Scalar> JointState;
    typedef iit::rbd::Core<Scalar> CoreS;
    typedef typename Base::Index Index;
    typedef iit::rbd::PlainMatrix<Scalar, @robot.n_velocities@, @robot.n_velocities@> MatrixType;
{% if robot.is_floating %}
    typedef const Eigen::Block<const MatrixType, 6, @robot.n_joints@> BlockF_t;
    typedef const Eigen::Block<const MatrixType, @robot.n_joints@, @robot.n_joints@> BlockFixedBase_t;
{% endif %}
    typedef InertiaProperties<TRAIT> IProperties;
    typedef @space@::tpl::ForceTransforms<TRAIT> FTransforms;
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
{% with transforms = "frcTransf" %}
{% include "list_parameters.h" %}
{% endwith %}
        kernels::joint_space_inertia<TRAIT>(@p@raw(q), this->data());
        return *this;
    }

    /** Computes L of M = L^T L, lower triangular with the zeros of the branches. */
    void computeL()
    {
        using std::sqrt;
        L = this->template triangularView<Eigen::Lower>();
        for (int k = @robot.n_velocities@ - 1; k >= 0; k--) {
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
        for (int i = 0; i < @robot.n_velocities@; i++) {
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
{% if robot.is_floating %}

    /** The inertia of all bodies together. */
    const InertiaMatrix& getWholeBodyInertia() const
    {
        whole = this->template topLeftCorner<6, 6>();
        return whole;
    }
    /** What joint accelerations take of the base's wrench. */
    const BlockF_t getF() const
    {
        return static_cast<const MatrixType&>(*this).template block<6, @robot.n_joints@>(0, 6);
    }
    /** The joints' part, as if the base were fixed. */
    const BlockFixedBase_t getFixedBaseBlock() const
    {
        return static_cast<const MatrixType&>(*this).template block<@robot.n_joints@, @robot.n_joints@>(6, 6);
    }
{% endif %}

protected:
    /** Computes the inverse of L, which has the same zeros. */
    void computeLInverse()
    {
        for (int i = 0; i < @robot.n_velocities@; i++) {
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
        static const int found[@robot.n_velocities@] = {@before|join(', ')@};
        return found[variable];
    }

    IProperties* inertiaProps;
    FTransforms* frcTransf;
    MatrixType L;
    MatrixType Linv;
    MatrixType inverse;
{% if robot.is_floating %}
    mutable InertiaMatrix whole;
{% endif %}
};

}

typedef tpl::JSIM<@trait@> JSIM;

}
@closing@
