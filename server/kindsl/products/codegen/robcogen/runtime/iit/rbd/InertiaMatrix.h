// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_INERTIAMATRIX_H_
#define IIT_RBD_INERTIAMATRIX_H_
// The inertia of a rigid body as a 6x6 matrix about some origin.

#include <iit/rbd/rbd.h>

namespace iit {
namespace rbd {
namespace tpl {

template <typename SCALAR>
class InertiaMatrixDense : public Core<SCALAR>::Matrix66 {
public:
    EIGEN_MAKE_ALIGNED_OPERATOR_NEW
    typedef SCALAR Scalar;

private:
    typedef typename Core<Scalar>::Matrix66 Base;
    typedef typename Core<Scalar>::Matrix33 Mat33;
    typedef typename Core<Scalar>::Vector3 Vec3;
    typedef MatrixBlock<const Base, 3, 3> Block33_const;

public:
    InertiaMatrixDense() { this->setZero(); }
    /** Takes the moments about the origin that the matrix is about. */
    InertiaMatrixDense(Scalar mass, const Vec3& com, const Mat33& moments)
    {
        fill(mass, com, moments);
    }

    template <typename Other>
    InertiaMatrixDense& operator=(const MatrixBase<Other>& other)
    {
        Base::operator=(other);
        return *this;
    }
    template <typename Other>
    InertiaMatrixDense& operator+=(const MatrixBase<Other>& other)
    {
        Base::operator+=(other);
        return *this;
    }

    void fill(Scalar mass, const Vec3& com, const Mat33& moments)
    {
        this->setZero();
        this->diagonal().template tail<3>().setConstant(mass);
        this->template topLeftCorner<3, 3>() = moments;
        setFirstMoment(mass * com);
    }

    Scalar getMass() const { return (*this)(LX, LX); }
    Vec3 getCOM() const { return firstMoment() / getMass(); }
    const Block33_const get3x3Tensor() const
    {
        return Block33_const(static_cast<const Base&>(*this), AX, AX);
    }

    /** Scales all of it. */
    void changeMass(Scalar mass)
    {
        const Scalar factor = mass / getMass();
        Base::operator*=(factor);
    }
    /** Moves the centre of mass, and the moments with it. */
    void changeCOM(const Vec3& com)
    {
        const Scalar mass = getMass();
        const Mat33 before = this->template topRightCorner<3, 3>();
        setFirstMoment(mass * com);
        const Mat33 after = this->template topRightCorner<3, 3>();
        this->template topLeftCorner<3, 3>()
            += (after * after.transpose() - before * before.transpose()) / mass;
    }
    void changeRotationalInertia(const Mat33& moments)
    {
        this->template topLeftCorner<3, 3>() = moments;
    }

private:
    Vec3 firstMoment() const { return Vec3((*this)(AZ, LY), (*this)(AX, LZ), (*this)(AY, LX)); }

    void setFirstMoment(const Vec3& h)
    {
        Mat33 cross;
        cross << Scalar(0), -h(Z), h(Y), h(Z), Scalar(0), -h(X), -h(Y), h(X), Scalar(0);
        this->template topRightCorner<3, 3>() = cross;
        this->template bottomLeftCorner<3, 3>() = cross.transpose();
    }
};

template <typename SCALAR>
class InertiaMatrixSparse : public SparseMatrix<SCALAR> {};

}

using InertiaMatrixDense = tpl::InertiaMatrixDense<double>;
template <typename S>
using InertiaMat = tpl::InertiaMatrixDense<S>;

}
}

#endif
