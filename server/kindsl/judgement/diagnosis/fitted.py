"""Written by `benchmarks/fit_judge.py`, which says of what and how."""

from kindsl.judgement.diagnosis.tables import LikelihoodTable

TABLES = {
    "density": LikelihoodTable(
        -6.0,
        1.0,
        (
            -2.37,
            -1.29,
            -1.62,
            -2.50,
            -2.19,
            -1.63,
            -1.18,
            -1.19,
            -1.26,
            -0.79,
            -0.20,
            0.38,
            1.34,
            1.71,
            1.24,
            0.05,
            -1.96,
            -2.32,
            -2.43,
            -2.16,
            -2.16,
        ),
    ),
    "thickness": LikelihoodTable(
        -9.0,
        0.75,
        (-2.29, -2.32, -2.24, -2.15, -1.59, -1.00, -0.56, -0.14, 0.49, 0.76, 0.87, 0.65, 0.22),
    ),
    "width": LikelihoodTable(
        -7.5, 0.75, (-3.28, -3.27, -3.14, -2.60, -1.74, -0.73, -0.11, 0.55, 0.93, 1.18, 0.88)
    ),
    "mass": LikelihoodTable(
        -6.0, 1.0, (-3.41, -3.07, -1.96, -1.03, 0.01, 0.90, 1.62, 1.10, -0.27, -1.44, -2.41, -2.27)
    ),
    "gyration": LikelihoodTable(
        -7.0, 1.0, (-0.47, -0.40, -0.10, 0.15, 0.24, 0.16, -0.05, -0.25, -0.43, -0.50, -0.51)
    ),
    "distance": LikelihoodTable(
        -9.0,
        1.0,
        (-3.47, -3.02, -2.30, -1.55, -0.19, 1.14, 1.80, 1.52, 0.06, -2.21, -3.60, -3.72, -3.72),
    ),
    "place": LikelihoodTable(
        -6.0, 1.0, (-0.19, -0.22, -0.12, -0.05, 0.00, 0.08, 0.11, 0.06, -0.13, -0.24, -0.23)
    ),
    "size": LikelihoodTable(
        -5.0,
        0.75,
        (-1.51, -1.34, -1.17, -0.96, 0.00, 0.80, 0.76, 0.18, -0.32, -0.58, -1.11, -1.51, -1.56),
    ),
    "reach": LikelihoodTable(
        -6.0,
        0.75,
        (-3.82, -3.51, -3.19, -3.24, -1.80, -0.79, 0.86, 2.24, 1.63, -0.95, -3.61, -3.83, -3.83),
    ),
    "side": LikelihoodTable(
        -1.0, 0.25, (-1.15, -1.42, -2.14, -2.11, -2.08, -1.28, -0.86, 0.70, 1.40)
    ),
    "direction": LikelihoodTable(
        0.0, 0.125, (-0.76, -1.00, -1.15, -0.94, -0.85, -0.61, -0.50, 0.37, 0.82)
    ),
}
# Along the axes, turned about one, tilted a little, anyhow.
LIES = (0.228, 0.226, 0.421, 0.125)
TRUST, EXPECTED, MIRRORED = 0.49, 7.83, 5.03
AS_WRITTEN, UNKNOWN = 1.77, -0.32
WEIGHTS = {
    "CoM in another unit": 0.53,
    "copied from another link": -0.18,
    "mass + digit": 0.93,
    "mass + unit": 0.32,
    "moments about other axes": 0.14,
    "moments in rows of the tensor": 0.11,
    "placeholder": -0.97,
    "power of ten of a moment": 0.15,
    "reference": -0.54,
    "reference + signs": -0.43,
    "scale + digit": -0.00,
    "scale + reference + unit": 0.48,
    "scale + signs + unit": -0.12,
    "scale + unit": -0.32,
    "shifted twice": 0.06,
    "sign of a moment": 0.09,
    "sign of the CoM": 0.01,
    "signs": -0.25,
    "signs + moments in rows of the tensor": -0.03,
    "two coordinates of the CoM swapped": 0.10,
    "two moments swapped": -0.08,
}
