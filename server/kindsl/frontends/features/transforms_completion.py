"""Completions in a transforms document."""

import re
from collections.abc import Iterator

from kindsl.frontends.features.completion.completion import Completions
from kindsl.frontends.features.completion.item import CompletionItem
from kindsl.frontends.features.workspace_symbols import is_match
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.transforms import frame_names
from kindsl.language.syntax.transforms_text import SECTIONS, read_transforms

_WORD_BEFORE = re.compile(r"\w*\Z")
_BEHIND_WORD = re.compile(r"\W")
_PAIR = "base=${1:frame}, target=${2:frame}"


def transforms_completions(text: str, offset: int, model: Model | None) -> Completions:
    """Return what may be typed at an offset; nothing where a whole word stands.

    Args:
        text: The transforms document.
        offset: The cursor, code points.
        model: The robot that it is about, None if that is not known.
    """
    word: str = _WORD_BEFORE.findall(text, 0, offset)[0]
    start = offset - len(word)
    end = offset + len(_BEHIND_WORD.split(text[offset:])[0])
    items = tuple(_items(text, start, model))
    if word and any(item.label == word for item in items):
        items = ()
    return Completions(tuple(item for item in items if is_match(word, item.label)), start, end)


def _items(text: str, start: int, model: Model | None) -> Iterator[CompletionItem]:
    """Yield what can stand at a place: what a reader that comes there expects."""
    before = read_transforms(text[:start])
    if not before.expected:
        sections = [name for name in SECTIONS if not re.search(rf"\b{name}\b", text)]
        yield from (_block(name) for name in sections)
    for expected in before.expected:
        if expected == "a frame":
            yield from _frames(text, start, model)
        elif expected == "a robot name":
            yield from (CompletionItem(n, "link", n, "the robot") for n in _robot(model))
        elif expected == "'base'":
            yield CompletionItem(
                "base, target", "snippet", _PAIR, "a pair of frames", is_snippet=True
            )
        elif expected in ("'target'", "'Robot'"):
            name = expected.strip("'")
            yield CompletionItem(name, "keyword", f"{name}=" if name == "target" else f"{name} ")


def _frames(text: str, start: int, model: Model | None) -> Iterator[CompletionItem]:
    """Yield frames: of pairs those that are listed, of the list those that are not yet."""
    listed = [word.text for word in read_transforms(text).frames if word.start != start]
    known = frame_names(model) if model is not None else {}
    is_in_pair = text[:start].rstrip().endswith("=")
    names = listed if is_in_pair and listed else [n for n in known if n not in listed]
    for name in names:
        of = known.get(name, name)
        yield CompletionItem(name, "frame", name, "" if of == name else f"frame of {of}")


def _robot(model: Model | None) -> list[str]:
    return [str(model.name)] if model is not None and model.name else []


def _block(name: str) -> CompletionItem:
    return CompletionItem(name, "snippet", f"{name} {{\n\t$0\n}}", "section", is_snippet=True)
