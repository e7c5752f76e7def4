"""The language server: a session with an editor, and who answers what in it."""

from kindsl.lsp.handlers import (
    actions,
    commands,
    comparing,
    completing,
    configuration,
    diagnostics,
    formatting,
    highlighting,
    interchange,
    manipulating,
    navigation,
    presentation,
    renaming,
    structure,
)
from kindsl.lsp.session.session import Session
from kindsl.lsp.session.surroundings import Surroundings, process
from kindsl.lsp.wire.editor import Editor

_HANDLERS = (
    configuration.handlers,
    diagnostics.handlers,
    navigation.handlers,
    structure.handlers,
    highlighting.handlers,
    renaming.handlers,
    formatting.handlers,
    actions.handlers,
    presentation.handlers,
    completing.handlers,
    commands.handlers,
    interchange.handlers,
    comparing.handlers,
    manipulating.handlers,
)


class KindslLanguageServer(Editor):
    """pygls with our handlers.

    Attributes:
        session: What they share.
    """

    def __init__(self, surroundings: Surroundings | None = None) -> None:
        super().__init__()
        self.session = Session(self, surroundings or process())
        for handlers in _HANDLERS:
            handlers.register(self.session)
