// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_ROBCOGEN_COMMONS_H_
#define IIT_RBD_ROBCOGEN_COMMONS_H_
// Functions of spatial vectors and inertias that programs for generated code use too.

#include <iit/rbd/InertiaMatrix.h>
#include <iit/rbd/TransformsBase.h>
#include <iit/rbd/internals.h>
#include <iit/rbd/rbd.h>

namespace iit {
namespace rbd {

/** The force v x* I v that a body takes to keep its velocity. */
template <typename Derived>
Force<typename Derived::Scalar> vxIv(
    const Velocity<typename Derived::Scalar>& v, const MatrixBase<Derived>& I)
{
    typedef Vec3<typename Derived::Scalar> V;
    const Force<typename Derived::Scalar> h = I * v;
    const V w = v.template head<3>(), u = v.template tail<3>();
    const V turning = h.template head<3>(), moving = h.template tail<3>();
    Force<typename Derived::Scalar> f;
    f << V(w.cross(turning) + u.cross(moving)), V(w.cross(moving));
    return f;
}

/** The same where the body turns about z only. */
template <typename Derived>
inline Force<typename Derived::Scalar> vxIv(
    const typename Derived::Scalar& omegaz, const MatrixBase<Derived>& I)
{
    Velocity<typename Derived::Scalar> v = Velocity<typename Derived::Scalar>::Zero();
    v(AZ) = omegaz;
    return vxIv(v, I);
}

/** The matrix of m -> v x m for motion vectors. */
template <typename S = double>
inline void motionCrossProductMx(const Velocity<S>& v, Mat66<S>& vx)
{
    Mat33<S> w, u;
    w << S(0), -v(AZ), v(AY), v(AZ), S(0), -v(AX), -v(AY), v(AX), S(0);
    u << S(0), -v(LZ), v(LY), v(LZ), S(0), -v(LX), -v(LY), v(LX), S(0);
    vx << w, Mat33<S>::Zero(), u, w;
}

/** The matrix of f -> v x* f for force vectors. */
template <typename S = double>
inline void forceCrossProductMx(const Velocity<S>& v, Mat66<S>& vx)
{
    Mat66<S> motion;
    motionCrossProductMx<S>(v, motion);
    vx = -motion.transpose();
}

template <typename S = double>
void fillInertia(
    S mass, const Vec3<S>& com, const internal::SymmMat3x3Coefficients<S>& moments,
    InertiaMat<S>& I)
{
    Mat33<S> m;
    m << moments.XX, moments.XY, moments.XZ, moments.XY, moments.YY, moments.YZ, moments.XZ,
        moments.YZ, moments.ZZ;
    I.fill(mass, com, m);
}

/** An inertia in other coordinates; XF maps forces to these. */
template <typename Scalar = double>
void transformInertia(
    const InertiaMat<Scalar>& I_A, const Mat66<Scalar>& XF, InertiaMat<Scalar>& I_B)
{
    I_B = (XF * I_A * XF.transpose()).eval();
}

/** An articulated inertia in other coordinates; XM maps motions from these. */
template <typename D1, typename D2, typename D3>
void ctransform_Ia_revolute(
    const MatrixBase<D1>& Ia_A, const MatrixBase<D2>& XM, const MatrixBase<D3>& Ia_B)
{
    const_cast<MatrixBase<D3>&>(Ia_B) = (XM.transpose() * Ia_A * XM).eval();
}

template <typename D1, typename D2, typename D3>
void ctransform_Ia_prismatic(
    const MatrixBase<D1>& Ia_A, const MatrixBase<D2>& XM, const MatrixBase<D3>& Ia_B)
{
    ctransform_Ia_revolute(Ia_A, XM, Ia_B);
}

namespace internal {

template <int Free, typename D1, typename D2>
void withoutJoint(
    const MatrixBase<D1>& IA, const Vec6<typename D1::Scalar>& U, const typename D1::Scalar& D,
    const MatrixBase<D2>& Ia_out)
{
    MatrixBase<D2>& Ia = const_cast<MatrixBase<D2>&>(Ia_out);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            if (i != Free && j != Free) {
                Ia(i, j) = IA(i, j) - U(i) * (U(j) / D);
            }
        }
    }
}

}

/** The articulated inertia beyond a joint, whose zero row and column are left as they are. */
template <typename D1, typename D2>
void compute_Ia_revolute(
    const MatrixBase<D1>& IA, const Vec6<typename D1::Scalar>& U, const typename D1::Scalar& D,
    const MatrixBase<D2>& Ia)
{
    internal::withoutJoint<AZ>(IA, U, D, Ia);
}

template <typename D1, typename D2>
void compute_Ia_prismatic(
    const MatrixBase<D1>& IA, const Vec6<typename D1::Scalar>& U, const typename D1::Scalar& D,
    const MatrixBase<D2>& Ia)
{
    internal::withoutJoint<LZ>(IA, U, D, Ia);
}

}
}

#endif
