"""Documents in which KD011 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_LINK = link("upper", 1)

_REPORT = """
    Mass = 4.1 kilograms
    Center of mass: ( meters )
        X = 0.0
        Y = 0.0
        Z = 0.0
    Moments of inertia: ( kilograms * square meters )
    Taken at the output coordinate system.
        Ixx = 0.0041 Ixy = 0.0000 Ixz = 0.0000
        Iyx = 0.0000 Iyy = 0.0041 Iyz = 0.0000
        Izx = 0.0000 Izy = 0.0000 Izz = 0.0041
"""

_SPHERE = "    sphere(0.05, mass = 4.1)\n"

GOOD = (_LINK,)
BAD = (
    Example(_LINK.replace("id = 1\n", f"id = 1\n{_REPORT[1:]}"), fixed=_LINK),
    Example(_LINK.replace("id = 1\n", f"id = 1\n{_SPHERE}"), fixed=_LINK),
)
