"""The constructs and words of the grammar by their purpose: "the moments" are looked up here.

`KINDS` classifies each construct: a `vector`, a `scalar`, one of the `moments`, a `whole`
number, a `name`, a `pose` (a block of vectors), another `block` whose sections have an order, a
`list` in braces, some `groups` of them, one such `group`, or a `row` of words.
"""

from collections.abc import Iterable
from typing import Any, NamedTuple

from kindsl.language.syntax.tables import (
    CLASSES,
    HOLDS,
    KEYWORDS,
    KINDS,
    NEITHER,
    ORDERS,
    VALUES,
    WORDS,
    ValueKind,
)
from kindsl.language.syntax.tree import Node


class Meaning(NamedTuple):
    """The meaning of a value by its place in the grammar.

    Attributes:
        section: The word of its section: `mass`, `CoM`, `Ix`.
        component: 0 to 2 in a vector, None outside of one.
        kind: The class of the parameters that may stand there.
        unit: The unit of the number.
    """

    section: str
    component: int | None
    kind: ValueKind
    unit: str


def meanings(section: Node) -> tuple[Meaning, ...]:
    """Return the meaning of each value in a section of values."""
    word: Any = section.children[0]
    return _MEANINGS[section.kind, word.text]


def meanings_of(section: str, word: str) -> tuple[Meaning, ...]:
    """Return the meaning of each value in a section of values that begins with a word."""
    return _MEANINGS[section, word]


def of_kind(*kinds: str) -> frozenset[str]:
    """Return the constructs of some kinds."""
    return frozenset(name for name, kind in KINDS.items() if kind in kinds)


def words_of(*constructs: str) -> tuple[str, ...]:
    """Return the words that constructs begin with, in the order of the grammar."""
    return tuple(dict.fromkeys(word for name in constructs for word in WORDS[name]))


def token_kind(construct: str) -> str:
    """Return the kind of the token that a construct begins with."""
    word = WORDS[construct][0]
    return KEYWORDS.get(word, word)


def token_kinds(constructs: Iterable[str]) -> frozenset[str]:
    """Return the kinds of the words or signs that constructs begin with."""
    return frozenset(token_kind(name) for name in constructs if WORDS[name])


BLOCK_WORDS = tuple(word for word in words_of(*HOLDS["document"]) if word in KEYWORDS)
# One for each block of a document, so that its order is a text.
LETTERS = {part: chr(ord("a") + index) for index, part in enumerate(HOLDS["document"])}
BLOCKS = tuple(name for name in HOLDS["document"] if name in ORDERS)
BODIES = tuple(name for name in BLOCKS if "inertia" in HOLDS[name])
SECTIONS = {part: KINDS[part] for name in ORDERS if name != "document" for part in HOLDS[name]}
SCALARS = of_kind("scalar", "moments")
VALUE_HOLDERS = SCALARS | {"vector"}
MOMENTS = words_of(*of_kind("moments"))
POSE = tuple(dict.fromkeys(part for name in of_kind("pose") for part in HOLDS[name]))
NAMES = frozenset(CLASSES["_name"])
NUMBERS = frozenset(CLASSES["_number"])
PIS = frozenset(CLASSES["_pi"])
SECTION_TOKENS = token_kinds(SECTIONS)
VALUE_TERMINALS = NUMBERS | PIS
OPERANDS = (NAMES | VALUE_TERMINALS) - NEITHER.keys()
NO_MEANING = Meaning("", None, next(iter(ValueKind)), "")
_MEANINGS = {
    (section, word): tuple(
        Meaning(word, component, *VALUES[section])
        for component in ((0, 1, 2) if KINDS[section] == "vector" else (None,))
    )
    for section in VALUES
    for word in WORDS[section]
}
