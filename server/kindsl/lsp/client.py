"""What the editor at the other end can do."""

from typing import Any

from lsprotocol import types
from pygls.capabilities import get_capability


class Client:
    """The capabilities that handlers ask for, by name.

    Attributes:
        capabilities: All, as sent.
        options: `initializationOptions`, as sent.
    """

    __slots__ = ("capabilities", "options")

    def __init__(self, capabilities: types.ClientCapabilities, options: object) -> None:
        self.capabilities = capabilities
        self.options: dict[str, Any] = options if isinstance(options, dict) else {}

    def can(self, capability: str) -> bool:
        """Whether a capability, named like `text_document.hover.link_support`, is there."""
        return bool(get_capability(self.capabilities, capability, False))  # type: ignore[call-overload]

    def values(self, capability: str) -> tuple[Any, ...]:
        """Return the list that a capability names, empty when it is missing."""
        return tuple(get_capability(self.capabilities, capability, ()) or ())  # type: ignore[call-overload]

    @property
    def wants_status(self) -> bool:
        """Whether it listens to `kindsl/status`."""
        experimental = self.capabilities.experimental
        return any(
            isinstance(place, dict) and bool(place.get(name))
            for place in (experimental, self.options)
            for name in ("kindsl/status", "kindslStatus", "status")
        )
