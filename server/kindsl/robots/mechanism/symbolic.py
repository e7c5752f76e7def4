"""From a model to a robot for code generation, parameters staying inputs of the code."""

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import cast

from kindsl.language.semantics import declarations as declared
from kindsl.language.semantics.expressions import Expression, Values
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import JointProperties
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.robot import Robot, massless, robot_of
from kindsl.mechanics.dynamics.generation.terms import Scalar, Term, cosine_and_sine
from kindsl.mechanics.dynamics.generation.tree import ROUNDING, masses_near_base
from kindsl.mechanics.dynamics.generation.vectors import EYE, ZERO, Matrix, Vector, scale
from kindsl.robots.mechanism.build import mechanism_of
from kindsl.robots.mechanism.errors import ModelError
from kindsl.robots.mechanism.numbering import numbered_by_id, require_base
from kindsl.robots.mechanism.reading import named_frames

# Any values will do to find out whether a document is whole; these are unlikely to cancel.
PLACEHOLDER = 0.731


def symbolic_robot(
    model: Model,
    values: Values,
    inputs: Collection[str],
    told: Mapping[str, JointProperties] | None = None,
) -> Robot:
    """Return a robot whose given parameters are inputs.

    Args:
        values: Of the other parameters by name, and of constants by `<name>`.
        inputs: Names of parameters that stay inputs.
        told: What is told of joints besides, by their names: rotors and friction count.

    Raises:
        UnboundParameterError: A parameter is neither.
        ModelError: The model is no kinematic tree with regular numbering, or a value is missing.
    """
    known = robot_of(
        mechanism_of(model, {**values, **dict.fromkeys(inputs, PLACEHOLDER)}, told).bodies
    )
    reader = _ScalarReader(values, {name: known.graph.input() for name in inputs})
    edges = numbered_by_id(model)
    links = [require_base(model), *(edge.link for edge in edges if edge.link is not None)]
    poses = [edge.joint.pose for edge in edges if edge.joint is not None]
    rotations = [EYE, *(reader.rotation(pose) for pose in poses)]
    positions = [ZERO, *(reader.vector(pose.translation) for pose in poses)]
    bodies, tree = [reader.body(link) for link in links], known.tree
    masses = masses_near_base(tree.kinds, tree.parents, rotations, positions, bodies)
    frames = tuple(
        replace(placed, R=reader.rotation(frame.pose), r=reader.vector(frame.pose.translation))
        for placed, (_, _, frame) in zip(known.frames, named_frames(links), strict=True)
    )
    return replace(
        known,
        tree=replace(tree, rotations=rotations, positions=positions, masses=masses),
        bodies=bodies,
        frames=frames,
        parameters=reader.inputs,
    )


class _ScalarReader:
    """Reads values as scalars.

    Attributes:
        inputs: The parameters that stay inputs.
    """

    def __init__(self, values: Values, inputs: dict[str, Term]) -> None:
        self.inputs = inputs
        # The arithmetic of values is that of their operands.
        self._values = cast(Mapping[str, float], {**values, **inputs})

    def number(self, value: Expression | None) -> Scalar:
        number = value.value(self._values) if value is not None else None
        if number is None:
            text = value.text if value is not None else ""
            raise ModelError(f"a value is not defined: {text}", value)
        return number

    def vector(self, vector: declared.Vector | None) -> Vector:
        return [self.number(c) for c in vector.components] if vector is not None else []

    def rotation(self, pose: declared.Pose) -> Matrix:
        """Return a rotation about x, then the new y, then the new z axis."""
        (cx, sx), (cy, sy), (cz, sz) = (
            map(_snapped, cosine_and_sine(angle)) for angle in self.vector(pose.rotation)
        )
        return [
            [cy * cz, 0.0 - cy * sz, sy],
            [cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, 0.0 - sx * cy],
            [sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy],
        ]

    def body(self, link: declared.Link) -> MassMoments:
        """Return a body's moments of mass; a fixed base's do not matter."""
        inertia = link.inertia
        if inertia is None or (link.is_base and not link.is_floating):
            return massless()
        mass, com = self.number(inertia.mass), self.vector(inertia.com)
        xx, yy, zz, xy, xz, yz = (self.number(inertia.moments.get(name)) for name in MOMENTS)
        half = 0.5 * (xx + yy + zz)
        second: Matrix = [[half - xx, xy, xz], [xy, half - yy, yz], [xz, yz, half - zz]]
        body = MassMoments(second, scale(mass, com), mass)
        if inertia.frame is None:
            return body
        frame = next(f for f in link.frames if f.name == inertia.frame)
        turned = body.rotated(self.rotation(frame.pose))
        return turned.displaced(self.vector(frame.pose.translation))


def _snapped(value: Scalar) -> Scalar:
    """Return a cosine or sine without the rounding that a right angle leaves."""
    if isinstance(value, float) and abs(value - round(value)) < ROUNDING:
        return float(round(value))
    return value
