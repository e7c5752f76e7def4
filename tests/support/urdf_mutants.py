"""URDFs with something wrong: swapped, cut, doubled, lost, and numbers that are none."""

import random
import re
from collections.abc import Callable

_ELEMENT = re.compile(r"<\w+(?:\s[^<>]*)?/>|<(\w+)[^<>]*>.*?</\1>", re.DOTALL)
_VALUE = re.compile(r'"([^"<>]*)"')
_WORDS = ("nan", "inf", "-1e999", "", " ", "1 2", "1 2 3 4 5", "0x10", "1,5", "é", "1e308", "0 0 0")


def mutant(text: str, generator: random.Random) -> str:
    """Return a text with one to three defects."""
    for _ in range(generator.randint(1, 3)):
        text = generator.choice(_MUTATIONS)(text, generator)
    return text


def _strange_value(text: str, generator: random.Random) -> str:
    return _with_value(text, generator, generator.choice(_WORDS))


def _value_of_another(text: str, generator: random.Random) -> str:
    values = _VALUE.findall(text)
    return _with_value(text, generator, generator.choice(values)) if values else text


def _with_value(text: str, generator: random.Random, value: str) -> str:
    found = list(_VALUE.finditer(text))
    if not found:
        return text
    start, end = generator.choice(found).span(1)
    return text[:start] + value + text[end:]


def _without_element(text: str, generator: random.Random) -> str:
    start, end = _span(text, generator)
    return text[:start] + text[end:]


def _element_twice(text: str, generator: random.Random) -> str:
    start, end = _span(text, generator)
    return text[:end] + text[start:end] + text[end:]


def _cut(text: str, generator: random.Random) -> str:
    at = generator.randrange(len(text) + 1)
    return text[:at] + text[at + generator.randrange(1, 40) :]


def _span(text: str, generator: random.Random) -> tuple[int, int]:
    found = [m.span() for m in _ELEMENT.finditer(text, generator.randrange(len(text) + 1))]
    return generator.choice(found[:8]) if found else (0, 0)


_MUTATIONS: tuple[Callable[[str, random.Random], str], ...] = (
    _strange_value,
    _strange_value,
    _value_of_another,
    _value_of_another,
    _without_element,
    _element_twice,
    _cut,
)
