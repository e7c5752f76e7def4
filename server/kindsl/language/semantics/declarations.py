"""The declarations of a document, as written: links, joints, frames, inertia."""

from collections.abc import Iterator
from typing import NamedTuple, cast

from kindsl.language.semantics.blocks import Block, Components, FixedAxes, Pose, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.places import Name
from kindsl.language.semantics.sections import Child, Frame, Inertia, JointSections, LinkSections
from kindsl.language.syntax.tables import ValueKind
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.text.facts import Facts
from kindsl.mechanics.rigid.joint_kind import JointKind

__all__ = [
    "Child", "Components", "Declarations", "FixedAxes", "Frame", "Inertia", "Joint", "Link", "Pose",
    "ValueKind", "Vector",
]  # fmt: skip

_NO_POSE = Pose(None, None)


class Link(LinkSections):
    """A link, or the robot's base, whose `id` is 0 without a place."""

    __slots__ = ("facts", "is_base", "is_floating")

    def __init__(self, node: Node, island: Island, name: Name, owner: str) -> None:
        super().__init__(node, island, name, owner)
        self.is_base = node.kind == "base"
        self.is_floating = any(child.kind == "FLOATING" for child in node.children)
        self.facts = Facts()

    def __repr__(self) -> str:
        return f"Link({str(self.name)!r}, id={self.id})"


class Joint(JointSections):
    """A joint with its frame, given with respect to the predecessor's link frame.

    Attributes:
        kind: `"revolute"` or `"prismatic"`.
    """

    __slots__ = ("kind",)

    def __init__(self, node: Node, island: Island, name: Name, owner: str) -> None:
        super().__init__(node, island, name, owner)
        word = cast(Token, node.children[0]).text
        self.kind: JointKind = "prismatic" if word == "p_joint" else "revolute"

    def __repr__(self) -> str:
        return f"Joint({str(self.name)!r}, {self.kind})"

    @property
    def pose(self) -> Pose:
        """The joint frame."""
        return self.frame.pose if self.frame is not None else _NO_POSE


class Declarations(NamedTuple):
    """The declarations of one island; `blocks` are all of them, in order, `Robot` included."""

    robot: Name | None
    bases: tuple[Link, ...]
    links: tuple[Link, ...]
    joints: tuple[Joint, ...]
    blocks: tuple[Block, ...]

    def bodies(self) -> Iterator[Link]:
        """Yield the bases, then the links."""
        yield from self.bases
        yield from self.links

    def values(self) -> Iterator[Expression]:
        """Yield all values with their classes and units."""
        for block in self.blocks:
            yield from block.values()
