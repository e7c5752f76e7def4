"""Documents in which KD314 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_INERTIA = """inertia_params {
        mass = %s
        CoM = (0.0, 0.0, 0.15)
        Ix=0.073 Iy=0.073 Iz=0.004 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""

_LINK = link("upper", 1, inertia=_INERTIA)

GOOD = (_LINK % "2.4",)
BAD = (Example(_LINK % "2400.0", fixed=_LINK % "2.4"),)
