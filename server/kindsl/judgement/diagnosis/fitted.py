"""Written by `benchmarks/fit_judge.py`, which says of what and how."""

from kindsl.judgement.diagnosis.tables import Table

TABLES = {
    "density": Table(
        -6.0,
        1.0,
        (
            -2.31,
            -1.25,
            -1.57,
            -2.44,
            -2.13,
            -1.59,
            -1.15,
            -1.16,
            -1.23,
            -0.77,
            -0.19,
            0.37,
            1.31,
            1.66,
            1.21,
            0.05,
            -1.91,
            -2.26,
            -2.37,
            -2.11,
            -2.11,
        ),
    ),
    "thickness": Table(
        -9.0,
        0.75,
        (-2.23, -2.26, -2.19, -2.09, -1.55, -0.98, -0.54, -0.14, 0.47, 0.74, 0.85, 0.64, 0.22),
    ),
    "width": Table(
        -7.5, 0.75, (-3.23, -3.22, -3.09, -2.56, -1.71, -0.72, -0.11, 0.54, 0.92, 1.16, 0.86)
    ),
    "mass": Table(
        -6.0, 1.0, (-3.24, -2.91, -1.86, -0.97, 0.01, 0.85, 1.54, 1.04, -0.26, -1.36, -2.28, -2.15)
    ),
    "gyration": Table(
        -7.0, 1.0, (-0.43, -0.36, -0.09, 0.14, 0.22, 0.15, -0.04, -0.23, -0.39, -0.46, -0.46)
    ),
    "distance": Table(
        -9.0,
        1.0,
        (-2.96, -2.58, -1.97, -1.32, -0.16, 0.97, 1.53, 1.30, 0.05, -1.88, -3.08, -3.17, -3.17),
    ),
    "place": Table(
        -6.0, 1.0, (-0.23, -0.30, -0.16, -0.06, 0.00, 0.10, 0.15, 0.08, -0.18, -0.32, -0.31)
    ),
    "size": Table(
        -5.0,
        0.75,
        (-1.55, -1.37, -1.19, -0.98, 0.00, 0.82, 0.78, 0.19, -0.32, -0.59, -1.13, -1.54, -1.59),
    ),
    "reach": Table(
        -6.0,
        0.75,
        (-3.02, -2.78, -2.53, -2.57, -1.42, -0.63, 0.68, 1.77, 1.29, -0.75, -2.86, -3.03, -3.03),
    ),
    "side": Table(-1.0, 0.25, (-1.22, -1.50, -2.26, -2.23, -2.20, -1.35, -0.91, 0.74, 1.49)),
    "direction": Table(0.0, 0.125, (-0.80, -1.05, -1.20, -0.98, -0.89, -0.64, -0.52, 0.39, 0.85)),
}
# Along the axes, turned about one, tilted a little, anyhow.
LIES = (0.228, 0.226, 0.421, 0.125)
TRUST, EXPECTED, MIRRORED = 0.45, 7.67, 4.94
AS_WRITTEN, UNKNOWN = 1.69, -0.42
WEIGHTS = {
    "CoM in another unit": 0.58,
    "copied from another link": -0.18,
    "mass + digit": 0.95,
    "mass + unit": 0.32,
    "moments about other axes": 0.14,
    "moments in rows of the tensor": 0.12,
    "placeholder": -0.97,
    "power of ten of a moment": 0.16,
    "reference": -0.58,
    "reference + signs": -0.47,
    "scale + digit": -0.00,
    "scale + reference + unit": 0.48,
    "scale + signs + unit": -0.11,
    "scale + unit": -0.33,
    "shifted twice": 0.06,
    "sign of a moment": 0.09,
    "sign of the CoM": 0.00,
    "signs": -0.25,
    "signs + moments in rows of the tensor": -0.03,
    "two coordinates of the CoM swapped": 0.11,
    "two moments swapped": -0.07,
}
