"""The topology of a mechanism: names, kinds of joints, parents."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from kindsl.mechanics.rigid.joint_kind import JointKind


@dataclass(frozen=True, slots=True, eq=False)
class Topology:
    """A tree of bodies: the base, body 0, and the links 1 to n, parents before children.

    Link i and its supporting joint i have the index i - 1 in what has a length of n.

    Attributes:
        base_name: The base's name.
        link_names: Names of the n links.
        joint_names: Names of the n supporting joints.
        joint_kinds: `"revolute"` (turns about the joint frame's z) or `"prismatic"` (slides
            along it).
        parents: Body index of each link's parent, less than the link's own.
    """

    base_name: str
    link_names: tuple[str, ...]
    joint_names: tuple[str, ...]
    joint_kinds: tuple[JointKind, ...]
    parents: tuple[int, ...]

    @property
    def body_names(self) -> tuple[str, ...]:
        """The base's name and the links'."""
        return (self.base_name, *self.link_names)

    @property
    def n_links(self) -> int:
        """Number of moving links, which is also the number of joints."""
        return len(self.link_names)

    def links(self) -> Iterator[tuple[int, int]]:
        """Yield each link's body index and its parent's, parents first."""
        return enumerate(self.parents, start=1)


def check_topology(tree: Topology, frame_names: Iterable[str]) -> None:
    """Check the numbering and the names of a tree with further named frames.

    Raises:
        ValueError: An attribute has not one entry a link, a parent is not before its link, a kind
            is unknown, or a name stands for two things.
    """
    n = tree.n_links
    for attribute in ("joint_names", "joint_kinds", "parents"):
        if len(getattr(tree, attribute)) != n:
            got = len(getattr(tree, attribute))
            raise ValueError(f"{attribute} has {got} entries, expected {n}, one per link")
    for link, parent in tree.links():
        name = tree.link_names[link - 1]
        if not 0 <= parent < link:
            raise ValueError(f"link '{name}' is body {link}: its parent {parent} is not before it")
        if tree.joint_kinds[link - 1] not in ("revolute", "prismatic"):
            kind = tree.joint_kinds[link - 1]
            raise ValueError(f"joint of '{name}': '{kind}' is neither revolute nor prismatic")
    _check_unique((*tree.body_names, *frame_names))
    _check_unique(tree.joint_names)


def _check_unique(names: Iterable[str]) -> None:
    seen: set[str] = set()
    for name in names:
        if name in seen:
            raise ValueError(f"the name '{name}' is used twice")
        seen.add(name)
