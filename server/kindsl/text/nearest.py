"""Which of the known names was probably meant."""

from collections.abc import Iterable

_NO_DIGITS = str.maketrans("", "", "0123456789")


def did_you_mean(name: str, known: Iterable[str]) -> str | None:
    """Return the closest known name, or None if none is close; of equally close ones the first.

    Close means that one slip in four characters explains the difference: a letter left out, put in,
    mistaken, or two exchanged. Case does not count. Names that differ in their numbers only are
    taken to mean different things.
    """
    best, allowed = None, min(1 + len(name) // 4, len(name) // 2) + 1
    folded = name.casefold()
    for candidate in known:
        if abs(len(candidate) - len(name)) < allowed and not _is_numbered_alike(name, candidate):
            distance = _distance(folded, candidate.casefold(), allowed)
            if distance < allowed:
                best, allowed = candidate, distance
    return best


def hint(suggestion: str | None) -> str:
    """Return the end of a message."""
    return f"; did you mean '{suggestion}'?" if suggestion else ""


def _is_numbered_alike(left: str, right: str) -> bool:
    return left.translate(_NO_DIGITS) == right.translate(_NO_DIGITS)


def _distance(left: str, right: str, limit: int) -> int:
    """Return the number of slips between two words, or `limit + 1` if there are more.

    Source: optimal string alignment, Damerau 1964.
    """
    if abs(len(left) - len(right)) > limit:
        return limit + 1
    before: list[int] = []
    row = list(range(len(right) + 1))
    for i, a in enumerate(left, 1):
        before, last, row = row, before, [i]
        for j, b in enumerate(right, 1):
            cost = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (a != b))
            if i > 1 and j > 1 and a == right[j - 2] and b == left[i - 2]:
                cost = min(cost, last[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
    return row[-1]
