"""What other formats and habits call the sections: `Ixx`, `com`, `rpy`; each is one word of ours.

Asked before any spelling is compared, since `Ixx` is nearer to `Ixy` than to `Ix`, which it means.
"""

from collections.abc import Sequence

from kindsl.syntax.scanner import word_kind
from kindsl.syntax.tree import Edit, Problem, Repair, Token
from kindsl.syntax.words import shown

_MEANT = {
    "id": "id",
    "mass": "mass",
    "com": "CoM",
    "cog": "CoM",
    "centerofmass": "CoM",
    "centreofmass": "CoM",
    "ix": "Ix",
    "iy": "Iy",
    "iz": "Iz",
    "ixx": "Ix",
    "iyy": "Iy",
    "izz": "Iz",
    "ixy": "Ixy",
    "ixz": "Ixz",
    "iyz": "Iyz",
    "iyx": "Ixy",
    "izx": "Ixz",
    "izy": "Iyz",
    "xyz": "translation",
    "origin": "translation",
    "translation": "translation",
    "rpy": "rotation",
    "rotation": "rotation",
}


def meant_word(text: str) -> str | None:
    """Return the keyword that a word of another format stands for, None where it is unknown."""
    return _MEANT.get(text.replace("_", "").casefold())


def in_our_words(tokens: Sequence[Token], problems: list[Problem]) -> list[Token]:
    """Return tokens with the words before `=` that other formats use replaced; tell of each."""
    found: list[Token] = []
    for index, token in enumerate(tokens):
        word = meant_word(token.text) if _is_called(tokens, index) else None
        if word is None:
            found.append(token)
            continue
        found.append(Token(word_kind(word), word, token.lead, token.start, token.end))
        title = f"Replace '{shown(token.text)}' with '{word}'"
        repair = Repair(title, (Edit(token.start, token.end, word),), False)
        message = f"unknown keyword '{shown(token.text)}', did you mean '{word}'"
        problems.append(Problem("KD010", message, token.start, token.end, repair))
    return found


def _is_called(tokens: Sequence[Token], index: int) -> bool:
    """Return whether a token is a name where a section's keyword stands: before `=`."""
    token = tokens[index]
    behind = tokens[index + 1].kind if index + 1 < len(tokens) else ""
    before = tokens[index - 1].kind if index else ""
    return token.kind == "NAME" and behind == "=" and before != "<"
