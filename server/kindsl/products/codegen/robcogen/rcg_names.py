"""The names of RobCoGen 0.5, all in `NAME::rcg`: a header that the others include."""

from kindsl.products.codegen.filling import template
from kindsl.products.codegen.robcogen.robot import GeneratedRobot

LAYOUT = "robcogen-0.5"

_TYPES = template("robcogen/rbd_types.h")

_CONSTANTS = """
#error "constants are in the code: change the document and generate again, or use parameters"
"""


def rcg_names(robot: GeneratedRobot) -> dict[str, str]:
    """Return the header of types, and one that tells why there are no constants."""
    types = ["<iit/rbd/scalar_traits.h>", "<iit/rbd/types.h>"]
    return {
        "rbd_types.h": robot.header("rbd_types.h", types, robot.filled(_TYPES)),
        "model_constants.h": robot.header("model_constants.h", [], _CONSTANTS),
    }
