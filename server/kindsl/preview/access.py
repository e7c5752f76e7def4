"""Who may talk to the preview's server.

Any web page that the user visits can send requests to a loopback port, and a name server can make
`evil.example` mean 127.0.0.1. So a request must show the token, address the server by a loopback
name (Host), and, if it comes from a page, from one of our own (Origin).
"""

import secrets
from typing import NamedTuple

ADDRESS = "127.0.0.1"
_NAMES = (ADDRESS, "localhost")


class Access(NamedTuple):
    """The one who knows the token of the server at a port."""

    token: str
    port: int

    def refusal(self, host: str | None, origin: str | None, token: str | None) -> str | None:
        """Return why a request is refused, None if it is not.

        A browser always tells the origin of a websocket and of a request from another page; what
        tells none is a navigation or no browser at all, and needs the token all the same.
        """
        if host not in self._hosts():
            return "this server answers to its loopback address only"
        if origin is not None and origin not in self._origins():
            return "requests from other pages are refused"
        if token is None or not secrets.compare_digest(token.encode(), self.token.encode()):
            return "the address lacks the token that the preview was started with"
        return None

    def _hosts(self) -> set[str]:
        return {f"{name}:{self.port}" for name in _NAMES}

    def _origins(self) -> set[str]:
        return {f"http://{host}" for host in self._hosts()}


def new_token() -> str:
    """Return a token that cannot be guessed."""
    return secrets.token_urlsafe(24)
