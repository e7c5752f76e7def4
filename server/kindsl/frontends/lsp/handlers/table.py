"""Handlers by protocol method: a table a module, registered capability by capability.

A handler of a document sees one version of it from the beginning to the end, the one that was
there when the request came, however the editor goes on typing meanwhile.
"""

from collections.abc import Awaitable, Callable
from typing import Any, TypeAlias, TypeVar

from kindsl.frontends.lsp.session.companions import transforms_view
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.view import Sight

F = TypeVar("F", bound=Callable[..., Any])
_Handler: TypeAlias = Callable[..., Any]
_Ask: TypeAlias = Callable[[Session, _Handler, str, Any], Awaitable[Any]]


class Handlers:
    """The handlers of one module."""

    def __init__(self) -> None:
        self._methods: dict[str, tuple[_Handler, Any, _Ask | None]] = {}
        self._commands: dict[str, _Handler] = {}
        self._of_transforms: dict[str, _Handler] = {}
        self._of_xml: dict[str, _Handler] = {}

    def place(self, method: str, options: Any = None) -> Callable[[F], F]:
        """Register a handler `(view, params) -> result` of a place, answered at once."""
        return self._add(method, options, Session.ask_at_once)

    def document(self, method: str, options: Any = None) -> Callable[[F], F]:
        """Register a handler `(view, params) -> result` that looks at the whole document."""
        return self._add(method, options, Session.ask)

    def judged(self, method: str, options: Any = None) -> Callable[[F], F]:
        """Register a handler `(view, params) -> result` that needs to know what is wrong."""
        return self._add(method, options, Session.ask_judged)

    def session(self, method: str, options: Any = None) -> Callable[[F], F]:
        """Register a handler `(session, params) -> result`, which may be awaitable."""
        return self._add(method, options, None)

    def transforms(self, method: str) -> Callable[[F], F]:
        """Register `(view, params) -> result` besides the method's handler, for transforms."""
        return _kept_in(self._of_transforms, method)

    def xml(self, method: str) -> Callable[[F], F]:
        """Register `(view, params) -> result` besides the method's handler, for robots in XML."""
        return _kept_in(self._of_xml, method)

    def command(self, name: str) -> Callable[[F], F]:
        """Register a command `(session, *arguments) -> result`, which may be awaitable."""
        return _kept_in(self._commands, name)

    def register(self, session: Session) -> None:
        """Announce everything to the editor."""
        for method, (handler, options, ask) in self._methods.items():
            answer = _bound(session, handler, ask)
            others = self._of_transforms.get(method), self._of_xml.get(method)
            chosen = _by_kind(session, answer, *others) if any(others) else answer
            session.editor.feature(method, options)(chosen)
        for name, handler in self._commands.items():
            session.editor.command(name)(_bound(session, handler))

    def _add(self, method: str, options: Any, ask: _Ask | None) -> Callable[[F], F]:
        def keep(handler: F) -> F:
            self._methods[method] = handler, options, ask
            return handler

        return keep


def _kept_in(table: dict[str, _Handler], name: str) -> Callable[[F], F]:
    def keep(handler: F) -> F:
        table[name] = handler
        return handler

    return keep


def _bound(session: Session, handler: _Handler, ask: _Ask | None = None) -> _Handler:
    if ask is None:
        return lambda *arguments: handler(session, *arguments)
    return lambda params: ask(session, handler, _uri(params), params)


def _uri(params: Any) -> str:
    return str((params.item if hasattr(params, "item") else params.text_document).uri)


def _by_kind(
    session: Session, of_robot: _Handler, of_transforms: _Handler | None, of_xml: _Handler | None
) -> _Handler:
    async def asked(handler: _Handler, view: Awaitable[Sight], params: Any) -> Any:
        return handler(await view, params)

    def answer(params: Any) -> Any:
        document = session.documents.get(_uri(params))
        if document is not None and document.is_transforms and of_transforms is not None:
            return asked(of_transforms, transforms_view(session, document), params)
        if document is not None and document.is_xml and of_xml is not None:
            return asked(of_xml, session.view(document), params)
        return of_robot(params)

    return answer
