"""Written by `benchmarks/fit_judge.py`, which says of what and how."""

# fmt: off
from kindsl.judgement.diagnosis.tables import LikelihoodTable

TABLES = {
    "density": LikelihoodTable(-6.0, 1.0, (-1.47, -0.70, -0.93, -1.63, -1.48, -0.95, -0.70, -0.80,
        -0.71, -0.47, -0.09, 0.19, 0.86, 1.12, 0.78, -0.12, -1.35, -1.44, -1.52, -1.32, -1.32)),
    "thickness": LikelihoodTable(-9.0, 0.75, (-1.71, -1.66, -1.59, -1.50, -1.05, -0.60, -0.29,
        -0.07, 0.34, 0.51, 0.57, 0.48, 0.23)),
    "width": LikelihoodTable(-7.5, 0.75, (-4.11, -4.10, -3.89, -3.14, -1.97, -0.78, -0.05, 0.67,
        1.10, 1.45, 1.11)),
    "mass": LikelihoodTable(-6.0, 1.0, (-5.03, -4.85, -3.57, -1.82, -0.13, 1.35, 2.42, 1.70, -0.25,
        -2.19, -3.99, -3.84)),
    "gyration": LikelihoodTable(-7.0, 1.0, (-1.25, -1.10, -0.48, 0.32, 0.67, 0.49, -0.11, -0.63,
        -1.12, -1.36, -1.37)),
    "distance": LikelihoodTable(-9.0, 1.0, (-2.75, -2.71, -2.17, -1.21, -0.14, 0.81, 1.43, 1.30,
        0.11, -1.98, -2.95, -2.99, -2.99)),
    "place": LikelihoodTable(-6.0, 1.0, (-0.34, -0.32, -0.32, -0.24, -0.06, 0.06, 0.16, 0.15, -0.06,
        -0.28, -0.33)),
    "size": LikelihoodTable(-5.0, 0.75, (-1.41, -1.21, -1.08, -0.92, -0.11, 0.72, 0.74, 0.23, -0.23,
        -0.50, -1.01, -1.41, -1.46)),
    "reach": LikelihoodTable(-6.0, 0.75, (-4.67, -4.67, -4.66, -4.10, -2.29, -0.78, 1.09, 2.70,
        2.01, -1.06, -4.38, -4.67, -4.67)),
    "side": LikelihoodTable(-1.0, 0.25, (-1.73, -2.29, -3.01, -2.80, -2.93, -1.61, -1.12, 0.99,
        1.94)),
    "direction": LikelihoodTable(0.0, 0.125, (-0.81, -1.18, -1.51, -1.13, -0.96, -0.75, -0.63, 0.46,
        0.97)),
}
# Along the axes, turned about one, tilted a little, anyhow.
LIES = (0.199, 0.194, 0.484, 0.123)
TRUST, EXPECTED, MIRRORED = 0.33, 9.50, 6.50
AS_WRITTEN, UNKNOWN = 1.79, -1.55
WEIGHTS = {
    "CoM in another unit": -0.05,
    "mass + digit": 1.00,
    "mass + unit": 0.35,
    "moments about other axes": 0.17,
    "moments in rows of the tensor": 0.04,
    "one number typed anew": -0.18,
    "placeholder": -0.94,
    "power of ten of a moment": -0.12,
    "reference": -0.46,
    "reference + signs": -0.22,
    "scale + digit": -0.00,
    "scale + reference + unit": 0.54,
    "scale + signs + unit": -0.02,
    "scale + unit": -0.35,
    "shifted twice": -0.03,
    "sign of a moment": 0.02,
    "sign of the CoM": -0.04,
    "signs": 0.08,
    "signs + moments in rows of the tensor": -0.04,
    "signs about the CoM": -0.00,
    "two coordinates of the CoM swapped": 0.07,
    "two moments swapped": 0.07,
}
