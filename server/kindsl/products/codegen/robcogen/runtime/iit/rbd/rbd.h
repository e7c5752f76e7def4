// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_RBD_H_
#define IIT_RBD_RBD_H_
// Types of six-dimensional vectors and matrices. The angular part comes first.

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <Eigen/StdVector>

namespace iit {
namespace rbd {

template <typename Derived>
using MatrixBase = Eigen::MatrixBase<Derived>;
template <typename Scalar, int Rows, int Columns>
using PlainMatrix = Eigen::Matrix<Scalar, Rows, Columns>;
template <typename Expression, int Rows, int Columns>
using MatrixBlock = Eigen::Block<Expression, Rows, Columns>;
template <typename Scalar>
using SparseMatrix = Eigen::SparseMatrix<Scalar>;
template <typename Scalar>
using SparseVector = Eigen::SparseVector<Scalar>;

/** The types for one type of numbers. */
template <typename SCALAR>
struct Core {
    typedef SCALAR Scalar;
    typedef PlainMatrix<Scalar, 3, 3> Matrix33;
    typedef PlainMatrix<Scalar, 6, 6> Matrix66;
    typedef PlainMatrix<Scalar, 3, 1> Vector3;
    typedef PlainMatrix<Scalar, 6, 1> Vector6;
    typedef Vector6 Vector6D;
    typedef Vector6 Column6D;
    typedef Vector6 VelocityVector;
    typedef Vector6 ForceVector;
    typedef MatrixBlock<Vector6, 3, 1> Part3D;
    typedef MatrixBlock<const Vector6, 3, 1> Part3DConst;

    static Part3D angularPart(Vector6& v) { return Part3D(v, 0, 0); }
    static Part3D linearPart(Vector6& v) { return Part3D(v, 3, 0); }
    static Part3DConst angularPart(const Vector6& v) { return Part3DConst(v, 0, 0); }
    static Part3DConst linearPart(const Vector6& v) { return Part3DConst(v, 3, 0); }
};

template <typename S>
using Velocity = typename Core<S>::VelocityVector;
template <typename S>
using Force = typename Core<S>::ForceVector;
template <typename S>
using Mat33 = typename Core<S>::Matrix33;
template <typename S>
using Mat66 = typename Core<S>::Matrix66;
template <typename S>
using Vec3 = typename Core<S>::Vector3;
template <typename S>
using Vec6 = typename Core<S>::Vector6;

typedef Core<double> Cored;
using Matrix33d = Cored::Matrix33;
using Matrix66d = Cored::Matrix66;
using Vector3d = Cored::Vector3;
using Vector6d = Cored::Vector6;
using Vector6D = Cored::Vector6D;
using Column6d = Cored::Column6D;
using VelocityVector = Cored::VelocityVector;
using ForceVector = Cored::ForceVector;
using Part3D = Cored::Part3D;
using Part3DConst = Cored::Part3DConst;
using SparseMatrixd = SparseMatrix<double>;
using SparseColumnd = SparseVector<double>;

inline Part3D angularPart(Vector6D& v) { return Cored::angularPart(v); }
inline Part3D linearPart(Vector6D& v) { return Cored::linearPart(v); }
inline Part3DConst angularPart(const Vector6D& v) { return Cored::angularPart(v); }
inline Part3DConst linearPart(const Vector6D& v) { return Cored::linearPart(v); }

enum Coords3D { X = 0, Y, Z };
enum Coords6D { AX = 0, AY, AZ, LX, LY, LZ };

/** Gravity on Earth, m/s^2. */
static const double g = 9.81;

}
}

#endif
