"""Documents in which KD511 finds nothing, and in which it finds something."""

from tests.support.examples import joint, link, robot


def _arm(com: str, moment: str = "0.036") -> str:
    inertia = f"""inertia_params {{
        mass = 1.2
        CoM = (0.0, 0.0, %s)
        Ix={moment} Iy={moment} Iz=0.001 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }}"""
    forearm = link("forearm", 1, "hand via wrist", inertia % com)
    joints = joint("elbow"), joint("wrist", 0.3)
    return robot(forearm, link("hand", 2), *joints, base="forearm via elbow")


# Then one whose counterweight is heavier than it is, so that the whole is as long as the link.
GOOD = (_arm("0.15"), _arm("-0.04", "0.013"))
BAD = (_arm("-0.15"), _arm("0.45", "0.252"))
