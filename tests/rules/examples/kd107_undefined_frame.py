"""Documents in which KD107 finds nothing, and in which it finds something."""

from tests.support.examples import Example

_LINK = """link upper {
    id = 1
    inertia_params {
        mass = 1.0 CoM = (0.0, 0.0, 0.0)
        Ix=0.01 Iy=0.01 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0
        ref_frame = %s
    }
    children {}
    frames { fr_COM { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}"""

GOOD = (_LINK % "fr_COM",)
BAD = (Example(_LINK % "fr_CoM", fixed=_LINK % "fr_COM"), _LINK % "gripper", _LINK % "upper")
