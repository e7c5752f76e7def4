"""`declarations.h`: sizes, joint vectors, and the identifiers of joints and links."""

from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen import rcg_names
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

_TEXT = template("robcogen/declarations.h")


def declarations(robot: GeneratedRobot) -> dict[str, str]:
    """Return the header by its name."""
    body = robot.filled(
        _TEXT,
        JOINTS=",\n    ".join(_numbered(robot.joint_ids)),
        LINKS=",\n    ".join(_numbered(robot.body_ids)),
        JOINTS1=", ".join(robot.joint_ids),
        LINKS1=", ".join(robot.body_ids),
    )
    has_names = robot.library.options.layout == rcg_names.LAYOUT
    includes = ["<Eigen/Dense>", "<iit/rbd/rbd.h>", *['"rbd_types.h"'] * has_names]
    return {"declarations.h": robot.header("declarations.h", includes, body)}


def _numbered(names: list[str]) -> list[str]:
    return [f"{name} = {number}" for number, name in enumerate(names)]
