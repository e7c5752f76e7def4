"""Transforms across many joints: the product of those across each, to keep headers short."""

from collections.abc import Iterator

from kindsl.codegen.robcogen.robot import GeneratedRobot
from kindsl.codegen.robcogen.wanted_names import NamedPair
from kindsl.dynamics.generation.jacobians import support
from kindsl.dynamics.generation.robot import PlacedFrame
from kindsl.dynamics.generation.terms import Scalar
from kindsl.dynamics.generation.vectors import EYE, ZERO, Matrix, Vector, transform, transpose

# One function of all joints is faster up to here, but its text is long: large robots have many.
MOST_JOINTS = 7
MOST_JOINTS_OF_LARGE = 2

# T has the columns of rotation and position; X those of a 6x6 transform.
HELPERS = """\
template <class S>
inline void fill(const S* T, S* X, int coupling)
{
    for (int j = 0; j < 3; j++) {
        const S *e = T + 4 * j, *r = T + 12;
        S *first = X + 6 * j, *second = X + 6 * j + 21, *cross = X + 6 * j + coupling;
        for (int i = 0; i < 3; i++) {
            first[i] = second[i] = e[i];
        }
        cross[0] = r[1] * e[2] - r[2] * e[1];
        cross[1] = r[2] * e[0] - r[0] * e[2];
        cross[2] = r[0] * e[1] - r[1] * e[0];
    }
}
template <class S>
inline void m_fill(const S* T, S* X) { fill(T, X, 3); }
template <class S>
inline void f_fill(const S* T, S* X) { fill(T, X, 18); }

/** T = T * B, and zeros in B. */
template <class S>
inline void append(S* T, S* B)
{
    for (int i = 0; i < 3; i++) {
        const S x = T[i], y = T[4 + i], z = T[8 + i];
        for (int j = 0; j < 3; j++) {
            T[4 * j + i] = x * B[4 * j] + y * B[4 * j + 1] + z * B[4 * j + 2];
        }
        T[12 + i] += x * B[12] + y * B[13] + z * B[14];
    }
    for (int k = 0; k < 16; k++) {
        B[k] = S(0);
    }
}
"""

_PRODUCT = """\
template <class TRAIT>
inline void h_@NAME@_constants(typename TRAIT::Scalar* X) { (void)X; }
template <class TRAIT>
inline void h_@NAME@(
    @TAKES@const typename TRAIT::Scalar* q, typename TRAIT::Scalar* X)
{
    typedef typename TRAIT::Scalar S;
    S B[16] = {};
    for (int k = 0; k < 16; k++) {
        X[k] = S(k % 5 == 0 ? 1 : 0);
    }
@STEPS@}
"""

_SHARING = """\
template <class TRAIT>
inline void @LETTER@_@NAME@_constants(typename TRAIT::Scalar* X) { (void)X; }
template <class TRAIT>
inline void @LETTER@_@NAME@(
    @TAKES@const typename TRAIT::Scalar* q, typename TRAIT::Scalar* X)
{
    typename TRAIT::Scalar T[16];
    h_@NAME@<TRAIT>(@P@q, T);
    @LETTER@_fill(T, X);
}
"""


def is_long(robot: GeneratedRobot, pair: NamedPair) -> bool:
    """Return whether a pair's frames are too many joints apart for one function."""
    most = MOST_JOINTS if not robot.is_large else MOST_JOINTS_OF_LARGE
    return len([*_across(robot, pair)]) > most


def long_kernels(robot: GeneratedRobot, pair: NamedPair) -> list[str]:
    """Return the functions of a pair's three matrices."""
    functions, steps = [], [*_across(robot, pair)]
    for end, (R, r) in (("base", _inverse(pair.base)), ("target", _pose(pair.target))):
        if (R, r) != (EYE, ZERO):
            name = f"{pair.name}_{end}"
            functions += robot.matrix_kernels(f"h_{name}", _columns(R, r))
            steps = [name, *steps] if end == "base" else [*steps, name]
    takes = "const typename TRAIT::Scalar* p, " if robot.has_parameters else ""
    p = "p, " if takes else ""
    calls = "".join(
        f"    h_{name}_constants<TRAIT>(B);\n    h_{name}<TRAIT>({p}q, B);\n    append(X, B);\n"
        for name in steps
    )
    values = {"NAME": pair.name, "TAKES": takes, "P": p, "STEPS": calls}
    functions.append(robot.filled(_PRODUCT, **values))
    return functions + [robot.filled(_SHARING, LETTER=letter, **values) for letter in "mf"]


def _across(robot: GeneratedRobot, pair: NamedPair) -> Iterator[str]:
    """Yield the transforms across joints from a pair's base to its target."""
    back, forth = (support(robot.tree, frame.body) for frame in (pair.base, pair.target))
    shared = len([None for a, b in zip(back, forth, strict=False) if a == b])
    for link in reversed(back[shared:]):
        yield robot.across(link)
    for link in forth[shared:]:
        yield f"{robot.frame(robot.tree.parents[link])}_X_{robot.frame(link)}"


def _pose(frame: PlacedFrame) -> tuple[Matrix, Vector]:
    return frame.R, frame.r


def _inverse(frame: PlacedFrame) -> tuple[Matrix, Vector]:
    E = transpose(frame.R)
    return E, [0.0 - x if x else 0.0 for x in transform(E, frame.r)]


def _columns(R: Matrix, r: Vector) -> list[list[Scalar]]:
    return [*([*column, 0.0] for column in transpose(R)), [*r, 1.0]]
