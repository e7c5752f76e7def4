"""The meaning of a number that is not written as the language wants it."""

import re

from kindsl.language.text.decimals import plain_decimal

_LONGEST_HEXADECIMAL = 15
_HEXADECIMAL = re.compile(r"[-+]?0[xX](?:_?[0-9a-fA-F])+")
_DIGITS = re.compile(r"[^0-9]+")
_GROUPED = re.compile(
    r"(?P<whole>[-+]?[0-9]{1,3}(?P<mark>[\s'٬,.])[0-9]{3}(?:(?P=mark)[0-9]{3})*)"
    r"(?:(?!(?P=mark))[.,](?P<decimals>[0-9]+))?"
)
_GROUPED_DECIMALS = re.compile(r"[-+]?[0-9]*\.[0-9]{3}(?:\s[0-9]{1,3})+")
_PLAIN = re.compile(r"[-+]?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?P<power>[eE][-+]?[0-9]{1,2})?")


def is_grouped(text: str) -> bool:
    """Return whether a number is written in groups of three digits, and is nothing else."""
    return len(meant_numbers(text)) == 1 and _grouped(text) is not None


def meant_numbers(text: str) -> tuple[str, ...]:
    """Return the numbers that a malformed one may be meant to be, none where nobody knows."""
    if _HEXADECIMAL.fullmatch(text):
        is_short = len(text) <= _LONGEST_HEXADECIMAL
        return (f"{float(int(text, 16)):.1f}",) if is_short else ()
    text = _without_unseen(text).replace("_", "")
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


def _without_unseen(text: str) -> str:
    """Return a number without the characters between its digits that cannot be seen."""
    if text.isascii():
        return text
    from kindsl.language.syntax.lookalikes import is_unseen

    kept = [c for at, c in enumerate(text) if not at or not is_unseen(c)]
    return "".join(kept)


def _with_point(number: str) -> str:
    whole, _, decimals = number.partition(".")
    return f"{whole}.{decimals or '0'}"
