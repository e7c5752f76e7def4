"""Keywords, and the blocks that begin with them, where the grammar allows them next."""

from collections.abc import Iterator

from kindsl.frontends.features.completion import snippets
from kindsl.frontends.features.completion.context import CompletionContext, sections_of
from kindsl.frontends.features.completion.item import CompletionItem
from kindsl.frontends.features.completion.names import (
    bodies_at,
    first_child,
    fresh_joint,
    fresh_link,
    joint_id,
    next_id,
    undeclared_joints,
    undeclared_links,
)
from kindsl.frontends.features.tree_path import path_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.syntax.sections import ORDER
from kindsl.language.syntax.tables import WORDS
from kindsl.language.syntax.tree import Node
from kindsl.language.syntax.vocabulary import of_kind, token_kind

_BLOCKS = ORDER.keys() - {"document"}
_MANY = of_kind("moments")
_BLOCK_WORDS = frozenset(("Robot", "RobotBase", "link", "JOINT_KIND"))


def block_items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the blocks that may come next in the document, none after its last brace."""
    model = analysis.model
    if not context.expected & _BLOCK_WORDS:
        return
    before = {n.kind for nodes in _blocks_before(analysis, context) for n in nodes}
    if "end" in before:
        return
    if "head" not in before and not model.name:
        yield _snippet("Robot", snippets.robot(), "a whole document")
    elif model.base is None and not (before & {"link", "joint"}):
        yield _snippet("RobotBase", snippets.base(""), "fixed base")
        yield _snippet("RobotBase floating", snippets.base("floating"), "floating base")
    if "base" in before and "joint" not in before:
        name = next(undeclared_links(analysis), None) or fresh_link(analysis)
        yield _snippet("link", snippets.link(name, next_id(analysis)), "link with inertia")
    if "link" in before and not _has_link_behind(analysis, context):
        name = next(undeclared_joints(analysis), None) or fresh_joint(analysis)
        yield _snippet("r_joint", snippets.joint("r_joint", name), "revolute joint")
        yield _snippet("p_joint", snippets.joint("p_joint", name), "prismatic joint")


def section_items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the missing sections of the open block that may come here."""
    order = ORDER[context.block] if context.block in _BLOCKS else {}
    before = {order[node.kind].rank for node in context.sections}
    behind = {order[node.kind].rank for node in _sections_behind(context)}
    sections = list(order.items())
    if context.block == "joint":
        # The number of a joint is optional and ignored.
        sections.reverse()
    for kind, (rank, _) in sections:
        alike = {rank} if kind in _MANY else set()
        is_behind = all(other < rank for other in before - alike)
        if is_behind and all(rank < other for other in behind - alike):
            yield from _moments(context) if alike else _section(analysis, context, kind)


def keyword_items(context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the words that the grammar allows and that are no section: `floating`, `via`."""
    if "FLOATING" in context.expected:
        yield CompletionItem("floating", "keyword", "floating", "floating base")
    if "via" in context.expected and context.block == "children":
        yield CompletionItem("via", "keyword", "via", "joint between the two links")


def _section(analysis: Analysis, context: CompletionContext, kind: str) -> Iterator[CompletionItem]:
    word = WORDS[kind][0]
    if token_kind(kind) not in context.expected:
        return
    if context.block == "joint" and kind == "id":
        text = f"id = ${{1:{joint_id(analysis, context)}}}"
        yield _snippet(word, text, "optional number of the joint")
        return
    yield _snippet(word, _section_text(analysis, context, kind), _DETAILS.get(kind, ""))
    if kind == "children":
        yield CompletionItem("children {}", "snippet", "children {}", "no children")


def _section_text(analysis: Analysis, context: CompletionContext, kind: str) -> str:
    if kind == "id":
        return f"id = ${{1:{next_id(analysis, bodies_at(context))}}}"
    if kind == "children":
        return snippets.children(*first_child(analysis, context))
    return snippets.section(kind)


_DETAILS = {
    "id": "number of the link",
    "inertia": "mass, CoM and moments in the link frame",
    "children": "the children of this link",
    "frames": "optional frames fixed to this link",
    "joint_frame": "joint frame in the predecessor",
    "mass": "kg",
    "com": "m, in the link frame",
    "inertia_frame": "the frame that CoM and moments are given in",
    "translation": "m",
    "rotation": "rad, intrinsic x, y, z",
}


def _moments(context: CompletionContext) -> Iterator[CompletionItem]:
    """Yield the moments and products that are not there, and all of them at once."""
    if "MOMENT" not in context.expected:
        return
    nodes = (*context.sections, *_sections_behind(context))
    there = {next(node.tokens()).text for node in nodes}
    missing = [name for name in snippets.MOMENT_DEFAULTS if name not in there]
    if len(missing) > 1:
        text = "\n".join(
            f"{name} = ${{{number}:{snippets.MOMENT_DEFAULTS[name]}}}"
            for number, name in enumerate(missing, 1)
        )
        label = f"{missing[0]} … {missing[-1]}"
        yield _snippet(label, text, "all that are missing, kg·m²")
    for name in missing:
        default = snippets.MOMENT_DEFAULTS[name]
        yield _snippet(name, f"{name} = ${{1:{default}}}", "kg·m², about the origin")


def _sections_behind(context: CompletionContext) -> list[Node]:
    """Return the sections of the open block behind the cursor, as the whole document has them."""
    local = context.start - context.place.start
    path = path_at(context.place.island, local)
    end = context.end - context.place.start
    return [node for node in sections_of(path, context.block) if end <= node.start < node.end]


def _blocks_before(analysis: Analysis, context: CompletionContext) -> Iterator[tuple[Node, ...]]:
    """Yield the blocks that begin before the cursor, island by island."""
    for island in analysis.syntax.islands[: context.place.index]:
        yield island.nodes
    local = context.start - context.place.start
    nodes = context.place.island.nodes
    yield tuple(node for node in nodes if node.children and node.start < local)


def _has_link_behind(analysis: Analysis, context: CompletionContext) -> bool:
    islands = range(context.place.index + 1, len(analysis.syntax))
    return any(
        node.kind == "link"
        for index in islands
        for node in analysis.syntax.island(index).island.nodes
    )


def _snippet(label: str, text: str, detail: str) -> CompletionItem:
    return CompletionItem(label, "snippet", text, detail)
