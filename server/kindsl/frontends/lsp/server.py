"""The language server: a session with an editor, and who answers what in it."""

from collections.abc import Iterator
from importlib import import_module

from kindsl.frontends.lsp import handlers
from kindsl.frontends.lsp.handlers.table import Handlers
from kindsl.frontends.lsp.session.session import Session
from kindsl.frontends.lsp.session.surroundings import Surroundings, process
from kindsl.frontends.lsp.wire.protocol import Editor
from kindsl.language.text.modules import module_names


class KindslLanguageServer(Editor):
    """pygls with our handlers, which share a session."""

    def __init__(self, surroundings: Surroundings | None = None) -> None:
        super().__init__()
        self.session = Session(self, surroundings or process())
        for found in _all_handlers():
            found.register(self.session)


def _all_handlers() -> Iterator[Handlers]:
    for name in module_names(handlers):
        module = import_module(f"kindsl.frontends.lsp.handlers.{name}")
        if isinstance(found := getattr(module, "handlers", None), Handlers):
            yield found
