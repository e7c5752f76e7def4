"""A mechanism whose numbers may be expressions, with the names that generated code needs."""

from dataclasses import dataclass

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.terms import Graph, Term
from kindsl.mechanics.dynamics.generation.tree import Tree, mass_distributions, tree_of
from kindsl.mechanics.dynamics.generation.vectors import EYE, Matrix, Vector


@dataclass(frozen=True, slots=True)
class PlacedFrame:
    """A named frame on a body.

    Attributes:
        name: Its name, unique among the links and frames.
        body: Index of the body that carries it.
        R: Rotation of coordinates from the frame to the body.
        r: The frame's origin in the body's frame, metres.
    """

    name: str
    body: int
    R: Matrix
    r: Vector


@dataclass(frozen=True, slots=True)
class Robot:
    """The robot that code is generated from.

    Attributes:
        graph: Where everything is recorded.
        tree: The tree that the algorithms work on.
        bodies: Moments of mass of each body as given, base first; those in `tree` are moved.
        base_name: The base's name.
        link_names: By body index less one.
        joint_names: By body index less one.
        frames: Further frames, those on the base too.
        parameters: Values known only when the code runs, by name.
        chosen: The links and frames that poses and Jacobians are wanted of, None for all.
    """

    graph: Graph
    tree: Tree
    bodies: list[MassMoments]
    base_name: str
    link_names: tuple[str, ...]
    joint_names: tuple[str, ...]
    frames: tuple[PlacedFrame, ...]
    parameters: dict[str, Term]
    chosen: tuple[PlacedFrame, ...] | None = None

    @property
    def n_velocities(self) -> int:
        """Number of velocity variables: the joints, and six more for a floating base."""
        return len(self.link_names) + (6 if self.tree.is_floating else 0)

    @property
    def targets(self) -> tuple[PlacedFrame, ...]:
        """All whose pose is wanted: the links, then the frames."""
        return self.placed if self.chosen is None else self.chosen

    @property
    def placed(self) -> tuple[PlacedFrame, ...]:
        """All that has a pose: the links, then the frames."""
        links = enumerate(self.link_names, start=1)
        return (*(PlacedFrame(name, i, EYE, [0.0] * 3) for i, name in links), *self.frames)

    def joint_frame(self, joint: int) -> PlacedFrame:
        """Return a joint's frame, `fr_` and its name, which the predecessor carries; from 1."""
        tree = self.tree
        pose = tree.rotations[joint], tree.positions[joint]
        return PlacedFrame(f"fr_{self.joint_names[joint - 1]}", tree.parents[joint], *pose)


def robot_of(bodies: Bodies) -> Robot:
    """Return a mechanism all of whose numbers are known."""
    return Robot(
        Graph(),
        tree_of(bodies),
        mass_distributions(bodies),
        bodies.base_name,
        bodies.link_names,
        bodies.joint_names,
        tuple(
            PlacedFrame(f.name, f.body, f.body_R_frame.tolist(), f.body_r_frame.tolist())
            for f in bodies.frames
        ),
        {},
    )


def massless() -> MassMoments:
    """Return no body at all."""
    return MassMoments([[0.0] * 3 for _ in range(3)], [0.0] * 3, 0.0)
