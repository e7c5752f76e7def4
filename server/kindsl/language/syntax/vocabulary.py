"""The constructs and words of the grammar by their purpose: "the moments" are looked up here.

`KINDS` tells of each construct what it is: a `vector`, a `scalar`, one of the `moments`, a `whole`
number, a `name`, a `pose` (a block of vectors), another `block` whose sections have an order, a
`list` in braces, some `groups` of them, one such `group`, or a `row` of words.
"""

from collections.abc import Iterable

from kindsl.language.syntax.tables import CLASSES, HOLDS, KEYWORDS, KINDS, NEITHER, ORDERS, WORDS


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
    """Return the kinds of the tokens that constructs begin with, but for those that begin bare."""
    return frozenset(token_kind(name) for name in constructs if WORDS[name])


BLOCK_WORDS = tuple(word for word in words_of(*HOLDS["document"]) if word in KEYWORDS)
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
