"""The one fold of the tree: nodes to blocks, sections and values, as far as these are there."""

from collections.abc import Callable, Iterator
from typing import Any, TypeAlias, TypeVar, cast

from kindsl.language.semantics.blocks import Block, NameReference, Vector, Whole
from kindsl.language.semantics.declarations import Declarations, Joint, Link
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.places import Name, Place
from kindsl.language.semantics.sections import BLOCKS, ROWS
from kindsl.language.syntax.tables import DECLARES, KINDS
from kindsl.language.syntax.tree import Island, Node, Token
from kindsl.language.syntax.vocabulary import meanings
from kindsl.language.text.facts import kept

_Block = TypeVar("_Block", bound=Block)
_Found: TypeAlias = dict[str, Any]
_NO_NAME = Name("")


class OtherIsland(Island):
    """An island of another syntax that provides its declarations itself."""

    def declared(self) -> Declarations:
        """Return what it declares."""
        raise NotImplementedError


@kept
def declarations(island: Island) -> Declarations:
    """Return what an island declares; computed once in its life."""
    if isinstance(island, OtherIsland):
        return island.declared()
    robot: Name | None = None
    bases: list[Link] = []
    links: list[Link] = []
    joints: list[Joint] = []
    blocks: list[Block] = []
    for node in island.nodes:
        if node.kind == "link":
            links.append(_block(Link, node, island))
            blocks.append(links[-1])
        elif node.kind == "joint":
            joints.append(_block(Joint, node, island))
            blocks.append(joints[-1])
        elif node.kind == "base":
            bases.append(_block(Link, node, island))
            bases[-1].id, bases[-1].id_place = 0, None
            blocks.append(bases[-1])
        elif node.kind == "head":
            blocks.append(_block(Block, node, island))
            robot = blocks[-1].name
    return Declarations(robot, tuple(bases), tuple(links), tuple(joints), tuple(blocks))


def _block(of: type[_Block], node: Node, island: Island, owner: str = "") -> _Block:
    name = next(_names(node, island)) if node.kind in DECLARES else _NO_NAME
    block = of(node, island, name, owner)
    found: _Found = {}
    for child in node.children:
        if child.__class__ is Node:
            _READERS[KINDS[child.kind]](block, child, found)
    for section, attribute, empty in _FIELDS[of]:
        setattr(block, attribute, found.get(section, empty))
    return block


def _fields(of: type[Block]) -> list[tuple[str, str, object]]:
    """Return the attributes of a block by what is found in it, and their empty values."""
    fields: list[tuple[str, str, object]] = []
    for section, attribute in of.attributes.items():
        fields.append((section, attribute, _EMPTY.get(KINDS[section])))
        if KINDS[section] == "whole":
            fields.append((f"{section} place", f"{attribute}_place", None))
    return fields


def _read_scalar(block: Block, section: Node, found: _Found) -> None:
    value = Expression(cast(Node, section.children[-1]), block.island, *meanings(section))
    block.parts.append(value)
    found.setdefault(section.kind, value)


def _read_moment(block: Block, section: Node, found: _Found) -> None:
    value = Expression(cast(Node, section.children[-1]), block.island, *meanings(section))
    block.parts.append(value)
    found.setdefault(section.kind, {}).setdefault(cast(Token, section.children[0]).text, value)


def _read_vector(block: Block, section: Node, found: _Found) -> None:
    node, island = cast(Node, section.children[-1]), block.island
    pairs = zip(node.children[1::2], meanings(section), strict=True)
    x, y, z = (Expression(cast(Node, child), island, meaning) for child, meaning in pairs)
    block.parts += (x, y, z)
    found.setdefault(section.kind, Vector(node, island, (x, y, z)))


def _read_whole(block: Block, section: Node, found: _Found) -> None:
    token = cast(Token, section.children[-1])
    place = Place(block.island, token.start, token.end)
    try:
        value = None if token.is_missing else int(token.text)
    except ValueError:
        value = None
    block.parts.append(Whole(section.kind, token, value))
    found.setdefault(section.kind, value)
    found.setdefault(f"{section.kind} place", place)


def _read_name(block: Block, section: Node, found: _Found) -> None:
    names = tuple(_names(section, block.island))
    block.parts.append(NameReference(section.kind, names))
    found.setdefault(section.kind, names[0])


def _read_block(block: Block, section: Node, found: _Found) -> None:
    inner = _inner(block, section)
    if section.kind not in found or not found[section.kind].parts:
        found[section.kind] = inner


def _read_list(block: Block, section: Node, found: _Found) -> None:
    known = found.setdefault(section.kind, ())
    found[section.kind] = known + tuple(_listed(block, section))


def _listed(block: Block, section: Node) -> Iterator[Any]:
    for child in section.children:
        if not isinstance(child, Node):
            continue
        if child.kind in ROWS:
            names = tuple(_names(child, block.island))
            block.parts.append(NameReference(child.kind, names))
            yield ROWS[child.kind](*names)
        elif child.kind in BLOCKS:
            yield _inner(block, child)
        else:
            yield from _listed(block, child)


def _inner(block: Block, node: Node) -> Block:
    inner = _block(BLOCKS[node.kind], node, block.island, str(block.name) or block.owner)
    block.parts.append(inner)
    return inner


_EMPTY: dict[str, object] = {"moments": {}, "list": (), "groups": ()}
_FIELDS: dict[type[Block], list[tuple[str, str, object]]] = {
    of: _fields(of) for of in (Block, Link, Joint, *BLOCKS.values())
}
_READERS: dict[str, Callable[[Block, Node, _Found], None]] = {
    "scalar": _read_scalar,
    "moments": _read_moment,
    "vector": _read_vector,
    "whole": _read_whole,
    "name": _read_name,
    "block": _read_block,
    "pose": _read_block,
    "list": _read_list,
    "groups": _read_list,
}


def _names(node: Node, island: Island) -> Iterator[Name]:
    """Yield the names directly in a node, empty where they are missing."""
    for token in node.children:
        if token.kind == "NAME":
            text = cast(Token, token).text
            yield Name.at(text.removeprefix("^"), island, token.start, token.end)
