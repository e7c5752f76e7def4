"""Names of tokens and blocks in messages, and the words they stand for."""

from collections.abc import Sequence

from kindsl.language.syntax.tables import HOLDS, KEYWORDS
from kindsl.language.syntax.tree import Token
from kindsl.language.syntax.vocabulary import token_kind

BLOCK_STARTS = {token_kind(start): start for start in HOLDS["document"]}
BLOCK_KINDS = {start: kind for kind, start in BLOCK_STARTS.items()}

SPELLINGS: dict[str, tuple[str, ...]] = {}
for _word, _kind in KEYWORDS.items():
    SPELLINGS[_kind] = (*SPELLINGS.get(_kind, ()), _word)

_NAMES = {
    "NAME": "a name",
    "FLOAT": "a number",
    "INT": "a whole number",
    "JOINT_KIND": "'r_joint' or 'p_joint'",
    "INERTIA": "'inertia_params'",
    "MOMENT": "'Ix'",
}
_TEXTS = {"JOINT_KIND": "r_joint", "INERTIA": "inertia_params", "NAME": "", "FLOAT": "", "INT": ""}
_TITLED = frozenset({"link", "Robot", "RobotBase", "JOINT_KIND"})


def called(kind: str) -> str:
    """Return how a message names a kind of token."""
    return _NAMES.get(kind) or f"'{kind}'"


def spelled(kind: str) -> str:
    """Return the text that stands for a kind, empty where it may be anything."""
    text = _TEXTS.get(kind)
    return text if text is not None else SPELLINGS.get(kind, (kind,))[0]


def supplied(kind: str, position: int, text: str | None = None) -> Token:
    """Return a token that is missing in the text, placed at a position."""
    return Token(kind, spelled(kind) if text is None else text, position, position, position)


def shown(text: str) -> str:
    """Return text as a message quotes it: short, on one line."""
    line = " ".join(text.split())
    line = "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in line)
    return line if len(line) <= 40 else line[:37] + "..."


def last_written(tokens: Sequence[Token]) -> str:
    """Return the text of the last token that was not supplied, as a message quotes it."""
    written = (token.text for token in reversed(tokens) if token.start < token.end)
    return shown(next(written, ""))


def opened_block(read: Sequence[Token]) -> str:
    """Return the innermost block that is open, as a message names it."""
    opened: list[int] = []
    for index, token in enumerate(read):
        if token.kind == "{":
            opened.append(index)
        elif token.kind == "}" and opened:
            opened.pop()
    return _titled(read, opened[-1]) if opened else "the block"


def first_row(text: str, tokens: Sequence[Token]) -> str:
    """Return the text on the line of the first token, up to the next brace."""
    last = tokens[0]
    for token in tokens[1:]:
        if token.kind in ("{", "}") or last.kind in ("{", "}") or _is_apart(text, last, token):
            break
        last = token
    return text[tokens[0].start : last.end]


def unknown_keyword(written: str, meant: Sequence[str]) -> str:
    """Return the message about a word that is near to keywords."""
    near = " or ".join(f"'{word}'" for word in meant)
    return f"unknown keyword '{shown(written)}', did you mean {near}"


def _is_apart(text: str, last: Token, token: Token) -> bool:
    between = text[last.end : token.start]
    return "\n" in between or "\r" in between


def _titled(read: Sequence[Token], brace: int) -> str:
    before = list(read[max(brace - 3, 0) : brace])
    if before and before[-1].kind == "FLOATING":
        before.pop()
    if not before:
        return "the block"
    if len(before) > 1 and before[-2].kind in _TITLED:
        title = {"JOINT_KIND": "joint", "RobotBase": "base", "Robot": "robot"}
        return f"{title.get(before[-2].kind, before[-2].kind)} '{before[-1].text}'"
    if before[-1].text in KEYWORDS:
        return f"'{before[-1].text}'"
    return f"frame '{before[-1].text}'" if before[-1].kind == "NAME" else "'frames'"
