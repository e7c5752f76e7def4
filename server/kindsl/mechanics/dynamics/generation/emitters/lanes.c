#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Lanes: several configurations in the parts of one wide register, where the processor has them
 * for numbers in double; `LANES` is not defined where it has not. */
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__)) && !defined(NO_LANES)         \
    && !defined(__FAST_MATH__) && !defined(__ASSOCIATIVE_MATH__) && !defined(__OPTIMIZE_SIZE__)
#if defined(__AVX512F__)
#define LANES 8
#elif defined(__AVX__)
#define LANES 4
#else
#define LANES 2
#endif
typedef double lanes __attribute__((vector_size(LANES * 8)));
typedef int64_t bits __attribute__((vector_size(LANES * 8)));
#define LARGEST_ANGLE 1e4

static inline lanes spread(double x)
{
    return (lanes){0} + x;
}

/* Sine and cosine by reduction to an eighth of a turn, pi/2 in three parts whose products with
 * small integers are exact, and their series, whose rest is below a unit of the last place. */
static inline lanes signs(lanes x)
{
    const bits one = (bits)spread(1.0);
    return (lanes)((x > 0.0) & one) - (lanes)((x < 0.0) & one);
}

static inline void small_sine_and_cosine(lanes x, lanes *sine, lanes *cosine)
{
    const double rounding = 6755399441055744.0; /* 3 * 2^51: adding it rounds to an integer */
    const lanes shifted = x * 0.63661977236758134308 + rounding;
    const lanes k = shifted - rounding;
    const lanes r = ((x - k * 0x1.921fb544p0) - k * 0x1.0b4611a6p-34) - k * 0x1.3198a2e037073p-69;
    const lanes z = r * r;
    const lanes s = r + r * z * (-1.0 / 6 + z * (1.0 / 120 + z * (-1.0 / 5040 + z * (1.0 / 362880
        + z * (-1.0 / 39916800 + z * (1.0 / 6227020800.0 + z * (-1.0 / 1307674368000.0
        + z * (1.0 / 355687428096000.0))))))));
    const lanes c = 1.0 - 0.5 * z + z * z * (1.0 / 24 + z * (-1.0 / 720 + z * (1.0 / 40320
        + z * (-1.0 / 3628800 + z * (1.0 / 479001600.0 + z * (-1.0 / 87178291200.0
        + z * (1.0 / 20922789888000.0)))))));
    const bits quarter = (bits)shifted, swap = -(quarter & 1);
    const bits s_bits = (bits)s, c_bits = (bits)c;
    *sine = (lanes)(((swap & c_bits) | (~swap & s_bits)) ^ ((quarter & 2) << 62));
    *cosine = (lanes)(((swap & s_bits) | (~swap & c_bits)) ^ (((quarter + 1) & 2) << 62));
}

static inline void sines_and_cosines(const lanes *angles, lanes *sines, lanes *cosines, int n)
{
    bits large = {0};
    int i, k;
    for (k = 0; k < n; k++) {
        small_sine_and_cosine(angles[k], &sines[k], &cosines[k]);
        large |= ~((angles[k] <= LARGEST_ANGLE) & (angles[k] >= -LARGEST_ANGLE));
    }
    for (i = 0; i < LANES; i++) {
        for (k = 0; k < n && large[i]; k++) {
            sines[k][i] = sin(angles[k][i]);
            cosines[k][i] = cos(angles[k][i]);
        }
    }
}

/* The lanes of `a` and `b` in turns: of their first halves, and of their second. */
#if defined(__clang__) || __GNUC__ >= 12
#define MIXED(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define MIXED(a, b, ...) __builtin_shuffle(a, b, (bits){__VA_ARGS__})
#endif
#if LANES == 8
#define FIRST_IN_TURNS(a, b) MIXED(a, b, 0, 8, 1, 9, 2, 10, 3, 11)
#define SECOND_IN_TURNS(a, b) MIXED(a, b, 4, 12, 5, 13, 6, 14, 7, 15)
#elif LANES == 4
#define FIRST_IN_TURNS(a, b) MIXED(a, b, 0, 4, 1, 5)
#define SECOND_IN_TURNS(a, b) MIXED(a, b, 2, 6, 3, 7)
#else
#define FIRST_IN_TURNS(a, b) MIXED(a, b, 0, 2)
#define SECOND_IN_TURNS(a, b) MIXED(a, b, 1, 3)
#endif

/* Transpose a square: each round doubles the length of what lies in order. */
static inline void transpose(lanes *to, const lanes *from)
{
    lanes rows[LANES];
    memcpy(to, from, sizeof rows);
#pragma GCC unroll 3
    for (int length = 1; length < LANES; length *= 2) {
        memcpy(rows, to, sizeof rows);
#pragma GCC unroll 4
        for (int i = 0; i < LANES / 2; i++) {
            to[2 * i] = FIRST_IN_TURNS(rows[i], rows[i + LANES / 2]);
            to[2 * i + 1] = SECOND_IN_TURNS(rows[i], rows[i + LANES / 2]);
        }
    }
}

/* Read `width` rows that lie `stride` apart into lanes; lanes without a row repeat the first. */
static inline void gather(lanes *to, const double *from, ptrdiff_t stride, ptrdiff_t length,
                          ptrdiff_t width)
{
    ptrdiff_t i = 0;
    if (width < LANES || length < LANES) {
        for (; i < length; i++) {
            lanes x = {0};
            for (ptrdiff_t j = 0; j < LANES; j++) {
                x[j] = from[(j < width ? j : 0) * stride + i];
            }
            to[i] = x;
        }
    }
    for (; i < length; i += LANES) {
        lanes rows[LANES];
        i = i < length - LANES ? i : length - LANES;
#pragma GCC unroll 8
        for (int j = 0; j < LANES; j++) {
            memcpy(&rows[j], &from[j * stride + i], sizeof rows[j]);
        }
        transpose(&to[i], rows);
    }
}

/* Write lanes into `width` rows that follow one another. */
static inline void scatter(double *to, const lanes *from, ptrdiff_t length, ptrdiff_t width)
{
    ptrdiff_t i = 0;
    if (width < LANES || length < LANES) {
        for (; i < length; i++) {
            for (ptrdiff_t j = 0; j < width; j++) {
                to[j * length + i] = from[i][j];
            }
        }
    }
    for (; i < length; i += LANES) {
        lanes rows[LANES];
        i = i < length - LANES ? i : length - LANES;
        transpose(rows, &from[i]);
#pragma GCC unroll 8
        for (int j = 0; j < LANES; j++) {
            memcpy(&to[j * length + i], &rows[j], sizeof rows[j]);
        }
    }
}
#endif
