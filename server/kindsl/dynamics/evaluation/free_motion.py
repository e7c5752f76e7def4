"""Results of dynamics with a floating base on which no wrench acts."""

from typing import NamedTuple

from kindsl.spatial.arrays import Array


class FreeMotionTorque(NamedTuple):
    """Inverse dynamics with a floating base on which no wrench acts.

    Attributes:
        tau: Joint forces, shape (..., n), N m and N.
        base_acceleration: Spatial acceleration, gravity's effect included, shape (..., 6), base
            coordinates, angular part first.
    """

    tau: Array
    base_acceleration: Array


class FreeMotion(NamedTuple):
    """Forward dynamics with a floating base on which no wrench acts.

    Attributes:
        qdd: Joint accelerations, shape (..., n).
        base_acceleration: Spatial acceleration, gravity's effect included, shape (..., 6), base
            coordinates, angular part first.
    """

    qdd: Array
    base_acceleration: Array
