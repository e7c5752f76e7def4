"""Written by `benchmarks/fit_judge.py`, which says of what and how."""

from kindsl.judgement.diagnosis.tables import LikelihoodTable

TABLES = {
    "density": LikelihoodTable(
        -6.0,
        1.0,
        (
            -1.74,
            -0.83,
            -1.10,
            -1.93,
            -1.76,
            -1.13,
            -0.82,
            -0.95,
            -0.84,
            -0.56,
            -0.10,
            0.22,
            1.02,
            1.33,
            0.92,
            -0.14,
            -1.60,
            -1.70,
            -1.81,
            -1.56,
            -1.56,
        ),
    ),
    "thickness": LikelihoodTable(
        -9.0,
        0.75,
        (-2.55, -2.48, -2.37, -2.24, -1.56, -0.90, -0.43, -0.11, 0.51, 0.76, 0.85, 0.71, 0.34),
    ),
    "width": LikelihoodTable(
        -7.5, 0.75, (-3.83, -3.82, -3.63, -2.92, -1.84, -0.73, -0.05, 0.63, 1.02, 1.35, 1.03)
    ),
    "mass": LikelihoodTable(
        -6.0, 1.0, (-4.66, -4.49, -3.30, -1.68, -0.12, 1.25, 2.24, 1.57, -0.23, -2.03, -3.69, -3.55)
    ),
    "gyration": LikelihoodTable(
        -7.0, 1.0, (-0.62, -0.55, -0.24, 0.16, 0.33, 0.25, -0.06, -0.31, -0.56, -0.68, -0.68)
    ),
    "distance": LikelihoodTable(
        -9.0,
        1.0,
        (-3.20, -3.15, -2.53, -1.41, -0.16, 0.94, 1.67, 1.52, 0.13, -2.31, -3.43, -3.48, -3.48),
    ),
    "place": LikelihoodTable(
        -6.0, 1.0, (0.19, 0.23, 0.17, 0.05, -0.03, -0.09, -0.11, -0.03, 0.17, 0.24, 0.23)
    ),
    "size": LikelihoodTable(
        -5.0,
        0.75,
        (-1.45, -1.25, -1.12, -0.95, -0.12, 0.75, 0.76, 0.24, -0.24, -0.52, -1.05, -1.45, -1.50),
    ),
    "reach": LikelihoodTable(
        -6.0,
        0.75,
        (-3.58, -3.58, -3.57, -3.14, -1.76, -0.60, 0.84, 2.07, 1.54, -0.81, -3.36, -3.58, -3.58),
    ),
    "side": LikelihoodTable(
        -1.0, 0.25, (-1.61, -2.13, -2.80, -2.60, -2.73, -1.50, -1.04, 0.92, 1.81)
    ),
    "direction": LikelihoodTable(
        0.0, 0.125, (-0.55, -0.81, -1.03, -0.78, -0.66, -0.51, -0.43, 0.32, 0.66)
    ),
}
# Along the axes, turned about one, tilted a little, anyhow.
LIES = (0.199, 0.194, 0.484, 0.123)
TRUST, EXPECTED, MIRRORED = 0.38, 8.39, 5.38
AS_WRITTEN, UNKNOWN = 1.86, -0.85
WEIGHTS = {
    "CoM in another unit": 0.21,
    "mass + digit": 1.20,
    "mass + unit": 0.22,
    "moments about other axes": 0.22,
    "moments in rows of the tensor": 0.07,
    "one number typed anew": -0.05,
    "placeholder": -1.04,
    "power of ten of a moment": 0.02,
    "reference": -0.68,
    "reference + signs": -0.36,
    "scale + digit": -0.00,
    "scale + reference + unit": 0.59,
    "scale + signs + unit": -0.05,
    "scale + unit": -0.42,
    "shifted twice": -0.00,
    "sign of a moment": 0.02,
    "sign of the CoM": 0.04,
    "signs": -0.25,
    "signs + moments in rows of the tensor": -0.05,
    "two coordinates of the CoM swapped": 0.02,
    "two moments swapped": 0.04,
}
