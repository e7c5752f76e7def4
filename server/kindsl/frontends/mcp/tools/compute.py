"""Compute the mechanics of a .kindsl, .urdf or .sdf robot in one configuration.

Answers a JSON object: poses of links and frames (4x4, to the base's coordinates), mass, centre of
mass, joint-space inertia, torques of gravity, bias and inverse dynamics, Jacobians of frames; with
`tau`, the accelerations.
"""

import json

from kindsl.frontends.mcp.documents import BoundArguments, built, document
from kindsl.frontends.mcp.folder import Folder, ToolError
from kindsl.frontends.mcp.tool import Content, Field, text
from kindsl.products.reports.motions import ConfigurationSpace, motions_from

_JOINTS = "one number a joint in the order of the links' ids, or an object by names of joints"
Values = list[float] | dict[str, float] | None


class ConfigurationArguments(BoundArguments):
    """A document and a configuration."""

    q: Values = Field(None, description=f"Positions, radians and metres: {_JOINTS}; default zero")
    qd: Values = Field(None, description="Velocities, likewise")
    qdd: Values = Field(None, description="Accelerations, likewise")
    tau: Values = Field(None, description="Joint forces; then accelerations are computed")
    base_velocity: list[float] | None = Field(
        None, description="Of a floating base: three angular, three linear"
    )
    gravity: list[float] = Field([0.0, 0.0, -9.81], description="In the base's coordinates, m/s²")


def run(arguments: ConfigurationArguments, folder: Folder) -> list[Content]:
    """Return the numbers."""
    _, analysis = document(arguments, folder)
    mechanism = built(analysis, analysis.mechanism)
    keys = ("q", "qd", "qdd", "tau", "base_velocity")
    given = {key: getattr(arguments, key) for key in keys if getattr(arguments, key) is not None}
    if len(arguments.gravity) != 3:
        raise ToolError("'gravity' has three numbers")
    robot = ConfigurationSpace(mechanism.bodies.joint_names, mechanism.bodies.is_floating)
    from kindsl.products.reports.computation import compute

    is_forward = arguments.tau is not None
    try:
        motions = motions_from(given, robot)
        results = compute(analysis, mechanism, motions, arguments.gravity, is_forward=is_forward)
    except ValueError as error:
        raise ToolError(str(error)) from None
    return [text(json.dumps(results.as_json()))]
