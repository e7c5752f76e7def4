"""Arguments and results of a generated function."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from kindsl.mechanics.dynamics.generation.robot import Robot
from kindsl.mechanics.dynamics.generation.terms import Scalar, Term
from kindsl.mechanics.dynamics.generation.vectors import Matrix, Vector


class Argument(NamedTuple):
    """A vector that a function takes."""

    name: str
    components: list[Term]


class Result(NamedTuple):
    """An array that a function fills.

    Attributes:
        shape: Its dimensions.
        entries: By rows.
    """

    name: str
    shape: tuple[int, ...]
    entries: list[Scalar]


class Function(NamedTuple):
    """A computation with named arguments and results.

    Attributes:
        summary: A line on its result, for people.
        arguments: In order; parameters besides.
        results: In order.
        loaded: The results under external forces; None where these do not matter.
        about: The links and frames that it is about, if it is about some of several.
        is_loop: Whether a loop over bodies computes it, and the entries of results are not known.
    """

    name: str
    summary: str
    arguments: tuple[Argument, ...]
    results: tuple[Result, ...]
    loaded: tuple[Result, ...] | None = None
    about: tuple[str, ...] = ()
    is_loop: bool = False

    @property
    def key(self) -> tuple[str, ...]:
        """Its name and what it is about: frames' names can make two names of functions equal."""
        return (self.name, *self.about)


@dataclass(frozen=True, slots=True)
class Inputs:
    """The inputs of a mechanism's functions; a fixed base's motion is zero.

    Attributes:
        q: Joint positions.
        qd: Joint velocities.
        qdd: Joint accelerations.
        tau: Joint forces.
        v0: Spatial velocity of the base.
        a0: Spatial acceleration of the base.
        g: Gravity, in base coordinates.
        external: The wrench on each body in its own coordinates, moment first; none if empty.
    """

    q: Vector
    qd: Vector
    qdd: Vector
    tau: Vector
    v0: Vector
    a0: Vector
    g: Vector
    external: list[Vector]

    @property
    def positions(self) -> tuple[Argument]:
        """The joint positions as the only argument of a function."""
        return (argument("q", self.q),)

    def unaccelerated(self) -> "Inputs":
        """Return the same with joints and base that do not accelerate, and nothing from outside."""
        return replace(self, qdd=[0.0] * len(self.q), a0=[0.0] * 6, external=[])

    def motion(self, *further: str) -> tuple[Argument, ...]:
        """Return q, qd, a further joint vector, a floating base's motion, and gravity."""
        names = ["q", "qd", *(name for name in further if name != "a0")]
        if isinstance(self.v0[0], Term):
            names += ["v0", *(name for name in further if name == "a0")]
        return tuple(argument(name, getattr(self, name)) for name in (*names, "g"))


def inputs_of(robot: Robot) -> Inputs:
    """Add all inputs of a mechanism to its graph."""
    graph, n = robot.graph, len(robot.link_names)
    vectors: list[Vector] = [[*graph.vector(n)] for _ in range(4)]
    base: list[Vector] = [[0.0] * 6, [0.0] * 6]
    if robot.tree.is_floating:
        base = [[*graph.vector(6)] for _ in range(2)]
    gravity: Vector = [*graph.vector(3)]
    external: list[Vector] = [[*graph.vector(6)] for _ in range(n + 1)]
    q, qd, qdd, tau = vectors
    return Inputs(q, qd, qdd, tau, base[0], base[1], gravity, external)


def matrix(name: str, M: Matrix) -> Result:
    """Return a matrix as a result."""
    return Result(name, (len(M), len(M[0])), [entry for row in M for entry in row])


def homogeneous(entries: Sequence[Scalar]) -> list[Scalar]:
    """Return whole 4x4 matrices of poses without their last row."""
    last: Vector = [0.0, 0.0, 0.0, 1.0]
    return [x for k in range(0, len(entries), 12) for x in (*entries[k : k + 12], *last)]


def argument(name: str, vector: Vector) -> Argument:
    """Return an argument from input values."""
    return Argument(name, [x for x in vector if isinstance(x, Term)])
