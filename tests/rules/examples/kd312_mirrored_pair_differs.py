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


def _fins() -> str:
    """Return one fin, mounted four times by frames that are turned otherwise."""
    along_y = "CoM = (0.0, -0.04, 0.16) Ix=0.052863 Iy=0.047553 Iz=0.0054059"
    along_y = f"inertia_params {{ mass = 1.44 {along_y} Ixy=0.0 Ixz=0.0 Iyz=-0.0091853 }}"
    along_x = "CoM = (-0.04, 0.0, 0.16) Ix=0.047553 Iy=0.052863 Iz=0.0054059"
    along_x = f"inertia_params {{ mass = 1.44 {along_x} Ixy=0.0 Ixz=-0.0091853 Iyz=0.0 }}"
    names = ("fin_port", along_y), ("fin_starboard", along_x), ("fin_bottom", along_y)
    links = [link(name, i + 1, inertia=inertia) for i, (name, inertia) in enumerate(names)]
    carried = "fin_port via one fin_starboard via other fin_bottom via third"
    return robot(*links, base=carried, joints="one other third")


GOOD = (_pair("1.24", "-0.004"), _fins())
BAD = (_pair("1.42", "-0.004"), _pair("1.24", "0.004"))
