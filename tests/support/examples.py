"""Short ways to write the documents that show a rule."""

from collections.abc import Mapping, Sequence
from functools import cache
from typing import NamedTuple


class Example(NamedTuple):
    """A document that shows a rule, with its targets and parameters.

    Attributes:
        text: A document, or single blocks.
        targets: The generators that must accept it.
        parameters: Values by name.
        ranges: Least and greatest values by name, of some of the parameters.
        fixed: The text with the fix of the rule's finding applied, if it offers one.
    """

    text: str
    targets: tuple[str, ...] = ()
    parameters: tuple[tuple[str, float], ...] = ()
    ranges: tuple[tuple[str, float, float], ...] = ()
    fixed: str | None = None


_INERTIA = """inertia_params {
        mass = %s
        CoM = (0.0, 0.0, %s)
        Ix=%s Iy=%s Iz=%s Ixy=0.0 Ixz=0.0 Iyz=0.0
    }"""
STEEL_BALL = _INERTIA % ("4.1", "0.0", "0.0041", "0.0041", "0.0041")


def link(name: str, link_id: int, children: str = "", inertia: str = STEEL_BALL) -> str:
    """Return a link; its `children` as `link via joint link via joint`."""
    return f"link {name} {{\n    id = {link_id}\n    {inertia}\n    children {{ {children} }}\n}}\n"


def inertia(mass: str, height: str, ix: str, iy: str, iz: str) -> str:
    """Return the inertia of a body whose centre of mass is above its origin; as written."""
    return _INERTIA % (mass, height, ix, iy, iz)


def joint(name: str, height: float = 0.3, rotation: str = "PI/2.0, 0.0, 0.0") -> str:
    """Return a revolute joint above its predecessor's origin."""
    return placed_joint(name, f"0.0, 0.0, {height}", rotation)


def placed_joint(name: str, translation: str, rotation: str) -> str:
    """Return a revolute joint at a place."""
    place = f"translation = ({translation})\n        rotation = ({rotation})"
    return f"r_joint {name} {{\n    ref_frame {{\n        {place}\n    }}\n}}\n"


def pitched_joint(angle: str) -> str:
    """Return a revolute joint whose second angle is given."""
    return joint("elbow", rotation=f"0.0, {angle}, 0.0")


def robot(*links: str, base: str = "", joints: str = "", name: str = "Arm") -> str:
    """Return a document.

    Args:
        links: Whole links.
        base: Child of the base, as `link via joint`.
        joints: Names of joints, with blanks between them.
        name: The robot's name.
    """
    head = f"Robot {name} {{\nRobotBase ground {{\n    children {{ {base} }}\n}}\n"
    return head + "".join(links) + "".join(joint(name) for name in joints.split()) + "}\n"


def two_links(first: int, second: int) -> str:
    """Return a chain of two links with these ids."""
    links = link("upper", first, "lower via elbow"), link("lower", second)
    return robot(*links, base="upper via shoulder", joints="shoulder elbow")


@cache
def four_legs(**thighs: str) -> str:
    """Return a robot with four legs of three links.

    Args:
        thighs: Translation of a leg's second joint where it differs from the others, by the leg.
    """
    corners = {"LF": "0.4, 0.2", "RF": "0.4, -0.2", "LH": "-0.4, 0.2", "RH": "-0.4, -0.2"}
    poses = {
        leg: (
            (f"{corner}, 0.0", "0.0, PI/2.0, 0.0"),
            (thighs.get(leg, "0.08, 0.0, 0.0"), "PI/2.0, 0.0, 0.0"),
            ("0.35, 0.0, 0.0", "0.0, 0.0, 0.0"),
        )
        for leg, corner in corners.items()
    }
    return _with_limbs(poses, ("hip", "thigh", "shank"), ("HAA", "HFE", "KFE"))


def two_arms(elbow: str) -> str:
    """Return a robot with two arms of three links, the translation of the right elbow given."""
    poses = {
        side: (
            (shoulder, "0.0, 0.0, 0.0"),
            (place, "PI/2.0, 0.0, 0.0"),
            ("0.25, 0.0, 0.0", "0.0, 0.0, 0.0"),
        )
        for side, shoulder, place in (
            ("left", "0.0, 0.2, 0.5", "0.3, 0.1, 0.02"),
            ("right", "0.0, -0.2, 0.5", elbow),
        )
    }
    return _with_limbs(poses, ("arm", "forearm", "wrist"), ("shoulder", "elbow", "roll"))


def _with_limbs(
    poses: Mapping[str, Sequence[tuple[str, str]]], parts: Sequence[str], joints: Sequence[str]
) -> str:
    """Return a robot with chains of links, given translation and rotation of each joint."""
    links, placed, heads = [], [], []
    for index, (limb, limb_poses) in enumerate(poses.items()):
        edges = [
            f"{limb}_{part} via {limb}_{name}" for part, name in zip(parts, joints, strict=True)
        ]
        heads.append(edges[0])
        for number, (part, below) in enumerate(zip(parts, [*edges[1:], ""], strict=True), 1):
            links.append(link(f"{limb}_{part}", index * len(parts) + number, below))
        for name, (translation, rotation) in zip(joints, limb_poses, strict=True):
            placed.append(placed_joint(f"{limb}_{name}", translation, rotation))
    return robot(*links, *placed, base=" ".join(heads))


def urdf_link(inertia: str) -> str:
    """Return a URDF with one link, its moments being given."""
    return f"""<robot name="arm">
  <link name="upper">
    <inertial>
      <mass value="2"/>
      <inertia {inertia}/>
    </inertial>
  </link>
</robot>
"""


def urdf_arm(limit: str) -> str:
    """Return a URDF with one joint, its limits and the like being given."""
    return f"""<robot name="arm">
  <link name="base"/>
  <link name="upper">
    <inertial>
      <mass value="2"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/>
    </inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="upper"/>
    {limit}
  </joint>
</robot>
"""


def sdf_arm(pose: str = "", axis: str = "") -> str:
    """Return an SDF with one joint, the pose of its child and more of its axis being given."""
    return f"""<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="upper">
      {pose}
      <inertial>
        <mass>2</mass>
        <inertia><ixx>0.01</ixx><iyy>0.02</iyy><izz>0.02</izz></inertia>
      </inertial>
    </link>
    <joint name="shoulder" type="revolute">
      <parent>base</parent>
      <child>upper</child>
      <axis><xyz>0 0 1</xyz>{axis}</axis>
    </joint>
  </model>
</sdf>
"""
