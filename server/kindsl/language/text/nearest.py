"""The known words that a misspelt one probably means.

A slip is a letter left out, put in, mistaken, or two exchanged; a wrong case is half a slip. Words
that all know, keywords and options, may also be abbreviated. Names that people invent may not, and
those that differ in their numbers only mean different things.
"""

from collections.abc import Iterable, Sequence
from math import inf

_MOST_LETTERS = 40
_NO_DIGITS = str.maketrans("", "", "0123456789")


def nearest_word(word: str, vocabulary: Iterable[str]) -> str | None:
    """Return the nearest word of a fixed vocabulary, None where none is near.

    Of equally near words it is the first of the alphabet.
    """
    return next(iter(nearest_words(word, vocabulary)), None)


def is_near(word: str, other: str) -> bool:
    """Return whether a word may be a slip, or an abbreviation, of a word of a vocabulary."""
    return _remoteness(word, other) < inf


def nearest_words(word: str, vocabulary: Iterable[str]) -> tuple[str, ...]:
    """Return all words of a fixed vocabulary that are near and nearest, in the alphabet's order."""
    found = sorted((_remoteness(word, other), other) for other in vocabulary)
    return tuple(other for near, other in found if near == found[0][0] < inf)


def nearest_name(name: str, known: Iterable[str]) -> str | None:
    """Return the nearest of the names that somebody gave, None where none is near.

    Of equally near names it is the first.
    """
    return next(iter(nearest_names(name, known)), None)


def nearest_names(name: str, known: Iterable[str]) -> tuple[str, ...]:
    """Return all names that are near and nearest, in the order in which they are known."""
    best: dict[str, None] = {}
    least = inf
    for other in known:
        remoteness = _slips_of(name, other, least)
        if remoteness > least or remoteness == inf or _is_numbered_alike(name, other):
            continue
        if remoteness < least:
            best, least = {}, remoteness
        best[other] = None
    return tuple(best)


def hint(meant: str | Sequence[str] | None, after: str = ";") -> str:
    """Return the end of a message, empty where nothing is meant."""
    words = [meant] if isinstance(meant, str) else meant or ()
    quoted = " or ".join(f"'{word}'" for word in words)
    return f"{after} did you mean {quoted}?" if quoted else ""


def slips(left: str, right: str, most: float) -> float:
    """Return how many slips make one word of the other, infinity if more than `most`.

    Source: optimal string alignment, Damerau 1964.
    """
    if len(left) > _MOST_LETTERS or abs(len(left) - len(right)) > most:
        return inf
    reach, width = int(most), len(right) + 1
    lower_left, lower_right = list(map(str.lower, left)), list(map(str.lower, right))
    before: list[float] = []
    row = [float(j) for j in range(width)]
    for i, a in enumerate(left, 1):
        older, before, row = before, row, [inf] * width
        row[0] = float(i)
        # Further from the diagonal more letters are lost than `most`.
        for j in range(max(1, i - reach), min(width, i + reach + 1)):
            b = right[j - 1]
            change = 0.0 if a == b else 0.5 if lower_left[i - 1] == lower_right[j - 1] else 1.0
            best = min(row[j - 1] + 1, before[j] + 1, before[j - 1] + change)
            if i > 1 and j > 1 and a == right[j - 2] and left[i - 2] == b:
                best = min(best, older[j - 2] + 1)
            row[j] = best
        if min(row) > most:
            return inf
    return row[-1] if row[-1] <= most else inf


def _remoteness(word: str, other: str) -> float:
    """Return how many slips or lost letters lie between near words, infinity for others."""
    if len(word) > 3 and (other.startswith(word) or other.endswith(word)):
        return float(len(other) - len(word))
    return _slips_of(word, other, inf)


def _slips_of(word: str, other: str, most: float) -> float:
    """Return the slips between words if so few are likely, infinity for others."""
    if word.lower() == other.lower():
        return 0.5 if word != other else 0.0
    likely = 0.5 if len(other) < 3 else 1.5 if len(other) < 6 else 2.5
    return slips(word, other, min(most, likely))


def _is_numbered_alike(left: str, right: str) -> bool:
    return left.translate(_NO_DIGITS) == right.translate(_NO_DIGITS)
