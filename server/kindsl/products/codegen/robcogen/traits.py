"""`traits.h`: the types of one robot for one type of numbers."""

from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

_TEXT = template("robcogen/traits.h")


def traits(robot: GeneratedRobot) -> dict[str, str]:
    """Return the header by its name."""
    body = robot.filled(_TEXT, FLOATING="true" if robot.is_floating else "false")
    headers = (
        "declarations", "transforms", "inverse_dynamics", "forward_dynamics", "jsim",
        "inertia_properties", "jacobians",
    )  # fmt: skip
    includes = [*(f'"{name}.h"' for name in headers), "<iit/rbd/traits/TraitSelector.h>"]
    return {"traits.h": robot.header("traits.h", includes, body)}
