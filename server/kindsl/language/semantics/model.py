"""The robot that a document describes, as far as it describes one."""

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import NamedTuple, TypeVar

from kindsl.language.semantics.aspects import edition
from kindsl.language.semantics.declarations import Declarations, Frame, Joint, Link
from kindsl.language.semantics.expressions import ConstantUse
from kindsl.language.semantics.kinematic_tree import KinematicTree
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.parameters import (
    Constant,
    Parameter,
    Symbols,
    Use,
    constants_of,
    island_symbols,
    parameters_of,
)
from kindsl.language.syntax.document import Chunk, SyntaxDocument
from kindsl.language.syntax.tree import Island
from kindsl.language.text.facts import Facts, kept
from kindsl.language.text.groups import grouped

_Named = TypeVar("_Named", Link, Joint)


class ModelPart(NamedTuple):
    """Declarations and uses in the islands of a chunk, in their order.

    Attributes:
        robot: The first name of a robot, empty where there is none.
        link_named: Links by name, of equal names the first.
        joint_named: Joints by name, of equal names the first.
        broken_islands: Islands whose text is not in the language.
    """

    declared: list[Declarations]
    symbols: list[Symbols]
    robot: str
    bases: list[Link]
    links: list[Link]
    joints: list[Joint]
    link_named: dict[str, Link]
    joint_named: dict[str, Joint]
    parameters: list[Use]
    constants: list[ConstantUse]
    broken_islands: list[Island]


@kept
def model_part(chunk: Chunk) -> ModelPart:
    """Return what a chunk adds to a model; kept with it."""
    declared = list(map(declarations, chunk.islands))
    symbols = list(map(island_symbols, chunk.islands))
    links = [link for each in declared for link in each.links]
    joints = [joint for each in declared for joint in each.joints]
    return ModelPart(
        declared,
        symbols,
        next((each.robot for each in declared if each.robot), ""),
        [base for each in declared for base in each.bases],
        links,
        joints,
        _by_name(links),
        _by_name(joints),
        [use for each in symbols for use in each.parameters],
        [use for each in symbols for use in each.constants],
        [island for island in chunk.islands if island.problems],
    )


class Model:
    """Links, joints, frames and parameters of a document, whole or broken.

    Attributes:
        name: The robot's name, empty where it is missing.
        base: The robot's base, the first if there are several.
        links: The links without the base, in the order of the document.
        edition: This version, as it follows the one before.
        facts: Results of later layers, kept as long as the model lives.
    """

    def __init__(self, document: SyntaxDocument) -> None:
        self.document = document
        self.facts = Facts()
        self.parts = list(map(model_part, document.chunks))
        self.name = next((part.robot for part in self.parts if part.robot), "")
        self.bases = [base for part in self.parts for base in part.bases]
        self.links = [link for part in self.parts for link in part.links]
        self.joints = [joint for part in self.parts for joint in part.joints]
        self.base = self.bases[0] if self.bases else None
        self.edition = edition(document)

    @property
    def islands(self) -> Sequence[Island]:
        """The pieces of the document, in order."""
        return self.document.islands

    @cached_property
    def declared(self) -> list[Declarations]:
        """Declarations of each piece."""
        return [declared for part in self.parts for declared in part.declared]

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
        return _joined([_by_name(self.bases), *(part.link_named for part in self.parts)])

    @cached_property
    def joint_named(self) -> dict[str, Joint]:
        """Joints by name, of equal names the first."""
        return _joined(part.joint_named for part in self.parts)

    @cached_property
    def tree(self) -> KinematicTree:
        """The kinematic tree as far as the document describes one."""
        return KinematicTree(self.bodies, self.body_named, self.joint_named, self.base)

    @cached_property
    def symbols(self) -> list[Symbols]:
        """The parameters and constants that each piece uses."""
        return [symbols for part in self.parts for symbols in part.symbols]

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters in the order of their first places."""
        return parameters_of(use for part in self.parts for use in part.parameters)

    @cached_property
    def constants(self) -> tuple[Constant, ...]:
        """The named constants in the order of their first places."""
        return constants_of(use for part in self.parts for use in part.constants)

    @cached_property
    def broken_islands(self) -> list[Island]:
        """The islands whose text is not in the language."""
        return [island for part in self.parts for island in part.broken_islands]

    def is_mentioned_in_broken_text(self, word: str, elsewhere_than: Island) -> bool:
        """Return whether a word stands in an island with syntax errors other than this one.

        Such an island may have lost what is missing, so nothing is concluded from its absence.
        """
        return any(
            island is not elsewhere_than for island in self._islands_of_broken_words.get(word, ())
        )

    @cached_property
    def _islands_of_broken_words(self) -> dict[str, list[Island]]:
        return grouped(
            (word, island)
            for island in self.broken_islands
            for word in {token.text.removeprefix("^") for token in island.tokens}
        )


def _by_name(things: Iterable[_Named]) -> dict[str, _Named]:
    found: dict[str, _Named] = {}
    for thing in things:
        if thing.name:
            found.setdefault(str(thing.name), thing)
    return found


def _joined(parts: Iterable[dict[str, _Named]]) -> dict[str, _Named]:
    found: dict[str, _Named] = {}
    for part in parts:
        is_new = found.keys().isdisjoint(part)
        found.update(part if is_new else {n: part[n] for n in part if n not in found})
    return found
