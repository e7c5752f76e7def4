// SPDX-License-Identifier: BSD-3-Clause
#ifndef IIT_RBD_SCALAR_TRAITS_H_
#define IIT_RBD_SCALAR_TRAITS_H_
// The functions of numbers that generated code calls.

#include <cmath>

#include <iit/rbd/rbd.h>

namespace iit {
namespace rbd {

/** Of any type that has them beside it, such as those of automatic differentiation. */
template <typename SCALAR>
struct AnyTrait {
    typedef SCALAR Scalar;

    static Scalar sin(const Scalar& x) { using std::sin; return sin(x); }
    static Scalar cos(const Scalar& x) { using std::cos; return cos(x); }
    static Scalar tan(const Scalar& x) { using std::tan; return tan(x); }
    static Scalar sinh(const Scalar& x) { using std::sinh; return sinh(x); }
    static Scalar cosh(const Scalar& x) { using std::cosh; return cosh(x); }
    static Scalar tanh(const Scalar& x) { using std::tanh; return tanh(x); }
    static Scalar exp(const Scalar& x) { using std::exp; return exp(x); }
    static Scalar fabs(const Scalar& x) { using std::fabs; return fabs(x); }
    static Scalar sqrt(const Scalar& x) { using std::sqrt; return sqrt(x); }

    template <int Rows, int Cols>
    static PlainMatrix<Scalar, Cols, 1> solve(
        const PlainMatrix<Scalar, Rows, Cols>& A, const PlainMatrix<Scalar, Rows, 1>& b)
    {
        return A.inverse() * b;
    }
};

struct DoubleTrait : AnyTrait<double> {};
struct FloatTrait : AnyTrait<float> {};

/** As RobCoGen 0.5 calls them. */
template <typename SCALAR>
struct ScalarTraits : AnyTrait<SCALAR> {};
typedef ScalarTraits<double> DoubleTraits;
typedef ScalarTraits<float> FloatTraits;

}
}

#endif
