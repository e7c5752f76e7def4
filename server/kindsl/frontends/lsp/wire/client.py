"""The capabilities of the editor at the other end."""

import logging
from collections.abc import Awaitable
from typing import Any, NamedTuple, TypeVar

from lsprotocol import types
from pygls.capabilities import get_capability
from pygls.exceptions import JsonRpcException

T = TypeVar("T")

logger = logging.getLogger(__name__)


async def asked(request: Awaitable[T]) -> T | None:
    """Await the client's answer; None if it refuses what it said it can do."""
    try:
        return await request
    except JsonRpcException as error:
        logger.info("the client refuses: %s", error)
        return None


class DiagnosticParts(NamedTuple):
    """The parts of a diagnostic that a client can show."""

    links: bool
    related: bool
    tags: bool


class Client:
    """The capabilities that handlers ask for, by name, and `initializationOptions`, as sent."""

    __slots__ = ("capabilities", "options")

    def __init__(self, capabilities: types.ClientCapabilities, options: object) -> None:
        self.capabilities = capabilities
        self.options: dict[str, Any] = options if isinstance(options, dict) else {}

    def can(self, capability: str) -> bool:
        """Return whether a capability, named like `text_document.hover.link_support`, is there."""
        return bool(get_capability(self.capabilities, capability, False))

    def values(self, capability: str) -> tuple[Any, ...]:
        """Return the list that a capability names, empty when it is missing."""
        return tuple(get_capability(self.capabilities, capability, ()) or ())

    @property
    def is_told_to_pull(self) -> bool:
        """True if it can be asked to pull diagnostics again that it has pulled."""
        return self.can("workspace.diagnostics.refresh_support")

    @property
    def is_invited_to_pull(self) -> bool:
        """True if it is told that it may pull diagnostics.

        One that says nothing of it might show what is pushed as well. One that cannot be asked to
        pull again would go on showing what the documents around have changed; but one that takes
        nothing that is pushed would show nothing at all.
        """
        can_only_pull = not self.can("text_document.publish_diagnostics")
        return self.can("text_document.diagnostic") and (self.is_told_to_pull or can_only_pull)

    @property
    def shows_in_diagnostics(self) -> "DiagnosticParts":
        """The parts of a diagnostic that it can show; all, if it does not speak of diagnostics."""
        told = (
            self.capabilities.text_document and self.capabilities.text_document.publish_diagnostics
        )
        if not told:
            return DiagnosticParts(links=True, related=True, tags=True)
        return DiagnosticParts(
            links=bool(told.code_description_support),
            related=bool(told.related_information),
            tags=told.tag_support is not None,
        )

    def announces(self, name: str) -> bool:
        """Return whether it says that it knows something of ours.

        It says so by a true value of that name in its experimental capabilities or in its
        initialization options.
        """
        places = self.capabilities.experimental, self.options
        return any(isinstance(place, dict) and bool(place.get(name)) for place in places)
