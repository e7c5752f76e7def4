"""Children that are still being typed: `upper`, `upper via`, with nothing behind it on its line.

The search for repairs would rather close the block there, which tells a typist nothing.
"""

from collections.abc import Sequence

from kindsl.syntax.tree import Problem, Token
from kindsl.syntax.words import called, shown, supplied

_CHILD = ("NAME", "via", "NAME")


def with_whole_children(text: str, tokens: Sequence[Token], problems: list[Problem]) -> list[Token]:
    """Return tokens with what half a child lacks supplied; tell of each."""
    found: list[Token] = []
    place = -1
    for index, token in enumerate(tokens):
        if place > 0 and place < len(_CHILD) and not _goes_on(text, tokens, index, _CHILD[place]):
            before = tokens[index - 1]
            message = f"expected {called(_CHILD[place])} after '{shown(before.text)}'"
            problems.append(Problem("KD001", message, before.end, before.end))
            found += [supplied(kind, before.end) for kind in _CHILD[place:]]
            place = len(_CHILD)
        found.append(token)
        place = _next_place(tokens, index, place)
    return found


def _next_place(tokens: Sequence[Token], index: int, place: int) -> int:
    """Return how many tokens of a child stand up to an index; -1 outside of `children`."""
    token = tokens[index]
    if token.kind == "{" and index and tokens[index - 1].kind == "children":
        return 0
    if place < 0 or token.kind == "}":
        return -1
    place %= len(_CHILD)
    return place + 1 if token.kind == _CHILD[place] else -1


def _goes_on(text: str, tokens: Sequence[Token], index: int, wanted: str) -> bool:
    """Return whether a child goes on at a token, as it should or in a way that others mend."""
    token, before = tokens[index], tokens[index - 1]
    if token.kind == wanted and not (wanted == "NAME" and _is_new_child(text, tokens, index)):
        return True
    is_new_line = "\n" in text[before.end : token.start]
    return token.kind != "}" and not (is_new_line and token.kind == "NAME")


def _is_new_child(text: str, tokens: Sequence[Token], index: int) -> bool:
    """Return whether a name on the next line begins a child of its own."""
    is_new_line = "\n" in text[tokens[index - 1].end : tokens[index].start]
    return is_new_line and index + 1 < len(tokens) and tokens[index + 1].kind == "via"
