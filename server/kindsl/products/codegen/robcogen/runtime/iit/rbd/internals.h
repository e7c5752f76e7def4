// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_INTERNALS_H_
#define IIT_RBD_INTERNALS_H_
// The entries of 3x3 matrices by their names.

#include <iit/rbd/InertiaMatrix.h>

namespace iit {
namespace rbd {
namespace internal {

template <typename Scalar>
struct Mat3x3Coefficients {
    Scalar XX, XY, XZ, YX, YY, YZ, ZX, ZY, ZZ;

    Mat3x3Coefficients() {}
    Mat3x3Coefficients(
        Scalar xx, Scalar xy, Scalar xz, Scalar yx, Scalar yy, Scalar yz, Scalar zx, Scalar zy,
        Scalar zz)
        : XX(xx), XY(xy), XZ(xz), YX(yx), YY(yy), YZ(yz), ZX(zx), ZY(zy), ZZ(zz)
    {}
    template <typename D>
    Mat3x3Coefficients(const MatrixBase<D>& m)
    {
        read(m);
    }

    template <typename D>
    void read(const MatrixBase<D>& m)
    {
        *this = Mat3x3Coefficients(
            m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2));
    }
};

template <typename Scalar>
struct SymmMat3x3Coefficients {
    Scalar XX, XY, XZ, YY, YZ, ZZ;

    SymmMat3x3Coefficients() {}
    SymmMat3x3Coefficients(Scalar xx, Scalar xy, Scalar xz, Scalar yy, Scalar yz, Scalar zz)
        : XX(xx), XY(xy), XZ(xz), YY(yy), YZ(yz), ZZ(zz)
    {}
    template <typename D>
    SymmMat3x3Coefficients(const MatrixBase<D>& m)
    {
        read(m);
    }

    template <typename D>
    void read(const MatrixBase<D>& m)
    {
        *this = SymmMat3x3Coefficients(m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2));
    }
    template <typename D>
    void write(const MatrixBase<D>& to)
    {
        const_cast<MatrixBase<D>&>(to) << XX, XY, XZ, XY, YY, YZ, XZ, YZ, ZZ;
    }
};

/** B = E A E^T. */
template <typename Scalar>
inline void rot_EAET(
    const Mat3x3Coefficients<Scalar>& E, const Mat3x3Coefficients<Scalar>& A,
    Mat3x3Coefficients<Scalar>& B)
{
    PlainMatrix<Scalar, 3, 3> e, a;
    e << E.XX, E.XY, E.XZ, E.YX, E.YY, E.YZ, E.ZX, E.ZY, E.ZZ;
    a << A.XX, A.XY, A.XZ, A.YX, A.YY, A.YZ, A.ZX, A.ZY, A.ZZ;
    B.read((e * a * e.transpose()).eval());
}

/** B = E A E^T, both symmetric. */
template <typename Scalar>
inline void rot_symmetric_EAET(
    const Mat3x3Coefficients<Scalar>& E, const SymmMat3x3Coefficients<Scalar>& A,
    SymmMat3x3Coefficients<Scalar>& B)
{
    PlainMatrix<Scalar, 3, 3> e, a;
    e << E.XX, E.XY, E.XZ, E.YX, E.YY, E.YZ, E.ZX, E.ZY, E.ZZ;
    a << A.XX, A.XY, A.XZ, A.XY, A.YY, A.YZ, A.XZ, A.YZ, A.ZZ;
    B.read((e * a * e.transpose()).eval());
}

}
}
}

#endif
