"""Characters that stand for others: `−` for `-`, `·` for `.` or `*`, digits of any script.

What a character stands for is a property of Unicode, or follows from its name there. A text is read
with each in place of the character that it stands for, so that all offsets stay.
"""

import re
from collections.abc import Iterable, Sequence
from functools import cache
from unicodedata import category, decimal, decomposition, name, normalize

from kindsl.language.syntax.scanner import comments

SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹"
# A character that no token begins with: none of ASCII that can be seen, no blank, letter or digit.
ODD = r"[^ \t\r\n!-~\w]"

_DOT = "·"
_SOFT_HYPHEN = "\xad"
_NAMES = (
    ("-", r"(?:HEAVY |MODIFIER LETTER )?MINUS SIGN|HYPHEN BULLET|.*PROLONGED SOUND MARK"),
    ("+", r"HEAVY PLUS SIGN"),
    ("*", r"(?:HEAVY )?MULTIPLICATION (?:SIGN|X)|ASTERISK OPERATOR|VECTOR OR CROSS PRODUCT"),
    ("/", r"(?:DIVISION|FRACTION|BIG) (?:SLASH|SOLIDUS)|(?:HEAVY )?DIVISION SIGN"),
    (",", r"(?:ARABIC|(?:HALFWIDTH )?IDEOGRAPHIC) COMMA"),
    ('"', r".*DOUBLE.* (?:QUOTATION MARK|PRIME QUOTATION MARK)|DOUBLE PRIME"),
    ("'", r"(?:LEFT |RIGHT )?SINGLE.* QUOTATION MARK|PRIME|MODIFIER LETTER APOSTROPHE"),
    (
        _DOT,
        r".*\bMIDDLE DOT|.*\bFULL STOP|.*\bDECIMAL SEPARATOR|DOT OPERATOR|BULLET(?: OPERATOR)?"
        r"|HYPHENATION POINT|GREEK ANO TELEIA",
    ),
)
_MEANINGS = [(meaning, re.compile(pattern)) for meaning, pattern in _NAMES]
_WORDS = re.compile(r"\w")
STRANGE = re.compile(r"[^\t\n\r -~]")
_BLANKS_BETWEEN_DIGITS = re.compile(r"(?<![0-9.])[0-9.]++(?:[^\S\t\n\r ][0-9.]++)++")
_GROUPS_OF_DIGITS = re.compile(
    r"[0-9]{1,3}(?:\s[0-9]{3})+(?:\.[0-9]*)?|[0-9]*\.[0-9]{3}(?:\s[0-9]{1,3})+"
)
_FACTOR_BEFORE = re.compile(r"[\w.)\]>]+\Z")
_FACTOR_BEHIND = re.compile(r"[-+]?[\w.(<]+")
_POWER_OF_TEN = re.compile(rf"10[ \t]*(?:\^|\*\*|[-+⁻⁺]?[{SUPERSCRIPTS}])")
_NAME_BEFORE = re.compile(r"[\w\u2010-\u2015]+\Z")
_BEFORE_VALUES = tuple("=(,*/+-[<")
_NEAR = 80


def as_meant(text: str, spans: Sequence[tuple[int, int]]) -> str:
    """Return a text of the same length with each lookalike replaced by the character it stands for.

    Args:
        spans: Its comments, which stay as they are.
    """
    if not STRANGE.search(text):
        return text
    for kept in ("", "/*"):
        pieces = []
        done = 0
        for start, end in (*spans, (len(text), len(text))):
            pieces += [_piece(text[done:start], kept), text[start:end]]
            done = end
        plain = "".join(pieces)
        if comments(plain) == tuple(spans):
            return plain
    return text


def is_ignorable(character: str) -> bool:
    """Return whether a character is seen nowhere: joiners, marks of direction and variation.

    A soft hyphen is none: it may be what is left of a minus.
    """
    is_format = category(character) == "Cf" and character != _SOFT_HYPHEN
    return is_format or "\ufe00" <= character <= "\ufe0f"


