"""Numbers of a document in characters that look alike, each of the same meaning."""

import random
import re
import unicodedata

from kindsl.language.syntax.scanner import comments

MINUSES = "−‐‑‒–—―﹘﹣－➖⁃"
POINTS = "·．٫‧∙⋅•。"
UNSEEN = "\u200b\u200e\u2060\ufeff"
_NUMBER = re.compile(r"(?<![\w.])-?[0-9]+\.[0-9]+(?![\w.])")


def digit_sets() -> list[str]:
    """Return the ten digits of each script, those of mathematics included."""
    # Behind the second plane there are ideographs and what has no meaning.
    zeros = (chr(n) for n in range(128, 0x20000) if unicodedata.decimal(chr(n), None) == 0)
    return ["".join(chr(ord(zero) + n) for n in range(10)) for zero in zeros]


def number_spans(text: str) -> list[tuple[int, int]]:
    """Return where numbers with a point stand, but for those in comments."""
    spans = comments(text)
    return [
        match.span()
        for match in _NUMBER.finditer(text)
        if not any(start <= match.start() < end for start, end in spans)
    ]


def alike(number: str, generator: random.Random) -> str:
    """Return a number in other characters than ASCII's, of the same meaning."""
    new = number
    while new == number:
        if generator.random() < 0.3:
            new = new.translate(dict(zip(b"0123456789", generator.choice(DIGITS), strict=True)))
        if generator.random() < 0.5:
            new = new.replace("-", generator.choice(MINUSES) + generator.choice(("", "", " ")))
        if generator.random() < 0.3:
            new = new.replace(".", generator.choice(POINTS))
        if generator.random() < 0.2:
            new = f"{generator.choice(UNSEEN)}{new}"
        if new == number and generator.random() < 0.3:
            new = _with_power(number, generator)
    return new


def _with_power(number: str, generator: random.Random) -> str:
    whole, _, decimals = number.partition(".")
    power = -generator.randrange(1, len(decimals) + 1)
    mantissa = f"{whole}{decimals[:-power]}.{decimals[-power:] or '0'}"
    raised = str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    forms = (f"×10{raised}", f"·10^{power}", f" x 10{power}", f" × 10{raised}", f"*10^{power}")
    return mantissa + generator.choice(forms)


DIGITS = digit_sets()
