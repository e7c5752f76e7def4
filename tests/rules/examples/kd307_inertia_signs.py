"""Documents in which KD307 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_INERTIA = """inertia_params {
        mass = 2.0
        CoM = (0.2, 0.1, 0.3)
        Ix=0.22 Iy=0.28 Iz=0.12 Ixy=%s Ixz=%s Iyz=%s
    }"""

_LINK = link("upper", 1, inertia=_INERTIA)

_RIGHT, _WRONG = ("0.04", "0.12", "0.06"), ("-0.04", "-0.12", "-0.06")

GOOD = (_LINK % _RIGHT,)
BAD = (Example(_LINK % _WRONG, fixed=_LINK % _RIGHT),)
