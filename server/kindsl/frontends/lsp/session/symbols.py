"""Named things of all robots in the workspace; what is known of a text is kept until it changes."""

from collections.abc import AsyncIterator
from typing import TYPE_CHECKING

from kindsl.frontends.lsp.session.progress import Progress
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.text.document import Document
from kindsl.language.text.facts import Fact

if TYPE_CHECKING:
    from kindsl.frontends.features.outline import WorkspaceSymbol

TITLE = "Reading robots"
_SYMBOLS: "Fact[tuple[WorkspaceSymbol, ...]]" = Fact("symbols")


async def all_symbols(
    state: State, robots: list[str], progress: Progress
) -> "AsyncIterator[tuple[Document, tuple[WorkspaceSymbol, ...]]]":
    """Yield each robot and its symbols; of a file that is not open only its names are read."""

    async def read(uri: str) -> Document | None:
        robot = state.documents.get(uri)
        if robot is None or not robot.is_robot:
            return None
        if robot.facts.get(_SYMBOLS) is None:
            robot.facts.keep(_SYMBOLS, await _symbols(state, robot))
        return robot

    async with progress:
        async for robot in progress.over(robots, read):
            if robot is not None:
                yield robot, robot.facts.get(_SYMBOLS) or ()


async def _symbols(state: State, robot: Document) -> "tuple[WorkspaceSymbol, ...]":
    from kindsl.frontends.features.names_in_text import symbols_in_text
    from kindsl.frontends.features.outline import workspace_symbols

    if robot.version is None:
        return tuple(symbols_in_text(robot.text))
    return workspace_symbols(await state.analyses.of(robot), "")
