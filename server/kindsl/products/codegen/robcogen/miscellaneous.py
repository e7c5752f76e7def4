"""`miscellaneous.h` and `miscellaneous.cpp`: the centre of mass."""

from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

_HEADER = template("robcogen/miscellaneous.h")
_SOURCE = template("robcogen/miscellaneous.cpp")


def miscellaneous(robot: GeneratedRobot) -> dict[str, str]:
    """Return header and source by their names."""
    base = f"inertia.getMass_{robot.bodies[0]}() * inertia.getCOM_{robot.bodies[0]}()"
    source = robot.filled(
        _SOURCE,
        GENERATOR=robot.library.stamp.generator,
        DOCUMENT=robot.library.stamp.document,
        BASE_PART=base if robot.is_floating else "iit::rbd::Vector3d::Zero()",
        STEPS="".join(_step(robot, link) for link in robot.tree.links()),
        UPDATES="".join(f"    transforms.{robot.back_across(i)}(q);\n" for i in robot.tree.links()),
    )
    includes = ['"inertia_properties.h"', '"transforms.h"']
    header = robot.header("miscellaneous.h", includes, robot.filled(_HEADER))
    return {"miscellaneous.h": header, "miscellaneous.cpp": source}


def _step(robot: GeneratedRobot, link: int) -> str:
    name, parent = robot.bodies[link], robot.tree.parents[link]
    before = f"pose{parent} * " if parent else ""
    return (
        f"    const Pose pose{link} = {before}transforms.{robot.back_across(link)};\n"
        f"    sum += inertia.getMass_{name}()\n"
        f"        * (pose{link}.topLeftCorner<3, 3>() * inertia.getCOM_{name}()\n"
        f"            + pose{link}.topRightCorner<3, 1>());\n"
    )
