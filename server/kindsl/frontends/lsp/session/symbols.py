"""Named things of all robots in the workspace: an index that begins when the session does."""

import asyncio
from collections.abc import AsyncIterator
from typing import TYPE_CHECKING, NamedTuple

from kindsl.frontends.lsp.session.progress import Progress
from kindsl.frontends.lsp.session.state import State
from kindsl.frontends.lsp.text.document import Document, document
from kindsl.language.text.facts import Fact

if TYPE_CHECKING:
    from kindsl.judgement.analysis.analysis import Analysis

TITLE = "Reading robots"
# Robots are read before anyone asks where that takes long, seconds after the session has begun.
_MANY = 50
LATER = 2.0


class RobotSymbol(NamedTuple):
    """A named thing of a robot.

    Attributes:
        name: Its name.
        kind: `robot`, `base`, `link`, `joint` or `frame`.
        container: The robot's name.
        range: In the protocol's form.
    """

    name: str
    kind: str
    container: str
    range: dict[str, dict[str, int]]


Symbols = tuple[RobotSymbol, ...]
_SYMBOLS = Fact[Symbols]("symbols")


async def read_ahead(state: State) -> None:
    """Read a large workspace before anyone asks for a symbol."""
    await asyncio.sleep(LATER)
    await state.until_quiet()
    robots = await state.open_and_closed()
    if len(robots) > _MANY:
        async for _ in all_symbols(state, robots, Progress(state, TITLE, None)):
            pass


async def all_symbols(
    state: State, robots: list[str], progress: Progress
) -> AsyncIterator[tuple[str, Symbols]]:
    """Yield each robot's URI and symbols; what is known of a text is kept until that changes."""
    async with progress:
        async for found in progress.over(robots, lambda uri: _symbols(state, uri)):
            yield found


async def _symbols(state: State, uri: str) -> tuple[str, Symbols]:
    robot = state.documents.get(uri)
    if robot is None or not robot.is_robot:
        return uri, ()
    known = robot.facts.get(_SYMBOLS)
    if known is None:
        if robot.version is None:
            known = await state.helper.run(_symbols_of_text, robot.text, robot.encoding)
        else:
            known = _symbols_in(robot, await state.analyses.of(robot))
        robot.facts.keep(_SYMBOLS, known)
    return uri, known


def _symbols_of_text(text: str, encoding: str) -> Symbols:
    from kindsl.judgement.analysis.analysis import Analysis

    robot = document("", None, text, encoding)
    return _symbols_in(robot, Analysis(robot.tree))


def _symbols_in(robot: Document, analysis: "Analysis") -> Symbols:
    from kindsl.frontends.features.outline import workspace_symbols

    return tuple(
        RobotSymbol(s.name, s.kind, s.container, robot.wire_range(s.start, s.end))
        for s in workspace_symbols(analysis, "")
    )
