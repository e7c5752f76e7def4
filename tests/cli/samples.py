"""Small documents for the tests of the commands."""

from collections.abc import Iterator

POSE = "translation = (0.0, 0.0, 0.5) rotation = (0.0, 0.0, 0.0)"


def arm(*, reach: str = "0.5", mass: str = "2.0", floating: bool = False) -> str:
    """Return an arm of two links, its values open to mistakes."""
    inertia = _inertia(mass, "0.0101", "0.0122", "0.0041")
    return "\n".join(_arm_lines(reach, inertia, " floating" if floating else ""))


def _inertia(mass: str, *moments: str) -> str:
    ix, iy, iz = moments
    return (
        f"inertia_params {{ mass = {mass} CoM = (0.0, 0.0, 0.0)"
        f" Ix = {ix} Iy = {iy} Iz = {iz} Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }}"
    )


def _arm_lines(reach: str, inertia: str, floating: str) -> Iterator[str]:
    yield "Robot arm {"
    yield f"RobotBase base{floating} {{"
    yield f"    {_inertia('1.0', '0.0021', '0.0019', '0.0016')}"
    yield "    children { upper via shoulder }"
    yield "}"
    yield "link upper {"
    yield "    id = 1"
    yield f"    {inertia}"
    yield "    children { lower via elbow }"
    yield "}"
    yield "link lower {"
    yield "    id = 2"
    yield f"    {_inertia('1.0', '0.0017', '0.0020', '0.0014')}"
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
