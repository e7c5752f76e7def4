"""Numbers and words as print sets them: `1.0×10⁻³`, `1 234.5`, `ﬁnger`.

A number that can mean one thing alone is read as that; where that is uncertain it is malformed, so
that it has no value, and its characters are never just left out.
"""

import re
from collections.abc import Callable, Sequence
from unicodedata import normalize

from kindsl.language.syntax.lookalikes import (
    ODD,
    SUPERSCRIPTS,
    as_meant,
    is_ignorable,
    is_unseen,
    word_as_meant,
)
from kindsl.language.syntax.scanner import scan, word_kind
from kindsl.language.syntax.tables import KEYWORDS
from kindsl.language.syntax.tree import Token
from kindsl.language.text.decimals import plain_decimal

_NUMBER = r"[-+]?(?:[0-9]++(?:\.[0-9]*+)?|\.[0-9]++)"
_BLANKS = r"[ \t\xa0\u2009\u202f]*+"
_RAISED = rf"[-+⁻⁺]?[{SUPERSCRIPTS}]{{1,2}}"
_POWER = (
    rf"(?P<raised>{_RAISED})"
    rf"|{_BLANKS}(?:\^|\*\*){_BLANKS}(?P<power>[-+]?[0-9]{{1,2}}|\([-+]?[0-9]{{1,2}}\))"
)
_POWER_OF_TEN = re.compile(
    rf"(?<![\w.^])(?P<comma>[0-9]++,(?=[0-9]++{_BLANKS}[*xX]))?(?:(?P<mantissa>{_NUMBER}){_BLANKS}(?P<times>[*xX]){_BLANKS}|(?P<sign>[-+]?))10"
    rf"(?:{_POWER}|(?P<lowered>[-+]?[0-9]{{1,2}}))(?![\w.])"
)
_BROKEN = re.compile(
    rf"(?:(?<!{ODD}){ODD}++[-+]?)?[-+]?(?<![0-9.])(?=\.*+[0-9])[0-9.]++"
    rf"(?:(?:{ODD}|')++[0-9.]++)*+{ODD}*+"
)
_WORD = re.compile(rf"(?<!\w)[^\W\d]\w*+(?:{ODD}++\w++)*+[\u0300-\u036f]*+")
_ONE_WORD = re.compile(r"\w+")
_DEGREES = "°"
_LONGEST_HEXADECIMAL = 15
_HEXADECIMAL = re.compile(r"[-+]?0[xX](?:_?[0-9a-fA-F])+")
_DIGITS = re.compile(r"[^0-9]+")
_GROUPED = re.compile(
    r"(?P<whole>[-+]?[0-9]{1,3}(?P<mark>[\s'٬,.])[0-9]{3}(?:(?P=mark)[0-9]{3})*)"
    r"(?:(?!(?P=mark))[.,](?P<decimals>[0-9]+))?"
)
_GROUPED_DECIMALS = re.compile(r"[-+]?[0-9]*\.[0-9]{3}(?:\s[0-9]{1,3})+")
_PLAIN = re.compile(r"[-+]?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?P<power>[eE][-+]?[0-9]{1,2})?")


def tokens_as_meant(
    text: str, tokens: list[Token], spans: Sequence[tuple[int, int]]
) -> list[Token]:
    """Return the tokens with each number and word replaced by its meaning, offsets unchanged."""
    plain = as_meant(text, spans)
    if plain != text:
        tokens = scan(plain)
    joined = _joined(tokens, _POWER_OF_TEN, plain, lambda match: _power_of_ten(text, match))
    if plain.isascii() and "'" not in plain:
        return joined
    joined = _joined(joined, _BROKEN, plain, _broken)
    return _joined(joined, _WORD, plain, _word)


