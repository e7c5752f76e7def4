"""Parents and children as other formats name them: `parent = base` in a link or a joint.

Here a parent lists its children. The search for repairs would take `parent {` for `children {`,
which is the contrary.
"""

from collections.abc import Sequence

from kindsl.syntax.tree import Edit, Problem, Repair, Token
from kindsl.syntax.words import shown

_OPENERS = {"link": "link", "JOINT_KIND": "joint"}
_RELATIVES = {"link": frozenset({"parent"}), "joint": frozenset({"parent", "child"})}
_SIGNS = frozenset("{}(")
_CLOSING = {"{": "}", "(": ")"}


def without_relatives(
    text: str, tokens: Sequence[Token], problems: list[Problem]
) -> tuple[list[Token], list[Token]]:
    """Return tokens without what names relatives, and those that are left out; tell of each."""
    kept: list[Token] = []
    left_out: list[Token] = []
    opened: list[str] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        block = opened[0] if len(opened) == 1 else ""
        if token.kind == "NAME" and token.text in _RELATIVES.get(block, ()):
            end = _statement_end(text, tokens, index)
            problems.append(_problem(text, block, tokens[index:end]))
            left_out += tokens[index:end]
            index = end
            continue
        if token.kind in _SIGNS:
            _follow(opened, tokens, index)
        kept.append(token)
        index += 1
    return kept, left_out


def _follow(opened: list[str], tokens: Sequence[Token], index: int) -> None:
    """Keep the blocks that are open, the outermost by what it is."""
    if tokens[index].kind == "{":
        opened.append(_OPENERS.get(tokens[index - 2].kind, "") if index > 1 else "")
    elif tokens[index].kind == "}" and opened:
        opened.pop()


def _statement_end(text: str, tokens: Sequence[Token], index: int) -> int:
    """Return the index behind `parent = a`, `parent a`, `parent { ... }` or what there is of it."""
    end = index + 1
    if end < len(tokens) and tokens[end].kind == "=":
        end += 1
    if end >= len(tokens) or "\n" in text[tokens[end - 1].end : tokens[end].start]:
        return end
    closing = _CLOSING.get(tokens[end].kind)
    if closing is None:
        return end + (tokens[end].text[:1].isidentifier() or tokens[end].text[:1].isdigit())
    depth = 0
    for behind in range(end, len(tokens)):
        depth += (tokens[behind].kind == tokens[end].kind) - (tokens[behind].kind == closing)
        if depth == 0:
            return behind + 1
    return end


def _problem(text: str, block: str, tokens: Sequence[Token]) -> Problem:
    word, end = tokens[0], tokens[-1].end
    what = f"a {block} has no '{word.text}'"
    message = f"{what}: parents list their links and joints under 'children'"
    title = f"Remove '{shown(text[word.start : end])}'"
    repair = Repair(title, (Edit(word.start, end, ""),), False)
    return Problem("KD001", message, word.start, word.end, repair)
