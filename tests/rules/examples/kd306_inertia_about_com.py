"""Documents in which KD306 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint, link, robot


def _upper(moment: str) -> str:
    inertia = f"""inertia_params {{
        mass = 2.0
        CoM = (0.0, 0.0, 0.3)
        Ix={moment} Iy={moment} Iz=0.002 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }}"""
    links = link("upper", 1, "lower via elbow", inertia), link("lower", 2)
    return robot(*links, joint("shoulder"), joint("elbow", 0.6), base="upper via shoulder")


GOOD = (_upper("0.2"),)
BAD = (Example(_upper("0.020"), fixed=_upper("0.2")),)
