"""Tables of how likely a quantity is."""

from typing import NamedTuple

# Per unit of the quantity, mostly a logarithm, outside of what was seen.
_FALL = 1.0


class LikelihoodTable(NamedTuple):
    """How much likelier a quantity is of what was published than anything in the table's range.

    Attributes:
        low: The first quantity in the table.
        step: The distance to the next one.
        values: Logarithms of the ratio of both densities.
    """

    low: float
    step: float
    values: tuple[float, ...]

    def at(self, quantity: float) -> float:
        """Return the logarithm of the ratio at a quantity, interpolated; outside it falls."""
        last = len(self.values) - 1
        place = (quantity - self.low) / self.step
        inside = min(max(place, 0.0), float(last))
        i = min(int(inside), last - 1)
        share = inside - i
        told = (1.0 - share) * self.values[i] + share * self.values[i + 1]
        return told - _FALL * self.step * abs(place - inside)
