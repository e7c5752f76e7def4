"""Documents in which KD310 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot

_INERTIA = """inertia_params {
        mass = 1.0
        CoM = (0.0, 0.0, 0.0)
        Ix=%s Iy=%s Iz=%s Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""

_SAME = _INERTIA % ("0.01", "0.01", "0.01")


def _arm(third: str) -> str:
    links = (
        link("upper", 1, "lower via elbow", _SAME),
        link("lower", 2, "hand via wrist", _SAME),
        link("hand", 3, inertia=third),
    )
    return robot(*links, base="upper via shoulder", joints="shoulder elbow wrist")


GOOD = (_arm(_INERTIA % ("0.02", "0.02", "0.02")),)
BAD = (_arm(_SAME), link("upper", 1, inertia=_INERTIA % ("1.0", "1.0", "1.0")))
