"""Random robots with a few random mistakes: words, numbers, signs, brackets, remarks."""

import random
import re
from pathlib import Path

from tests.support import robots
from tests.support.models import LAYOUTS, Style, random_model
from tests.support.walkers import walker

from kindsl.language.syntax.scanner import scan

_EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.kindsl"))
_MOST = 4000
_SIGNS = ("\xa0", "\ufeff", "\u200b", "#", "@", ";", "\u2212", "\x0c", "\u201c", "\u03c0", "`")
# Numbers as they come from other tools, drawings and hands; `{}` is the number that was there.
_NUMBERS = (
    "\u2212{}", "{}e3", "({})", "{}*PI", "2*{}", "x/2", "1.57080", "3.14159", "1.5707", "PI/2",
    "pi", "- {}", "{}0\xb0", "{} mm", "0x1f", "1.0 - {}", "PI*{}", "2.0 PI", "-PI / 2.0", "{}\xa0",
    "\uff17.5", "{}// c\n", "/*c*/{}", "x[1.0]", "<k=2.0>", "<k>", "1.0.0", "1,5", "1\xb75",
)  # fmt: skip
_REMARKS = ("// note {} \n", "/* remark {} */", "# word {} is here now\n", "/* open {} \n")


def spoilt_robot(generator: random.Random) -> str:
    """Return a robot of any make with up to four mistakes."""
    text = _robot(generator)
    if len(text) > _MOST and generator.random() < 0.8:
        text = robots.ARM
    for _ in range(generator.randint(0, 4)):
        text = generator.choice(_MISTAKES)(text, generator)
    return text


def _robot(generator: random.Random) -> str:
    kind = generator.randrange(8)
    if kind < 3:
        tree = generator.choice(("chain", "tree", "star"))
        style = Style(tree=tree, layout=generator.choice(LAYOUTS))
        return random_model(generator.randint(1, 6), generator.randrange(10**6), style)
    if kind < 4:
        return walker(generator)
    if kind < 6:
        return generator.choice((robots.ARM, robots.LIFT, robots.STUB, robots.ONE_LINK))
    return generator.choice(_EXAMPLES).read_text(encoding="utf-8")


def _span(text: str, generator: random.Random, count: int = 1) -> tuple[int, int, int]:
    """Return start, first end and last end of some neighbouring tokens; zeros where none are."""
    tokens = scan(text)
    if len(tokens) <= count:
        return 0, 0, 0
    first = generator.randrange(len(tokens) - count)
    return tokens[first].start, tokens[first].end, tokens[first + count - 1].end


def _other_word(text: str, generator: random.Random) -> str:
    start, end, _ = _span(text, generator)
    words = [token.text for token in scan(text)] or [""]
    return text[:start] + generator.choice(words) + text[end:]


def _other_number(text: str, generator: random.Random) -> str:
    tokens = [token for token in scan(text) if token.kind in ("FLOAT", "INT")]
    if not tokens:
        return text
    token = generator.choice(tokens)
    number = token.text
    forms = (*(form.format(number) for form in _NUMBERS), number.split(".")[0] or "0")
    new = generator.choice((*forms, number.replace(".", ",")))
    return text[: token.start] + new + text[token.end :]


def _lost(text: str, generator: random.Random) -> str:
    start, _, end = _span(text, generator, generator.randint(1, 4))
    return text[:start] + text[end:]


def _doubled(text: str, generator: random.Random) -> str:
    start, _, end = _span(text, generator, generator.randint(1, 12))
    return f"{text[:end]} {text[start:end]}{text[end:]}"


def _swapped(text: str, generator: random.Random) -> str:
    start, middle, end = _span(text, generator, generator.randint(2, 4))
    return f"{text[:start]}{text[middle:end]} {text[start:middle]}{text[end:]}"


def _sign(text: str, generator: random.Random) -> str:
    start, _, _ = _span(text, generator)
    return text[:start] + generator.choice(_SIGNS) + text[start:]


def _other_bracket(text: str, generator: random.Random) -> str:
    start, end, _ = _span(text, generator)
    return text[:start] + generator.choice("{}()[]") + text[end:]


def _remark(text: str, generator: random.Random) -> str:
    start, _, _ = _span(text, generator)
    words = generator.choice(_REMARKS).format(generator.randrange(10**6))
    return text[:start] + words + text[start:]


def _other_ids(text: str, generator: random.Random) -> str:
    def other(match: re.Match[str]) -> str:
        return match[0] if generator.random() < 0.6 else f"id = {generator.randint(0, 6)}"

    return re.sub(r"\bid *= *\d+", other, text)


def _other_name(text: str, generator: random.Random) -> str:
    """Return the text with one of its references, or declarations, misspelt."""
    names = list(re.finditer(r"\b(?:via|link|r_joint|p_joint|ref_frame *=) +(\w+)", text))
    if not names:
        return text
    start, end = generator.choice(names).span(1)
    return text[:start] + text[start:end] + generator.choice("xyz1") + text[end:]


_MISTAKES = (
    _other_word, _other_number, _other_number, _lost, _doubled, _swapped, _sign, _other_bracket,
    _remark, _other_ids, _other_name,
)  # fmt: skip
