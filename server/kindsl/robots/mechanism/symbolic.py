"""From a model to a robot for code generation, parameters staying inputs of the code."""

from collections.abc import Collection, Mapping
from typing import cast

from kindsl.language.semantics import declarations as declared
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import JointProperties
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame, Robot, massless
from kindsl.mechanics.dynamics.generation.terms import Graph, Scalar, Term, cosine_and_sine
from kindsl.mechanics.dynamics.generation.tree import ROUNDING, Tree, masses_near_base, tree_drives
from kindsl.mechanics.dynamics.generation.vectors import Matrix, Vector, scale
from kindsl.mechanics.rigid.joint_kind import JointKind
from kindsl.robots.mechanism.bodies import drives_of
from kindsl.robots.mechanism.build import mechanism_of
from kindsl.robots.mechanism.errors import ModelError
from kindsl.robots.mechanism.numbering import numbered_by_id, require_base
from kindsl.robots.mechanism.reading import named_frames

# Any values will do to find out whether a document is whole; these are unlikely to cancel.
PLACEHOLDER = 0.731


def symbolic_robot(
    model: Model,
    values: Mapping[str, float],
    inputs: Collection[str],
    told: Mapping[str, JointProperties] | None = None,
) -> Robot:
    """Return a robot whose given parameters are inputs.

    Args:
        model: The document's model.
        values: Of the other parameters by name, and of constants by `<name>`.
        inputs: Names of parameters that stay inputs.
        told: What is told of joints besides, by their names: rotors and friction count.

    Raises:
        UnboundParameterError: A parameter is neither.
        ModelError: The model is no kinematic tree with regular numbering, or a value is missing.
    """
    mechanism_of(model, {**values, **dict.fromkeys(inputs, PLACEHOLDER)})
    graph = Graph()
    reader = _ScalarReader(values, {name: graph.input() for name in inputs})
    base, edges = require_base(model), numbered_by_id(model)
    links = [base, *(edge.link for edge in edges if edge.link is not None)]
    joints = [edge.joint for edge in edges if edge.joint is not None]
    index = {link: number for number, link in enumerate(links)}
    kinds: list[JointKind] = ["revolute", *(joint.kind for joint in joints)]
    parents = [0, *(index[edge.predecessor] for edge in edges)]
    eye: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    rotations = [eye, *(reader.rotation(joint.pose) for joint in joints)]
    positions: list[Vector] = [
        [0.0, 0.0, 0.0], *(reader.vector(joint.pose.translation) for joint in joints),
    ]  # fmt: skip
    bodies = [reader.body(link) for link in links]
    masses = masses_near_base(kinds, parents, rotations, positions, bodies)
    joint_names = tuple(str(joint.name) for joint in joints)
    drives = tree_drives(drives_of(joint_names, told or {}))
    return Robot(
        graph,
        Tree(parents, kinds, rotations, positions, masses, base.is_floating, drives),
        bodies,
        str(base.name),
        tuple(str(link.name) for link in links[1:]),
        joint_names,
        tuple(
            PlacedFrame(
                name,
                index[body],
                reader.rotation(frame.pose),
                reader.vector(frame.pose.translation),
            )
            for name, body, frame in named_frames(index)
        ),
        reader.inputs,
    )


class _ScalarReader:
    """Reads values as scalars.

    Attributes:
        inputs: The parameters that stay inputs.
    """

    def __init__(self, values: Mapping[str, float], inputs: dict[str, Term]) -> None:
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
