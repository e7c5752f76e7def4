"""How many cases are tried: a part of them in `make test`, all of them in `make thorough`."""

import os
from typing import TypeVar

IS_THOROUGH = os.environ.get("KINDSL_THOROUGH") == "1"
_T = TypeVar("_T")


def usually(usual: _T, thoroughly: _T) -> _T:
    """Return the first, or the second where every case shall be tried."""
    return thoroughly if IS_THOROUGH else usual
