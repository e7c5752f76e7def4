"""`link_data_map.h` and `joint_data_map.h`: one item a link or joint."""

from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

_TEXT = template("robcogen/data_map.h")


def data_maps(robot: GeneratedRobot) -> dict[str, str]:
    """Return both headers by their names."""
    library = robot.library.robot
    names = {"Link": (library.base_name, *library.link_names), "Joint": library.joint_names}
    return {f"{kind.lower()}_data_map.h": _header(robot, kind, names[kind]) for kind in names}


def _header(robot: GeneratedRobot, kind: str, names: tuple[str, ...]) -> str:
    body = robot.filled(
        _TEXT,
        WHAT=kind.lower(),
        CLASS=f"{kind}DataMap",
        ID=f"{kind}Identifiers",
        COUNT=f"{kind.lower()}sCount",
        ORDERED=f"ordered{kind}IDs",
        NAMES=", ".join(f'"{name}"' for name in names),
    )
    return robot.header(f"{kind.lower()}_data_map.h", ["<ostream>", '"declarations.h"'], body)
