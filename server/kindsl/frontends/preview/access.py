"""Access to the preview's server.

Any web page that the user visits can send requests to a loopback port, and a name server can make
`evil.example` mean 127.0.0.1. So a request must show the token, address the server by a loopback
name (Host), and, if it comes from a page, from one of our own (Origin).
"""

import re
import secrets
from typing import NamedTuple
from urllib.parse import urlsplit

ADDRESS = "127.0.0.1"
_NAMES = (ADDRESS, "localhost")
_HOST = re.compile(r"[A-Za-z0-9.:\[\]-]+")


class Access(NamedTuple):
    """The one who knows the token of the server at a port.

    Attributes:
        token: The secret that each request must show.
        port: Where the server listens.
        outside: Origins under which an editor's tunnel or proxy shows the server, as the editor
            told; none unless it did.
    """

    token: str
    port: int
    outside: frozenset[str] = frozenset()

    def admitting(self, origin: str) -> "Access":
        """Return the access that a page of one more origin has too.

        Raises:
            ValueError: It is no origin `http(s)://host[:port]`.
        """
        parts = urlsplit(origin)
        if parts.scheme not in ("http", "https") or origin != f"{parts.scheme}://{parts.netloc}":
            raise ValueError(f"'{origin}' is not the origin of a page")
        if not parts.hostname or not _HOST.fullmatch(parts.netloc):
            raise ValueError(f"'{origin}' is not the origin of a page")
        return self._replace(outside=self.outside | {origin})

    def sockets(self) -> list[str]:
        """Return the addresses of the websocket, for the page's content security policy."""
        lines = [f"ws://{name}:{self.port}" for name in _NAMES]
        return lines + [f"ws{origin.removeprefix('http')}" for origin in sorted(self.outside)]

    def refusal(self, host: str | None, origin: str | None, token: str | None) -> str | None:
        """Return why a request is refused, None if it is not.

        A browser always tells the origin of a websocket and of a request from another page; what
        tells none is a navigation or no browser at all, and needs the token all the same.
        """
        own = {f"{name}:{self.port}" for name in _NAMES}
        if host not in own | {urlsplit(each).netloc for each in self.outside}:
            return "this server answers to its loopback address only"
        if origin is not None and origin not in {f"http://{each}" for each in own} | self.outside:
            return "requests from other pages are refused"
        if token is None or not secrets.compare_digest(token.encode(), self.token.encode()):
            return "the address lacks the token that the preview was started with"
        return None


def new_token() -> str:
    """Return a token that cannot be guessed."""
    return secrets.token_urlsafe(24)
