"""Names of the numbers that are compared."""

from kindsl.language.syntax.vocabulary import MOMENTS

INERTIA = ("mass", "CoM x", "CoM y", "CoM z", *MOMENTS)
TURNS = ("rx", "ry", "rz")
POSE = ("x", "y", "z", *TURNS)
AXIS = "axis"
