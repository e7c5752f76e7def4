"""Running sums of a row of numbers."""

from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from itertools import accumulate


class Sums:
    """The sum of all numbers before each place of a row; the last is that of all."""

    __slots__ = ("_sums",)

    def __init__(self, numbers: Iterable[int]) -> None:
        self._sums = [0, *accumulate(numbers)]

    def copy(self) -> "Sums":
        """Return the same sums, to be changed apart from these."""
        copied = Sums(())
        copied._sums = self._sums.copy()
        return copied

    def __getitem__(self, place: int) -> int:
        """Return the sum of the numbers before a place."""
        return self._sums[place]

    @property
    def total(self) -> int:
        """The sum of all numbers."""
        return self._sums[-1]

    def last_up_to(self, value: int) -> int:
        """Return the last place whose sum is at most a value."""
        return bisect_right(self._sums, value) - 1

    def first_from(self, value: int) -> int:
        """Return the first place whose sum is at least a value."""
        return bisect_left(self._sums, value)

    def replace(self, first: int, last: int, numbers: Iterable[int]) -> None:
        """Put numbers for those from `first` to `last`, exclusive."""
        new = list(accumulate(numbers, initial=self._sums[first]))
        shift = new[-1] - self._sums[last]
        self._sums[first : last + 1] = new
        if shift:
            behind = first + len(new)
            self._sums[behind:] = [each + shift for each in self._sums[behind:]]
