"""The budget of one page: enough for any hand, too little to keep a server busy."""

from collections.abc import Callable
from time import monotonic

# A drag sends some 60 messages a second; a restarted server is told all values of a page at once.
BURST = 600.0
PER_SECOND = 200.0
_CHARACTERS = 1000  # of a message that cost as much as the message itself


class Budget:
    """Messages that a page may still send: they come back with time."""

    def __init__(self, clock: Callable[[], float] = monotonic) -> None:
        """Begin with a full budget; `clock` tells seconds."""
        self._clock = clock
        self._left = BURST
        self._last = clock()

    def spend(self, message: str | bytes) -> bool:
        """Take the price of a message; return whether there was enough left."""
        now = self._clock()
        self._left = min(BURST, self._left + PER_SECOND * (now - self._last))
        self._last = now
        self._left -= 1.0 + len(message) / _CHARACTERS
        return self._left >= 0.0
