"""Documents in which KD502 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint, link


def _block(com: str) -> str:
    inertia = f"""inertia_params {{
        mass = 2.4
        CoM = (0.0, 0.0, {com})
        Ix=0.073 Iy=0.073 Iz=0.004 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }}"""
    return link("upper", 1, inertia=inertia)


GOOD = (joint("elbow", 1.5), _block("0.15"))
BAD = (
    Example(joint("elbow", 425.0), fixed=joint("elbow", 0.425)),
    Example(_block("150.0"), fixed=_block("0.15")),
    Example(_block("15.0"), fixed=_block("0.15")),
)
