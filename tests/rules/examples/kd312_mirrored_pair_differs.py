"""Documents in which KD312 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot

_INERTIA = """inertia_params {
        mass = %s
        CoM = (0.1, %s, 0.0)
        Ix=0.021 Iy=0.031 Iz=0.041 Ixy=%s Ixz=0.0 Iyz=0.0
    }"""


def _pair(mass: str, product: str) -> str:
    links = (
        link("left_arm", 1, inertia=_INERTIA % ("1.24", "0.05", "0.004")),
        link("right_arm", 2, inertia=_INERTIA % (mass, "-0.05", product)),
    )
    return robot(*links, base="left_arm via one right_arm via other", joints="one other")


GOOD = (_pair("1.24", "-0.004"),)
BAD = (_pair("1.42", "-0.004"), _pair("1.24", "0.004"))
