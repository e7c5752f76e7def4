"""Small documents for the tests of the commands."""

from collections.abc import Iterator

INERTIA = (
    "inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0)"
    " Ix = 1.0 Iy = 1.0 Iz = 1.0 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }"
)
POSE = "translation = (0.0, 0.0, 0.5) rotation = (0.0, 0.0, 0.0)"


def arm(*, reach: str = "0.5", mass: str = "2.0", floating: bool = False) -> str:
    """Return an arm of two links, its values open to mistakes."""
    inertia = INERTIA.replace("mass = 1.0", f"mass = {mass}")
    return "\n".join(_arm_lines(reach, inertia, " floating" if floating else ""))


def _arm_lines(reach: str, inertia: str, floating: str) -> Iterator[str]:
    yield "Robot arm {"
    yield f"RobotBase base{floating} {{"
    yield f"    {INERTIA}"
    yield "    children { upper via shoulder }"
    yield "}"
    yield "link upper {"
    yield "    id = 1"
    yield f"    {inertia}"
    yield "    children { lower via elbow }"
    yield "}"
    yield "link lower {"
    yield "    id = 2"
    yield f"    {INERTIA}"
    yield "    children {}"
    yield f"    frames {{ tip {{ {POSE} }} }}"
    yield "}"
    yield "r_joint shoulder {"
    yield f"    ref_frame {{ {POSE} }}"
    yield "}"
    yield "p_joint elbow {"
    yield f"    ref_frame {{ translation = ({reach}, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }}"
    yield "}"
    yield "}"
    yield ""


GOOD = arm()
INTEGER = arm(reach="1")
"""One error, KD005 at line 21, column 32, with a safe fix."""
UNBOUND = arm(reach="length")
"""One warning, KD401 at line 21."""