def is_unseen(character: str) -> bool:
    """Return whether a character between others is invisible in text."""
    return character == _SOFT_HYPHEN or is_ignorable(character)


def word_as_meant(word: str) -> str:
    """Return a word without what cannot be seen in it, its ligatures as letters.

    Dashes in it become `_`.
    """
    letters = "".join(_letters(character) for character in word)
    return normalize("NFC", letters)


def _letters(character: str) -> str:
    if is_unseen(character):
        return ""
    if category(character) == "Pd":
        return "_"
    letters = normalize("NFKC", character)
    return letters if letters.isascii() and "LIGATURE" in name(character, "") else character


@cache
def _stands_for(character: str) -> str:
    """Return the ASCII character, or the middle dot, that a character stands for; else itself."""
    digit = decimal(character, None)
    if digit is not None:
        return str(digit)
    kind = category(character)
    if character.isspace():
        return " "
    if kind == "Pd":
        return "-"
    if kind[0] == "M" or decomposition(character).startswith(("<super>", "<sub>")):
        return character
    normal = normalize("NFKC", character)
    if len(normal) == 1 and "!" <= normal <= "~" and not _WORDS.match(normal):
        return normal
    called = name(character, "")
    meanings = (meaning for meaning, names in _MEANINGS if names.fullmatch(called))
    meaning = next(meanings, character)
    return character if meaning == _DOT and kind not in ("Po", "Sm") else meaning


def _piece(text: str, kept: Iterable[str]) -> str:
    """Return a piece with its lookalikes replaced, except for those that mean `kept`."""

    def replaced(match: re.Match[str]) -> str:
        meaning = _stands_for(match[0])
        if meaning in kept or (meaning == "-" and _is_in_name(text, match.start())):
            return match[0]
        return match[0] if meaning == " " and _is_between_digits(text, match.start()) else meaning

    plain = STRANGE.sub(replaced, text)
    plain = _BLANKS_BETWEEN_DIGITS.sub(_groups_or_blanks, plain)
    return re.sub(_DOT, lambda dot: _dot(plain, dot.start()) or text[dot.start()], plain)


def _is_in_name(text: str, at: int) -> bool:
    """Return whether a dash joins the parts of a name: letters beside it, no value before them."""
    before, after = text[max(at - _NEAR, 0) : at], text[at + 1 : at + 2]
    if not (before[-1:].isalpha() or before[-1:] == "_"):
        return False
    if category(text[at]) == "Lm":
        return True
    if category(text[at]) != "Pd" or not (after.isalpha() or after == "_"):
        return False
    ahead = _NAME_BEFORE.sub("", before).rstrip()
    return ahead[-1:] not in _BEFORE_VALUES or ahead.rstrip("= \t").endswith("ref_frame")


def _is_between_digits(text: str, at: int) -> bool:
    beside = (text[at - 1 : at], text[at + 1 : at + 2])
    return all(c and (c in ".·٫" or decimal(c, None) is not None) for c in beside)


def _groups_or_blanks(match: re.Match[str]) -> str:
    """Return digits with the blanks between them as such, unless they make groups of thousands."""
    if _GROUPS_OF_DIGITS.fullmatch(match[0]):
        return match[0]
    return re.sub(r"\s", " ", match[0])


def _dot(plain: str, at: int) -> str | None:
    """Return the point or sign that a middle dot is between its neighbours, None for neither."""
    before, behind = plain[max(at - _NEAR, 0) : at], plain[at + 1 : at + 1 + _NEAR]
    left = _FACTOR_BEFORE.search(before.rstrip(" \t"))
    right = _FACTOR_BEHIND.match(behind.lstrip(" \t"))
    if left is None or right is None:
        return None
    if before[-1].isdigit() and behind[0].isdigit():
        is_whole = "." not in left[0] + right[0] and left[0][0].isdigit()
        is_whole = is_whole and not _POWER_OF_TEN.match(behind)
        return "." if is_whole else "*"
    is_name = before[-1].isalpha() and behind[0].isalpha()
    return None if is_name else "*"
