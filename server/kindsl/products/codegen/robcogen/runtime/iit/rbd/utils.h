// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_UTILS_H_
#define IIT_RBD_UTILS_H_
// Small helpers for programs that use generated code.

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>

#include <iit/rbd/rbd.h>

namespace iit {
namespace rbd {

class Utils {
public:
    struct InertiaMoments {
        double ixx;
        double iyy;
        double izz;
        double ixy;
        double ixz;
        double iyz;
    };

    /** Makes what is smaller than a threshold zero, for printing. */
    template <typename Scalar>
    struct CwiseAlmostZeroOp {
        CwiseAlmostZeroOp(const Scalar& threshold) : thresh(threshold) {}
        const Scalar operator()(const Scalar& x) const
        {
            return std::abs(x) < thresh ? Scalar(0) : x;
        }

    private:
        Scalar thresh;
    };

    template <typename Scalar>
    static Mat33<Scalar> buildInertiaTensor(
        Scalar Ixx, Scalar Iyy, Scalar Izz, Scalar Ixy, Scalar Ixz, Scalar Iyz)
    {
        Mat33<Scalar> I;
        I << Ixx, -Ixy, -Ixz, -Ixy, Iyy, -Iyz, -Ixz, -Iyz, Izz;
        return I;
    }

    static Matrix33d buildCrossProductMatrix(const Vector3d& v)
    {
        Matrix33d matrix;
        fillAsCrossProductMatrix(v, matrix);
        return matrix;
    }

    /** Rotates coordinates to a frame that is turned about x, then its y, then its z axis. */
    template <typename Derived>
    static void fillAsRotationMatrix(
        double rx, double ry, double rz, const MatrixBase<Derived>& matrix)
    {
        const_cast<MatrixBase<Derived>&>(matrix) = buildRotationMatrix(rx, ry, rz);
    }
    static Matrix33d buildRotationMatrix(double rx, double ry, double rz)
    {
        return (Eigen::AngleAxisd(rx, Vector3d::UnitX()) * Eigen::AngleAxisd(ry, Vector3d::UnitY())
                * Eigen::AngleAxisd(rz, Vector3d::UnitZ()))
            .toRotationMatrix()
            .transpose();
    }

    template <typename Scalar>
    static void fillAsMotionCrossProductMx(
        const PlainMatrix<Scalar, 6, 1>& v, PlainMatrix<Scalar, 6, 6>& matrix)
    {
        PlainMatrix<Scalar, 3, 3> w, u;
        fillAsCrossProductMatrix(v.template head<3>(), w);
        fillAsCrossProductMatrix(v.template tail<3>(), u);
        matrix << w, PlainMatrix<Scalar, 3, 3>::Zero(), u, w;
    }
    template <typename Scalar>
    static void fillAsForceCrossProductMx(
        const PlainMatrix<Scalar, 6, 1>& v, PlainMatrix<Scalar, 6, 6>& matrix)
    {
        PlainMatrix<Scalar, 6, 6> motion;
        fillAsMotionCrossProductMx(v, motion);
        matrix = -motion.transpose();
    }
    template <typename D1, typename D2>
    static void fillAsCrossProductMatrix(const MatrixBase<D2>& v, const MatrixBase<D1>& matrix)
    {
        typedef typename D2::Scalar Scalar;
        const_cast<MatrixBase<D1>&>(matrix) << Scalar(0), -v(2), v(1), v(2), Scalar(0), -v(0),
            -v(1), v(0), Scalar(0);
    }

    /** Of a homogeneous transform. */
    template <typename Derived>
    static const MatrixBlock<const Derived, 3, 1> positionVector(const MatrixBase<Derived>& T)
    {
        return MatrixBlock<const Derived, 3, 1>(T.derived(), 0, 3);
    }
    template <typename Derived>
    static const MatrixBlock<const Derived, 3, 3> rotationMx(const MatrixBase<Derived>& T)
    {
        return MatrixBlock<const Derived, 3, 3>(T.derived(), 0, 0);
    }
    template <typename Derived>
    static const MatrixBlock<const Derived, 3, 1> zAxis(const MatrixBase<Derived>& T)
    {
        return MatrixBlock<const Derived, 3, 1>(T.derived(), 0, 2);
    }

    /** A point in other coordinates. */
    template <typename Derived, typename Other>
    static Vector3d transform(const MatrixBase<Derived>& T, const MatrixBase<Other>& point)
    {
        return rotationMx(T) * point + positionVector(T);
    }

    static void randomVec(Vector6D& v)
    {
        std::srand(static_cast<unsigned>(std::time(nullptr)));
        for (int i = 0; i < 6; i++) {
            v(i) = fraction();
        }
    }
    /** Gravity of the usual strength in some direction. */
    static void randomGravity(VelocityVector& gravity)
    {
        randomVec(gravity);
        gravity.head<3>().setZero();
        gravity.tail<3>() *= iit::rbd::g / gravity.tail<3>().norm();
    }

    template <class RT>
    static void cmdlineargs_spatialv(int argc, char** argv, Vector6D& v)
    {
        if (argc < 6) {
            std::cerr << "six numbers are needed" << std::endl;
            std::exit(-1);
        }
        for (int i = 0; i < 6; i++) {
            v(i) = std::atof(argv[i]);
        }
    }

private:
    static double fraction() { return static_cast<double>(std::rand()) / RAND_MAX; }
};

}
}

#endif
