"""How a protocol method finds its handler: a table a module, registered capability by capability.

A handler of a document sees one version of it from the beginning to the end, the one that was
there when the request came, however the editor goes on typing meanwhile.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

if TYPE_CHECKING:
    from kindsl.lsp.server import KindslLanguageServer

F = TypeVar("F", bound=Callable[..., Any])


class _Entry(NamedTuple):
    method: str
    options: Any
    bind: "Callable[[KindslLanguageServer], Callable[..., Any]]"


class Handlers:
    """The handlers of one module."""

    __slots__ = ("_commands", "_entries")

    def __init__(self) -> None:
        self._entries: list[_Entry] = []
        self._commands: list[_Entry] = []

    def place(self, method: str, options: Any = None) -> Callable[[F], F]:
        """Register a handler `(view, params) -> result` of a place, answered at once."""
        return self._add(method, options, _on_place)

    def document(self, method: str, options: Any = None) -> Callable[[F], F]:
        """Register a handler `(view, params) -> result` that looks at the whole document."""
        return self._add(method, options, _on_document)

    def judged(self, method: str, options: Any = None) -> Callable[[F], F]:
        """Register a handler `(view, params) -> result` that needs to know what is wrong."""
        return self._add(method, options, _on_judged)

    def item(self, method: str, options: Any = None) -> Callable[[F], F]:
        """Register a handler `(view, params) -> result` of the document of `params.item`."""
        return self._add(method, options, _on_item)

    def server(self, method: str, options: Any = None) -> Callable[[F], F]:
        """Register a handler `(server, params) -> result`, which may be awaitable."""
        return self._add(method, options, _on_server)

    def command(self, name: str) -> Callable[[F], F]:
        """Register a command `(server, *arguments) -> result`, which may be awaitable."""

        def register(handler: F) -> F:
            self._commands.append(_Entry(name, None, lambda server: _on_server(server, handler)))
            return handler

        return register

    def register(self, server: "KindslLanguageServer") -> None:
        """Announce everything to pygls."""
        for method, options, bind in self._entries:
            server.feature(method, options)(bind(server))
        for name, _, bind in self._commands:
            server.command(name)(bind(server))

    def _add(self, method: str, options: Any, bind: "_Bind") -> Callable[[F], F]:
        def register(handler: F) -> F:
            self._entries.append(_Entry(method, options, lambda server: bind(server, handler)))
            return handler

        return register


def _on_server(server: "KindslLanguageServer", handler: Callable[..., Any]) -> Callable[..., Any]:
    return lambda *arguments: handler(server, *arguments)


def _on_place(server: "KindslLanguageServer", handler: Callable[..., Any]) -> Callable[..., Any]:
    return lambda params: server.ask_at_once(handler, params.text_document.uri, params)


def _on_document(server: "KindslLanguageServer", handler: Callable[..., Any]) -> Callable[..., Any]:
    return lambda params: server.ask(handler, params.text_document.uri, params)


def _on_judged(server: "KindslLanguageServer", handler: Callable[..., Any]) -> Callable[..., Any]:
    return lambda params: server.ask_judged(handler, params.text_document.uri, params)


def _on_item(server: "KindslLanguageServer", handler: Callable[..., Any]) -> Callable[..., Any]:
    return lambda params: server.ask(handler, params.item.uri, params)


_Bind = Callable[["KindslLanguageServer", Callable[..., Any]], Callable[..., Any]]
