"""One change of a document's text, as slips, editors and bad copies make them."""

import random
import re
from collections.abc import Callable

from tests.differential.documents import KEYWORDS, NAMES, VALUES

_WORD = re.compile(r"\w+|[^\w\s]")
_BLANKS = " \t\n\r", "\xa0", "\x0c", "\x0b", "\u2028", "\u3000", "\ufeff", "\u200b", "\x00", "\x85"
_COMMENTS = (
    "// c\n", "//\n", "///\n", "// c\r", "// c\r\n", "// ü\n", "// /*\n", "/* c */", "/**/",
    "/***/", "/* a /* b */", "/* a */ b */", "/*", "*/", "#c\n", "-- c\n", "// \u2028 x\n",
    "//\x85x\n",
)  # fmt: skip
_TAILS = (
    "x",
    "}",
    "{",
    ";",
    "// end",
    "/* end */",
    "/* end",
    "Robot R { }",
    "\x1a",
    "1.0",
    " \t\n",
)
_CHARACTERS = "{}()=,[]<>*/+-.^_|;:'\"#$@!?&~%\\0123456789eEiIlpPx \t\n\r\xa0äπ٣"


def mutated(text: str, generator: random.Random) -> str:
    """Return the text with one change."""
    return generator.choice(_MUTATIONS)(text, generator)


def _tokens(text: str) -> list[tuple[int, int]]:
    return [match.span() for match in _WORD.finditer(text)] or [(0, 0)]


def _delete(text: str, generator: random.Random) -> str:
    tokens = _tokens(text)
    first = generator.randrange(len(tokens))
    last = min(first + generator.choice((0, 0, 1, 2, 3)), len(tokens) - 1)
    return text[: tokens[first][0]] + text[tokens[last][1] :]


def _double(text: str, generator: random.Random) -> str:
    start, end = generator.choice(_tokens(text))
    return text[:end] + generator.choice(("", " ")) + text[start:end] + text[end:]


def _swap(text: str, generator: random.Random) -> str:
    tokens = _tokens(text)
    if len(tokens) < 2:
        return text
    at = generator.randrange(len(tokens) - 1)
    (a, b), (c, d) = tokens[at], tokens[at + 1]
    return text[:a] + text[c:d] + text[b:c] + text[a:b] + text[d:]


def _replace(text: str, generator: random.Random) -> str:
    start, end = generator.choice(_tokens(text))
    other, stop = generator.choice(_tokens(text))
    new = generator.choice((text[other:stop], generator.choice(KEYWORDS), generator.choice(VALUES)))
    return text[:start] + new + text[end:]


def _insert(text: str, generator: random.Random) -> str:
    start, _ = generator.choice(_tokens(text))
    new = generator.choice((generator.choice(KEYWORDS), generator.choice(NAMES)))
    return f"{text[:start]}{new} {text[start:]}"


def _blank(text: str, generator: random.Random) -> str:
    place = generator.randrange(len(text) + 1)
    return text[:place] + generator.choice(_BLANKS) + text[place:]


def _glue(text: str, generator: random.Random) -> str:
    blanks = [match.span() for match in re.finditer(r"\s+", text)]
    if not blanks:
        return text
    start, end = generator.choice(blanks)
    return text[:start] + text[end:]


def _comment(text: str, generator: random.Random) -> str:
    place = generator.choice(_tokens(text))[0]
    return text[:place] + generator.choice(_COMMENTS) + text[place:]


def _character(text: str, generator: random.Random) -> str:
    place = generator.randrange(len(text) + 1)
    new = generator.choice(("", *generator.sample(_CHARACTERS, 2)))
    return text[:place] + new + text[place + generator.randint(0, 1) :]


def _case(text: str, generator: random.Random) -> str:
    start, end = generator.choice(_tokens(text))
    return text[:start] + text[start:end].swapcase() + text[end:]


def _cut(text: str, generator: random.Random) -> str:
    return text[: generator.randrange(len(text) + 1)]


def _append(text: str, generator: random.Random) -> str:
    return text + generator.choice(_TAILS)


def _line_ends(text: str, generator: random.Random) -> str:
    return text.replace("\n", generator.choice(("\r", "\r\n", "\n\n", "")))


def _value(text: str, generator: random.Random) -> str:
    numbers = [m.span() for m in re.finditer(r"[-+]?\d*\.\d+", text)] or [(0, 0)]
    start, end = generator.choice(numbers)
    return text[:start] + generator.choice(VALUES) + text[end:]


def _vector(text: str, generator: random.Random) -> str:
    vectors = [m.span() for m in re.finditer(r"\([^()]*\)", text)] or [(0, 0)]
    start, end = generator.choice(vectors)
    old = text[start:end]
    new = generator.choice(
        (old.replace(",", " "), old.replace(",", ";"), old.replace("(", "[").replace(")", "]"),
         old[:-1] + ", 1.0)", old.replace("(", "((", 1), old.replace(",", ",,", 1), "()")
    )  # fmt: skip
    return text[:start] + new + text[end:]


def _block(text: str, generator: random.Random) -> str:
    """Return the text with a block doubled, lost or elsewhere."""
    blocks = re.split(r"(?m)^(?=RobotBase|link|r_joint|p_joint|\})", text)
    at = generator.randrange(len(blocks))
    moved = blocks[at] if generator.random() < 0.5 else blocks.pop(at)
    if generator.random() < 0.8:
        blocks.insert(generator.randrange(len(blocks) + 1), moved)
    return "".join(blocks)


def _name(text: str, generator: random.Random) -> str:
    names = [m.span() for m in re.finditer(r"\b[a-z]+\d(_\d)?\b", text)] or [(0, 0)]
    start, end = generator.choice(names)
    return text[:start] + generator.choice(NAMES) + text[end:]


_MUTATIONS: tuple[Callable[[str, random.Random], str], ...] = (
    _delete, _double, _swap, _replace, _insert, _blank, _glue, _glue, _comment, _character,
    _character, _case, _cut, _append, _line_ends, _value, _vector, _block, _name,
)  # fmt: skip
