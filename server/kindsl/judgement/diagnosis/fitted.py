"""Written by `benchmarks/fit_judge.py`, which says of what and how."""

from kindsl.judgement.diagnosis.tables import LikelihoodTable

TABLES = {
    "density": LikelihoodTable(
        -6.0,
        1.0,
        (
            -1.76,
            -0.84,
            -1.11,
            -1.95,
            -1.77,
            -1.14,
            -0.83,
            -0.96,
            -0.85,
            -0.56,
            -0.10,
            0.23,
            1.02,
            1.34,
            0.93,
            -0.14,
            -1.62,
            -1.72,
            -1.82,
            -1.57,
            -1.57,
        ),
    ),
    "thickness": LikelihoodTable(
        -9.0,
        0.75,
        (-2.59, -2.51, -2.40, -2.27, -1.59, -0.91, -0.43, -0.11, 0.52, 0.77, 0.87, 0.72, 0.35),
    ),
    "width": LikelihoodTable(
        -7.5, 0.75, (-3.90, -3.89, -3.70, -2.98, -1.87, -0.74, -0.05, 0.64, 1.04, 1.38, 1.05)
    ),
    "mass": LikelihoodTable(
        -6.0, 1.0, (-4.74, -4.57, -3.36, -1.71, -0.13, 1.27, 2.29, 1.60, -0.24, -2.06, -3.76, -3.62)
    ),
    "gyration": LikelihoodTable(
        -7.0, 1.0, (-0.58, -0.51, -0.22, 0.15, 0.31, 0.23, -0.05, -0.30, -0.52, -0.63, -0.64)
    ),
    "distance": LikelihoodTable(
        -9.0,
        1.0,
        (-3.24, -3.20, -2.56, -1.43, -0.16, 0.95, 1.69, 1.54, 0.13, -2.34, -3.48, -3.52, -3.52),
    ),
    "place": LikelihoodTable(
        -6.0, 1.0, (0.16, 0.20, 0.15, 0.04, -0.02, -0.08, -0.09, -0.03, 0.14, 0.21, 0.20)
    ),
    "size": LikelihoodTable(
        -5.0,
        0.75,
        (-1.50, -1.29, -1.15, -0.98, -0.12, 0.77, 0.79, 0.25, -0.25, -0.53, -1.08, -1.50, -1.55),
    ),
    "reach": LikelihoodTable(
        -6.0,
        0.75,
        (-3.58, -3.58, -3.57, -3.14, -1.75, -0.60, 0.84, 2.07, 1.54, -0.81, -3.35, -3.58, -3.58),
    ),
    "side": LikelihoodTable(
        -1.0, 0.25, (-1.61, -2.14, -2.82, -2.61, -2.74, -1.50, -1.04, 0.92, 1.82)
    ),
    "direction": LikelihoodTable(
        0.0, 0.125, (-0.56, -0.82, -1.05, -0.79, -0.67, -0.52, -0.44, 0.32, 0.67)
    ),
}
# Along the axes, turned about one, tilted a little, anyhow.
LIES = (0.199, 0.194, 0.484, 0.123)
TRUST, EXPECTED, MIRRORED = 0.38, 8.70, 5.72
AS_WRITTEN, UNKNOWN = 1.96, -0.87
WEIGHTS = {
    "CoM in another unit": 0.21,
    "copied from another link": -0.07,
    "mass + digit": 1.21,
    "mass + unit": 0.21,
    "moments about other axes": 0.21,
    "moments in rows of the tensor": 0.07,
    "placeholder": -1.04,
    "power of ten of a moment": 0.05,
    "reference": -0.67,
    "reference + signs": -0.35,
    "scale + digit": -0.00,
    "scale + reference + unit": 0.58,
    "scale + signs + unit": -0.05,
    "scale + unit": -0.41,
    "shifted twice": -0.00,
    "sign of a moment": 0.02,
    "sign of the CoM": 0.05,
    "signs": -0.24,
    "signs + moments in rows of the tensor": -0.05,
    "two coordinates of the CoM swapped": 0.01,
    "two moments swapped": 0.02,
}
