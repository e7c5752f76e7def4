"""Text to tokens; any text whatever, nothing is ever refused."""

import re
from functools import lru_cache

from kindsl.language.syntax.tables import (
    CLASSES,
    COMMENTS,
    IGNORED,
    KEYWORDS,
    PATTERNS,
    PUNCTUATION,
    TRIVIA,
)
from kindsl.language.syntax.tree import Token

BAD = "BAD"
_MOST_BAD = 2000
_MOST_KNOWN = 4096

COMMENT = re.compile(COMMENTS)
_SIGNS = "+-"
_NAME_KINDS = [kind for kind in CLASSES["_name"] if kind in PATTERNS]
_PLAIN_NAMES = {kind for kind in _NAME_KINDS if not PATTERNS[kind].startswith("\\")}
_ODD_KINDS = [kind for kind in PATTERNS if kind not in IGNORED and kind not in _PLAIN_NAMES]
_TOKEN = re.compile(
    rf"{TRIVIA}(?:"
    rf"((?!{PATTERNS['PIPE_PI']}){PATTERNS['UNICODE_NAME']})"
    rf"|({PATTERNS['FLOAT']}(?![\w.]))"
    rf"|([{re.escape(''.join(sign for sign in PUNCTUATION if sign not in _SIGNS))}])"
    rf"|({PATTERNS['INT']}(?![\w.]))"
    r"|(\Z)"
    rf"|{'|'.join(f'({PATTERNS[kind]})' for kind in _ODD_KINDS)}"
    rf"|([{_SIGNS}])"
    r"|([^\x21-\x7e\w \t\r\n]+|[^ \t\r\n]))"
)
_WORD, _FLOAT, _SIGN, _INT, _END, _ODD = 1, 2, 3, 4, 5, 6
_OPERATOR = _ODD + len(_ODD_KINDS)


def scan(text: str) -> list[Token]:
    """Return the tokens of a text; together with what lies between them they are the text.

    Where there are thousands of characters that belong to no token, the rest is one token.
    """
    tokens: list[Token] = []
    append = tokens.append
    done = bad = 0
    for match in _TOKEN.finditer(text):
        group = match.lastindex or 0
        start, end = match.span(group)
        word = match[group]
        if group == _WORD:
            kind = word_kind(word)
        elif group == _FLOAT:
            kind = "FLOAT"
        elif group in (_SIGN, _OPERATOR):
            kind = word
        elif group == _INT:
            kind = "INT"
        elif group == _END:
            break
        elif group < _OPERATOR:
            kind = _ODD_KINDS[group - _ODD]
        else:
            kind = BAD
            bad += 1
            if bad > _MOST_BAD:
                end = len(text.rstrip(" \t\r\n"))
                append(Token(BAD, text[start:end], done, start, end))
                break
        append(Token(kind, word, done, start, end))
        done = end
    return tokens


@lru_cache(_MOST_KNOWN)
def word_kind(word: str) -> str:
    """Return the terminal that a word belongs to; a name has a kind for its spelling."""
    kind = KEYWORDS.get(word)
    if kind is not None:
        return kind
    kinds = (kind for kind in _NAME_KINDS if re.fullmatch(PATTERNS[kind], word))
    return next(kinds, "UNICODE_NAME")


def comments(text: str) -> tuple[tuple[int, int], ...]:
    """Return the spans of the comments in a text."""
    if "//" not in text and "/*" not in text:
        return ()
    return tuple(match.span() for match in COMMENT.finditer(text))
