"""What other formats and habits call the sections: `Ixx`, `com`, `rpy`; each is one word of ours.

Asked before any spelling is compared, since `Ixx` is nearer to `Ixy` than to `Ix`, which it means.

Parents and children are named there from below: `parent = base` in a link or a joint. Here a parent
lists its children; the search for repairs would take `parent {` for `children {`, the contrary.
"""

import re
from collections.abc import Sequence
from itertools import pairwise

from kindsl.syntax.scanner import word_kind
from kindsl.syntax.tables import KEYWORDS
from kindsl.syntax.token_names import shown, unknown_keyword
from kindsl.syntax.tree import Edit, Problem, Repair, Token

_MEANT = {
    "id": "id",
    "mass": "mass",
    "com": "CoM",
    "cog": "CoM",
    "centerofmass": "CoM",
    "centreofmass": "CoM",
    "xyz": "translation",
    "origin": "translation",
    "translation": "translation",
    "rpy": "rotation",
    "rotation": "rotation",
}
_BRACES = frozenset("{}")
_NUMBERS = frozenset({"FLOAT", "INT", "SCIENTIFIC"})
_MOMENT = re.compile("[ij](?P<axes>[xyz]{1,2}|[123]{2})")
_AXES = str.maketrans("123", "xyz")


def meant_word(text: str) -> str | None:
    """Return the keyword that a word of another format stands for, None where it is unknown."""
    word = text.replace("_", "").casefold()
    moment = _MOMENT.fullmatch(word)
    if moment is None:
        return _MEANT.get(word)
    return "I" + "".join(sorted(set(moment["axes"].translate(_AXES))))


def in_our_words(
    tokens: Sequence[Token], problems: list[Problem]
) -> tuple[list[Token], list[Token]]:
    """Return tokens with the words before `=` that other formats use replaced; tell of each.

    Two words of a section never become the same: the second one is left out with its number, as
    the `iyx` of a whole matrix, or stays as it is. What is left out comes second.
    """
    found: list[Token] = []
    left_out: list[Token] = []
    taken: set[str] = set()
    index = 0
    while index < len(tokens):
        token = tokens[index]
        if token.kind in _BRACES:
            taken = _keywords_behind(tokens, index) if token.kind == "{" else set()
        word = meant_word(token.text) if _is_called(tokens, index) else None
        if word is not None and word not in taken:
            taken.add(word)
            found.append(Token(word_kind(word), word, token.lead, token.start, token.end))
            problems.append(_unknown(token, word))
        elif word is not None and _is_repeated_number(tokens, index):
            problems.append(_repeated(tokens[index : index + 3], word))
            left_out += tokens[index : index + 3]
            index += 2
        else:
            found.append(token)
        index += 1
    return found, left_out


def _unknown(token: Token, word: str) -> Problem:
    title = f"Replace '{shown(token.text)}' with '{word}'"
    repair = Repair(title, (Edit(token.start, token.end, word),), False)
    message = unknown_keyword(token.text, [word])
    return Problem("KD010", message, token.start, token.end, repair)


def _repeated(tokens: Sequence[Token], word: str) -> Problem:
    written, end = tokens[0], tokens[-1].end
    repair = None
    if written.text[-1:] < written.text[-2:-1]:  # of a matrix's lower triangle
        title = f"Remove '{shown(' '.join(token.text for token in tokens))}'"
        repair = Repair(title, (Edit(written.start, end, ""),), False)
    message = f"'{shown(written.text)}' means '{word}', which is already given"
    if written.text.casefold() == word.casefold():
        message = f"second '{word}', written '{shown(written.text)}'"
    return Problem("KD009", message, written.start, written.end, repair)


def _keywords_behind(tokens: Sequence[Token], index: int) -> set[str]:
    """Return the keywords of the sections between the brace at an index and the next one.

    A parameter may be named like one: `Ix = mass` is not the mass.
    """
    words = set()
    for token, behind in pairwise(tokens[index + 1 :]):
        if token.kind in _BRACES:
            break
        if behind.kind == "=" and token.text in KEYWORDS:
            words.add(token.text)
    return words


def _is_repeated_number(tokens: Sequence[Token], index: int) -> bool:
    """Return whether a number is behind a word and `=`, and nothing else."""
    value, behind = tokens[index + 2 : index + 3], tokens[index + 3 : index + 4]
    is_number = bool(value) and value[0].kind in _NUMBERS
    return is_number and not (behind and behind[0].kind in "*/-")


def _is_called(tokens: Sequence[Token], index: int) -> bool:
    """Return whether a token is a name where a section's keyword stands: before `=`."""
    token = tokens[index]
    behind = tokens[index + 1].kind if index + 1 < len(tokens) else ""
    before = tokens[index - 1].kind if index else ""
    return token.kind == "NAME" and behind == "=" and before != "<"


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
