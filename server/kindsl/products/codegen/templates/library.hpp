@STAMP@#pragma once
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace @PREFIX@ {

constexpr int n_joints = @NJ@;
constexpr int n_velocities = @NV@;
constexpr int n_bodies = @NB@;

/* What is known only at run time, with the values that it had when this was generated. */
struct Parameters {
@FIELDS@};

namespace detail {

template <class S>
inline S sin(const S& x)
{
    using std::sin;
    return sin(x);
}

template <class S>
inline S cos(const S& x)
{
    using std::cos;
    return cos(x);
}

@SIGN@@FUNCTIONS@
} // namespace detail

/* S is any type of numbers, automatic derivatives' too. All functions are pure. */
template <class S>
class BasicModel {
public:
    using Scalar = S;
    /* By rows, but for columns. */
    template <int rows, int columns>
    using Matrix =
        Eigen::Matrix<S, rows, columns, columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
    template <int rows>
    using Vector = Matrix<rows, 1>;
    using JointVector = Vector<n_joints>;
    /* One column a body: the wrench on it in its own coordinates. */
    using ExternalForces = Eigen::Matrix<S, 6, n_bodies>;

@BOUND@    explicit BasicModel(const Parameters& parameters) { set(parameters); }

    void set(const Parameters& parameters)
    {
@SETTING@    }

@METHODS@
private:
    S c_[@SIZE@] = {};
};

using Model = BasicModel<@REAL@>;
template <int rows, int columns>
using Matrix = Model::Matrix<rows, columns>;
template <int rows>
using Vector = Model::Vector<rows>;
using JointVector = Model::JointVector;
using ExternalForces = Model::ExternalForces;

} // namespace @PREFIX@
