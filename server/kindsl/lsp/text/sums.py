"""Running sums of a row of numbers, quick to change where they were changed last."""

from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from itertools import accumulate


class Sums:
    """The sum of all numbers before each place of a row; the last is that of all.

    Numbers that are put for others change all sums behind them by as much. That is remembered, at
    the gap, and made true of a sum only when the gap moves past it: someone who types stays where
    they are.
    """

    __slots__ = ("_gap", "_shift", "_sums")

    def __init__(self, numbers: Iterable[int]) -> None:
        self._sums = [0, *accumulate(numbers)]
        self._gap, self._shift = len(self._sums), 0

    def copy(self) -> "Sums":
        """Return the same sums, to be changed apart from these."""
        copied = Sums(())
        copied._sums, copied._gap, copied._shift = self._sums.copy(), self._gap, self._shift
        return copied

    def __getitem__(self, place: int) -> int:
        """Return the sum of the numbers before a place."""
        return self._sums[place] + (self._shift if place >= self._gap else 0)

    @property
    def total(self) -> int:
        """The sum of all numbers."""
        return self[len(self._sums) - 1]

    def last_up_to(self, value: int) -> int:
        """Return the last place whose sum is at most a value."""
        low, high, value = self._side(value, self._is_behind(value))
        return bisect_right(self._sums, value, low, high) - 1

    def first_from(self, value: int) -> int:
        """Return the first place whose sum is at least a value."""
        low, high, value = self._side(value, self._is_behind(value - 1))
        return bisect_left(self._sums, value, low, high)

    def replace(self, first: int, last: int, numbers: Iterable[int]) -> None:
        """Put numbers for those from `first` to `last`, exclusive."""
        self._move(last + 1)
        new = list(accumulate(numbers, initial=self._sums[first]))
        self._shift += new[-1] - self._sums[last]
        self._sums[first : last + 1] = new
        self._gap = first + len(new)

    def _is_behind(self, value: int) -> bool:
        """Whether a sum behind the gap is at most a value, or there is none before it."""
        return self._gap < len(self._sums) and self._sums[self._gap] + self._shift <= value

    def _side(self, value: int, is_behind: bool) -> tuple[int, int, int]:
        """Return where to look for a value, and as which."""
        if is_behind:
            return self._gap, len(self._sums), value - self._shift
        return 0, self._gap, value

    def _move(self, gap: int) -> None:
        sums, old = self._sums, self._gap
        if self._shift and gap > old:
            sums[old:gap] = [each + self._shift for each in sums[old:gap]]
        elif self._shift and gap < old:
            sums[gap:old] = [each - self._shift for each in sums[gap:old]]
        self._gap = gap
