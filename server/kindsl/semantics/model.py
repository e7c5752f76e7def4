"""The robot that a document describes, as far as it describes one."""

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import TypeVar

from kindsl.semantics.declarations import Declarations, Frame, Joint, Link
from kindsl.semantics.kinematic_tree import KinematicTree
from kindsl.semantics.lowering import declarations
from kindsl.semantics.parameters import (
    Constant,
    Parameter,
    Symbols,
    constants_of,
    island_symbols,
    parameters_of,
)
from kindsl.syntax.tree import Island
from kindsl.text.facts import Facts

_Named = TypeVar("_Named", Link, Joint)


class Model:
    """Links, joints, frames and parameters of a document, whole or broken.

    Attributes:
        islands: The pieces of the document, in order.
        declared: What each of them declares.
        name: The robot's name, empty where it is missing.
        base: The robot's base, the first if there are several.
        bases: All bases.
        links: The links without the base, in the order of the document.
        joints: The joints in the order of the document.
        facts: What later layers derived from it, kept as long as the model lives.
    """

    def __init__(self, islands: Sequence[Island]) -> None:
        self.islands = islands
        self.facts = Facts()
        self.declared: list[Declarations] = [declarations(island) for island in islands]
        self.bases: list[Link] = []
        self.links: list[Link] = []
        self.joints: list[Joint] = []
        self.name: str = ""
        for declared in self.declared:
            self.name = self.name or declared.robot or ""
            self.bases += declared.bases
            self.links += declared.links
            self.joints += declared.joints
        self.base = self.bases[0] if self.bases else None

    @property
    def floating(self) -> bool:
        """True if the base floats."""
        return self.base is not None and self.base.is_floating

    @property
    def bodies(self) -> list[Link]:
        """The bases, then the links."""
        return [*self.bases, *self.links]

    @cached_property
    def frames(self) -> list[Frame]:
        """The optional frames of all bodies, in the order of the document."""
        return [frame for body in self.bodies for frame in body.frames]

    @cached_property
    def body_named(self) -> dict[str, Link]:
        """Bodies by name: the base before the links, of equal names the first."""
        return _by_name(self.bodies)

    @cached_property
    def joint_named(self) -> dict[str, Joint]:
        """Joints by name, of equal names the first."""
        return _by_name(self.joints)

    @cached_property
    def tree(self) -> KinematicTree:
        """The kinematic tree, or what is written instead of one."""
        return KinematicTree(self.bodies, self.body_named, self.joint_named, self.base)

    @cached_property
    def symbols(self) -> list[Symbols]:
        """The parameters and constants that each island uses."""
        return list(map(island_symbols, self.islands, self.declared))

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters in the order of their first places."""
        return parameters_of(use for symbols in self.symbols for use in symbols.parameters)

    @cached_property
    def constants(self) -> tuple[Constant, ...]:
        """The named constants in the order of their first places."""
        return constants_of(use for symbols in self.symbols for use in symbols.constants)

    @cached_property
    def broken_islands(self) -> list[Island]:
        """The islands whose text is not in the language."""
        return [island for island in self.islands if island.problems]

    def is_mentioned_in_broken_text(self, word: str, elsewhere_than: Island) -> bool:
        """Return whether a word stands in an island with syntax errors other than this one.

        What such an island says of the word may be lost, so nothing is concluded from its absence.
        """
        return any(
            island is not elsewhere_than for island in self._islands_of_broken_words.get(word, ())
        )

    @cached_property
    def _islands_of_broken_words(self) -> dict[str, list[Island]]:
        found: dict[str, list[Island]] = {}
        for island in self.broken_islands:
            for word in {token.text.removeprefix("^") for token in island.tokens}:
                found.setdefault(word, []).append(island)
        return found


def _by_name(things: Iterable[_Named]) -> dict[str, _Named]:
    found: dict[str, _Named] = {}
    for thing in things:
        if thing.name:
            found.setdefault(str(thing.name), thing)
    return found
