"""Documents in which KD309 finds nothing, and in which it finds something."""

from tests.support.examples import inertia, joint, link, robot


def _arm(com: str, moment: str) -> str:
    forearm = link("forearm", 1, "hand via wrist", inertia("1.2", com, moment, moment, "0.001"))
    joints = joint("elbow"), joint("wrist", 0.3)
    return robot(forearm, link("hand", 2), *joints, base="forearm via elbow")


GOOD = (_arm("0.15", "0.037"), _arm("150.0", "27100.0"))
BAD = (_arm("1.5", "2.71"),)
