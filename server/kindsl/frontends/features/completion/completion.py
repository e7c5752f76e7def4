"""Completions at an offset: all of them on request, a careful choice during typing."""

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import NamedTuple

from kindsl.frontends.features.completion.context import CompletionContext, completion_context
from kindsl.frontends.features.completion.item import CompletionItem
from kindsl.frontends.features.completion.keywords import block_items, keyword_items, section_items
from kindsl.frontends.features.completion.names import (
    child_items,
    frame_names_at,
    id_items,
    joint_items,
    name_items,
    new_frame_items,
    undeclared_joints,
    undeclared_links,
)
from kindsl.frontends.features.completion.values import constant_items, shape_items, value_items
from kindsl.frontends.features.hover.keyword import keyword_hover
from kindsl.frontends.features.hover.parameter import constant_hover, parameter_hover
from kindsl.frontends.features.hover.things import joint_hover, link_hover
from kindsl.frontends.features.outline import is_match
from kindsl.judgement.analysis.analysis import Analysis

_MOST = 100


class Completions(NamedTuple):
    """The completions; asked for again at each key, since the word may be whole then.

    Attributes:
        items: The best first.
        start: Start of the word that they replace; of its line, where blocks stand unindented.
    """

    items: tuple[CompletionItem, ...]
    start: int
    end: int


def completions(analysis: Analysis, offset: int) -> Completions:
    """Return all that may be typed at an offset, also in half-typed text; often nothing."""
    context = completion_context(analysis, offset)
    if context is None:
        return Completions((), offset, offset)
    word = _typed(context)
    fitting = (i for i in _items(analysis, context) if is_match(word, i.label) and i.text != word)
    return _best(fitting, context)


def narrowed(analysis: Analysis, offset: int) -> Completions:
    """Return the remaining completions while typing continues."""
    context = completion_context(analysis, offset)
    if context is None or _is_whole(_typed(context), _items(analysis, context)):
        return Completions((), offset, offset)
    return completions(analysis, offset)


def suggestions(analysis: Analysis, offset: int) -> Completions:
    """Return what an editor may show unasked while someone types, when Enter would accept it.

    Nothing where the word that stands there is whole, or may become a new name; only what begins
    with it.
    """
    context = completion_context(analysis, offset)
    if context is None or not (context.word or context.is_after_blank):
        return Completions((), offset, offset)
    items = list(_items(analysis, context))
    word = _typed(context)
    if _is_whole(word, items):
        return Completions((), offset, offset)
    return _best((i for i in items if not i.is_asked_for and _begins(i.label, word)), context)


def documentation(analysis: Analysis, item_kind: str, label: str) -> str | None:
    """Return the text beside the list for an item, Markdown; asked for one at a time."""
    name = label.split(" ")[0].strip("<>")
    if item_kind == "link":
        link = analysis.model.body_named.get(name)
        return link_hover(analysis, link) if link is not None else None
    if item_kind == "joint":
        joint = analysis.model.joint_named.get(name)
        return joint_hover(analysis, joint) if joint is not None else None
    if item_kind == "parameter":
        return parameter_hover(analysis, name)
    if item_kind == "constant":
        return constant_hover(analysis, name)
    return keyword_hover(name)


def _best(fitting: Iterable[CompletionItem], context: CompletionContext) -> Completions:
    start = context.line_start if context.block == "document" else context.start
    return Completions(tuple(dict.fromkeys(islice(fitting, _MOST))), start, context.end)


def _typed(context: CompletionContext) -> str:
    return context.word.removeprefix("^")


def _is_whole(word: str, items: Iterable[CompletionItem]) -> bool:
    return bool(word) and any(word in (item.text, item.label) for item in items)


def _begins(label: str, word: str) -> bool:
    return label.lstrip("<-")[: len(word)].casefold() == word.casefold()


def _items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    expected = context.expected
    if "FLOAT" in expected and context.value is not None:
        yield from value_items(analysis, context, context.value)
    elif "INT" in expected:
        yield from id_items(analysis, context)
    else:
        yield from block_items(analysis, context)
        yield from section_items(analysis, context)
        yield from keyword_items(context)
        yield from shape_items(context)
        yield from _names(analysis, context)


def _names(analysis: Analysis, context: CompletionContext) -> Iterable[CompletionItem]:
    if "NAME" not in context.expected:
        return ()
    previous = context.previous.kind
    if previous == "<":
        return constant_items(analysis, "{}")
    if previous == "link":
        return name_items(undeclared_links(analysis), "link", "named as a child, not declared")
    if previous == "JOINT_KIND":
        return name_items(undeclared_joints(analysis), "joint", "used, not declared")
    if previous == "via":
        return joint_items(analysis, context)
    if previous == "=":
        return name_items(frame_names_at(context), "frame", "frame of this link")
    if context.block == "children":
        return child_items(analysis, context)
    if context.block == "frame_group":
        return new_frame_items(context)
    return ()
