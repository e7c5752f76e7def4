"""Which keyword a misspelt word was meant to be."""

from collections.abc import Iterable

_MOST_LETTERS = 40


def nearest(word: str, words: Iterable[str]) -> str | None:
    """Return the word that is a slip or two away, None where none is."""
    near = [(distance(word, other), other) for other in words if is_near(word, other)]
    return min(near)[1] if near else None


def is_near(word: str, other: str) -> bool:
    """Return whether one word may be a slip of the other."""
    if len(word) > 3 and (other.startswith(word) or other.endswith(word)):
        return True
    return word.lower() == other.lower() or distance(word, other) <= _most_slips(other)


def distance(left: str, right: str) -> float:
    """Return the number of slips: letters lost, added, changed or swapped; a wrong case is half."""
    if len(left) > _MOST_LETTERS or abs(len(left) - len(right)) > 3:
        return float(_MOST_LETTERS)
    before: list[float] = []
    row = [float(j) for j in range(len(right) + 1)]
    for i, a in enumerate(left, 1):
        older, before, row = before, row, [float(i)]
        for j, b in enumerate(right, 1):
            change = 0.0 if a == b else 0.5 if a.lower() == b.lower() else 1.0
            best = min(row[-1] + 1, before[j] + 1, before[j - 1] + change)
            if i > 1 and j > 1 and a == right[j - 2] and left[i - 2] == b:
                best = min(best, older[j - 2] + 1)
            row.append(best)
    return row[-1]


def _most_slips(word: str) -> float:
    return 0.5 if len(word) < 3 else 1.5 if len(word) < 6 else 2.5
