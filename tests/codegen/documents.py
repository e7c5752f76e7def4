"""Documents that between them take every way through the emitters."""

from tests.codegen.robcogen.test_classes import CRAB
from tests.support.robots import LIFT, ONE_LINK

from kindsl.language.semantics.parameters import JointProperties

_LINK = """
link {name} {{ id = {id}
    inertia_params {{ mass = {mass} CoM = ({x}, 0.0, 0.1)
        Ix=0.5 Iy=0.6 Iz=0.7 Ixy=0.0 Ixz=0.0 Iyz=0.0 }}
    children {{ {children} }}
}}"""
_JOINT = """
{kind}_joint {name} {{
    ref_frame {{ translation = ({x}, 0.2, 0.0) rotation = (0.0, {y}, 0.0) }}
}}"""


def chain(n: int, base: str = "", x: str = "0.25", mass: str = "1.5") -> str:
    """Return a robot of links one after the other, the last one beside, each third joint prismatic.

    Args:
        n: How many.
        base: `floating`, or nothing.
        x: The first joint's and the last link's translation.
        mass: The last link's.
    """
    inertia = """inertia_params { mass = 4.0 CoM = (0.0, 0.0, 0.0)
        Ix=0.5 Iy=0.6 Iz=0.7 Ixy=0.0 Ixz=0.0 Iyz=0.0 }"""
    parts = [f"Robot Chain {{ RobotBase root {base} {{ {inertia if base else ''}",
             f"    children {{ l1 via j1 l{n} via j{n} }} }}"]  # fmt: skip
    for k in range(1, n + 1):
        below = f"l{k + 1} via j{k + 1}" if k < n - 1 else ""
        own = (x, mass) if k == n else ("0.0", "2.0")
        parts.append(_LINK.format(name=f"l{k}", id=k, x=own[0], mass=own[1], children=below))
        first = x if k == 1 else "0.0"
        kind = "p" if k % 3 == 0 else "r"
        parts.append(
            _JOINT.format(name=f"j{k}", kind=kind, x=first, y="PI/2.0" if k == 2 else "0.0")
        )
    return "\n".join([*parts, "}\n"])


ODD = (
    LIFT.replace("Robot Arm", "Robot Gamma")
    .replace("shoulder", "class")
    .replace("upper", "Trait")
    .replace("lift", "Class")
    .replace("slider", "scalar")
    .replace("tool", "tip_batch")
)
# Moments of a body that has no mass.
LIGHT = CRAB.replace("mass = 0.8", "mass = 0.0")
DOCUMENTS = {
    "arm": LIFT,
    "crab": CRAB,
    "odd": ODD,
    "light": LIGHT,
    "one": ONE_LINK,
    "reach": LIFT.replace("(0.4, 0.0, 0.0)", "(reach, 0.0, 0.0)"),
    "angle": LIFT.replace("(-PI/2.0, 0.0, 0.0)", "(-angle, 0.0, 0.0)"),
    "chain": chain(10),
    "long": chain(21, "floating"),
    "long_parameters": chain(21, x="reach", mass="m"),
}
TRANSFORMS = {
    "crab": """Robot Crab
Frames { fr_shell, fr_claw, fr_right, tip }
Transforms {
    base=fr_right, target=tip
    base=fr_shell, target=fr_claw
    base=fr_right, target=tip
    base=fr_claw, target=tip
}
Jacobians {
    base=fr_right, target=tip
    base=fr_claw, target=tip
    base=tip, target=fr_shell
}
""",
    "chain": """Robot Chain
Frames { fr_root, fr_l8, fr_l9, fr_l10, fr_j9 }
Transforms {
    base=fr_l9, target=fr_root
    base=fr_l8, target=fr_l10
    base=fr_root, target=fr_j9
    base=fr_j9, target=fr_l10
}
Jacobians { base=fr_l9, target=fr_l10 }
""",
}
DRIVES = {"shoulder": JointProperties(friction=0.25, damping=0.5, armature=0.125)}
