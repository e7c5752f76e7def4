"""Blocks with their sections, and the vectors in these; `sections.py` types what each block has."""

from collections.abc import Iterator
from typing import ClassVar, NamedTuple, TypeAlias

from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.places import Construct, Name
from kindsl.language.syntax.tree import Island, Node, Token

Components: TypeAlias = tuple[Expression, Expression, Expression]


class Vector(Construct):
    """Three components as written; their text is empty where the parser supplied them."""

    __slots__ = ("components",)

    def __init__(self, node: Node, island: Island, components: Components) -> None:
        self.node = node
        self.island = island
        self.components = components


class FixedAxes(Vector):
    """Turns about the fixed x, y, z: roll, pitch, yaw."""

    __slots__ = ()


class Pose(NamedTuple):
    """Translation in metres, then rotation in radians. None where missing.

    The rotation is about the x, the new y, the new z axis, unless it is about fixed axes.
    """

    translation: Vector | None
    rotation: Vector | None


class NameReference(NamedTuple):
    """The names in a section such as `child`, which refer to things of other blocks."""

    section: str
    names: tuple[Name, ...]


class Whole(NamedTuple):
    """A whole number such as an `id`; `value` is None where it is missing or malformed."""

    section: str
    token: Token
    value: int | None


class Block(Construct):
    """A block with its parts. Its attributes hold the first section of each kind.

    Attributes:
        name: The name that it declares, empty where it is missing or declares none.
        owner: The name of the block around it, empty at the top.
        parts: All that is written in it, in order, repeated sections included.
    """

    __slots__ = ("name", "owner", "parts")
    attributes: ClassVar[dict[str, str]] = {}

    def __init__(self, node: Node, island: Island, name: Name, owner: str) -> None:
        self.node = node
        self.island = island
        self.name = name
        self.owner = owner
        self.parts: list[Expression | Whole | NameReference | Block] = []

    def values(self) -> Iterator[Expression]:
        """Yield the values of its sections and of the blocks in it, repeated sections left out."""
        for attribute in self.attributes.values():
            held = getattr(self, attribute)
            if isinstance(held, Expression):
                yield held
            elif isinstance(held, Vector):
                yield from held.components
            elif isinstance(held, dict):
                yield from held.values()
            elif isinstance(held, Block | tuple):
                for block in held if isinstance(held, tuple) else (held,):
                    if isinstance(block, Block):
                        yield from block.values()


class PoseBlock(Block):
    """A block that gives a frame by translation and rotation."""

    __slots__ = ("rotation", "translation")
    attributes: ClassVar[dict[str, str]] = {"translation": "translation", "rotation": "rotation"}
    translation: Vector | None
    rotation: Vector | None

    @property
    def pose(self) -> Pose:
        """Its two vectors."""
        return Pose(self.translation, self.rotation)