def _joined(
    tokens: Sequence[Token],
    pattern: re.Pattern[str],
    plain: str,
    read: Callable[[re.Match[str]], Token | None],
) -> list[Token]:
    starts = {token.start for token in tokens}
    ends = {token.end for token in tokens}
    read_tokens = filter(None, map(read, pattern.finditer(plain)))
    new = {token.start: token for token in read_tokens if token.end in ends}
    if starts.isdisjoint(new):
        return list(tokens)
    found: list[Token] = []
    for token in tokens:
        if not found or token.start >= found[-1].end:
            found.append(new.get(token.start, token))
    return found


def _power_of_ten(text: str, match: re.Match[str]) -> Token | None:
    """Return the number that a power of ten is, a malformed one where it may be something else."""
    if match["comma"]:
        return Token("MALFORMED_NUMBER", text[slice(*match.span())], match.start(), *match.span())
    mantissa = match["mantissa"] or f"{match['sign']}1"
    start, end = match.span()
    if match["lowered"]:
        times = match["times"]
        if not times or text[match.start("times")] == "*":
            return None
        if match["lowered"][0].isdigit():
            return Token("MALFORMED_NUMBER", match[0], start, start, end)
    exponent = match["raised"] or match["power"] or match["lowered"]
    exponent = normalize("NFKC", exponent).replace("−", "-").strip("()")
    return Token("FLOAT", plain_decimal(f"{mantissa}e{exponent}"), start, start, end)


def _broken(match: re.Match[str]) -> Token | None:
    """Return the number that characters without a meaning stand in, before or behind.

    Those that are seen nowhere belong to it where they are beside it.
    """
    start, end = match.span()
    written = match[0]
    while is_ignorable(written[0]):
        written, start = written[1:], start + 1
    while is_ignorable(written[-1]):
        written, end = written[:-1], end - 1
    inner = written.removesuffix(_DEGREES)
    if re.fullmatch(r"[-+]*[0-9.]+", inner):
        number, *others = scan(written)
        is_alone = written != match[0] and not others
        return Token(number.kind, written, match.start(), *match.span()) if is_alone else None
    return Token("MALFORMED_NUMBER", written, start, start, end)


def _word(match: re.Match[str]) -> Token | None:
    word = word_as_meant(match[0])
    compatible = normalize("NFKC", word)
    if compatible in KEYWORDS:
        word = compatible
    if word == match[0] or not _ONE_WORD.fullmatch(word):
        return None
    return Token(word_kind(word), word, match.start(), *match.span())


def is_grouped(text: str) -> bool:
    """Return whether a number is written in groups of three digits, and is nothing else."""
    return len(meant_numbers(text)) == 1 and _grouped(text) is not None


def meant_numbers(text: str) -> tuple[str, ...]:
    """Return the numbers that a malformed one may mean, none where that is unknown."""
    if _HEXADECIMAL.fullmatch(text):
        is_short = len(text) <= _LONGEST_HEXADECIMAL
        return (f"{float(int(text, 16)):.1f}",) if is_short else ()
    seen = [character for at, character in enumerate(text) if not at or not is_unseen(character)]
    text = "".join(seen).replace("_", "")
    grouped = _grouped(text)
    if grouped is not None:
        is_comma = text.count(",") == 1 and "." not in text
        return (_with_point(text.replace(",", ".")), grouped) if is_comma else (grouped,)
    plain = _PLAIN.fullmatch(text)
    if plain is None:
        return ()
    number = text.replace(",", ".")
    return (plain_decimal(number) if plain["power"] else _with_point(number),)


def _grouped(text: str) -> str | None:
    match = _GROUPED.fullmatch(text)
    if match is not None:
        sign = text[0] if text[0] in "+-" else ""
        return f"{sign}{_DIGITS.sub('', match['whole'])}.{match['decimals'] or '0'}"
    return "".join(text.split()) if _GROUPED_DECIMALS.fullmatch(text) else None


def _with_point(number: str) -> str:
    whole, _, decimals = number.partition(".")
    return f"{whole}.{decimals or '0'}"
