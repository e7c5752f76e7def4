"""Handlers by protocol method: a table a module, registered capability by capability.

A handler of a document sees one version of it from the beginning to the end, the one that was
there when the request came, however the editor goes on typing meanwhile.
"""

from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar

from kindsl.frontends.lsp.session.companions import transforms_view
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.text.document import Document

F = TypeVar("F", bound=Callable[..., Any])
Bind = Callable[[Session, Callable[..., Any]], Callable[..., Any]]


class _Entry(NamedTuple):
    method: str
    options: Any
    bind: Callable[[Session], Callable[..., Any]]


class Handlers:
    """The handlers of one module."""

    __slots__ = ("_commands", "_entries", "_of_transforms", "_of_xml")

    def __init__(self) -> None:
        self._entries: list[_Entry] = []
        self._commands: list[_Entry] = []
        self._of_transforms: dict[str, Callable[..., Any]] = {}
        self._of_xml: dict[str, Callable[..., Any]] = {}

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

    def session(self, method: str, options: Any = None) -> Callable[[F], F]:
        """Register a handler `(session, params) -> result`, which may be awaitable."""
        return self._add(method, options, _on_session)

    def transforms(self, method: str) -> Callable[[F], F]:
        """Register `(view, params) -> result` besides the method's handler, for transforms."""

        def register(handler: F) -> F:
            self._of_transforms[method] = handler
            return handler

        return register

    def xml(self, method: str) -> Callable[[F], F]:
        """Register `(view, params) -> result` besides the method's handler, for robots in XML."""

        def register(handler: F) -> F:
            self._of_xml[method] = handler
            return handler

        return register

    def command(self, name: str) -> Callable[[F], F]:
        """Register a command `(session, *arguments) -> result`, which may be awaitable."""

        def register(handler: F) -> F:
            self._commands.append(_Entry(name, None, lambda session: _on_session(session, handler)))
            return handler

        return register

    def register(self, session: Session) -> None:
        """Announce everything to the editor."""
        for method, options, bind in self._entries:
            answer = bind(session)
            others = self._of_transforms.get(method), self._of_xml.get(method)
            chosen = _by_kind(session, answer, *others) if any(others) else answer
            session.editor.feature(method, options)(chosen)
        for name, _, bind in self._commands:
            session.editor.command(name)(bind(session))

    def _add(self, method: str, options: Any, bind: Bind) -> Callable[[F], F]:
        def register(handler: F) -> F:
            self._entries.append(_Entry(method, options, lambda session: bind(session, handler)))
            return handler

        return register


def _by_kind(
    session: Session,
    of_robot: Callable[..., Any],
    of_transforms: Callable[..., Any] | None,
    of_xml: Callable[..., Any] | None,
) -> Callable[..., Any]:
    async def ask_of_transforms(document: Document, params: Any) -> Any:
        assert of_transforms is not None, "else it is not asked"
        return of_transforms(await transforms_view(session, document), params)

    async def ask_of_xml(document: Document, params: Any) -> Any:
        assert of_xml is not None, "else it is not asked"
        return of_xml(await session.view(document), params)

    def answer(params: Any) -> Any:
        document = session.documents.get(params.text_document.uri)
        if document is not None and document.is_transforms and of_transforms is not None:
            return ask_of_transforms(document, params)
        if document is not None and document.is_xml and of_xml is not None:
            return ask_of_xml(document, params)
        return of_robot(params)

    return answer


def _on_session(session: Session, handler: Callable[..., Any]) -> Callable[..., Any]:
    return lambda *arguments: handler(session, *arguments)


def _on_place(session: Session, handler: Callable[..., Any]) -> Callable[..., Any]:
    return lambda params: session.ask_at_once(handler, params.text_document.uri, params)


def _on_document(session: Session, handler: Callable[..., Any]) -> Callable[..., Any]:
    return lambda params: session.ask(handler, params.text_document.uri, params)


def _on_judged(session: Session, handler: Callable[..., Any]) -> Callable[..., Any]:
    return lambda params: session.ask_judged(handler, params.text_document.uri, params)


def _on_item(session: Session, handler: Callable[..., Any]) -> Callable[..., Any]:
    return lambda params: session.ask(handler, params.item.uri, params)
