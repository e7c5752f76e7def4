"""What may be typed at an offset."""

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import NamedTuple

from kindsl.analysis.analysis import Analysis
from kindsl.features.completion import snippets
from kindsl.features.completion.context import CompletionContext, completion_context
from kindsl.features.completion.item import CompletionItem
from kindsl.features.completion.keywords import block_items, floating_item, section_items
from kindsl.features.completion.names import (
    child_items,
    id_items,
    joint_items,
    new_joint_items,
    new_link_items,
    own_frame_items,
)
from kindsl.features.completion.values import constant_items, value_items
from kindsl.features.hover.joint import joint_hover
from kindsl.features.hover.keyword import keyword_hover
from kindsl.features.hover.link import link_hover
from kindsl.features.hover.parameter import constant_hover, parameter_hover
from kindsl.features.workspace_symbols import is_match

_MOST = 100
_BLOCK_WORDS = frozenset(("Robot", "RobotBase", "link", "JOINT_KIND"))


class Completions(NamedTuple):
    """What may be typed.

    Attributes:
        items: The best first.
        start: Start of the word that they replace.
        end: Its end.
        is_incomplete: Whether there is more, to be asked for when more is typed.
    """

    items: tuple[CompletionItem, ...]
    start: int
    end: int
    is_incomplete: bool = False


def completions(analysis: Analysis, offset: int) -> Completions:
    """Return what may be typed at an offset, also in half-typed text; often nothing."""
    context = completion_context(analysis, offset)
    if context is None:
        return Completions((), offset, offset)
    word = context.word.removeprefix("^")
    fitting = (i for i in _items(analysis, context) if is_match(word, i.label))
    found = list(islice(fitting, _MOST + 1))
    best = sorted(dict.fromkeys(found[:_MOST]), key=lambda item: item.rank)
    return Completions(tuple(best), context.start, context.end, len(found) > _MOST)


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


def _items(analysis: Analysis, context: CompletionContext) -> Iterator[CompletionItem]:
    expected = context.expected
    if expected & _BLOCK_WORDS:
        yield from block_items(analysis, context)
    yield from section_items(context)
    yield from floating_item(context)
    if "FLOAT" in expected and context.value is not None:
        yield from value_items(analysis, context, context.value)
    elif "NAME" in expected:
        yield from _names(analysis, context)
    elif "INT" in expected:
        yield from id_items(analysis, context)


def _names(analysis: Analysis, context: CompletionContext) -> Iterable[CompletionItem]:
    previous = context.previous.kind if context.previous is not None else ""
    if previous == "<":
        return constant_items(analysis, "{}")
    if previous == "link":
        return new_link_items(analysis)
    if previous == "JOINT_KIND":
        return new_joint_items(analysis)
    if previous == "via":
        return joint_items(analysis)
    if previous == "=":
        return own_frame_items(context)
    if context.block == "children":
        return child_items(analysis)
    if context.block == "frame_group":
        text = snippets.frame()
        return (CompletionItem("frame", "snippet", text, "a frame of this link", 1, True),)
    return ()
