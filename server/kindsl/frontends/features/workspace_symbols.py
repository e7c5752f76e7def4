"""Named things of one document that match what someone types into a search box."""

from collections.abc import Iterator
from typing import NamedTuple

from kindsl.frontends.features.document_symbols import flat_symbols
from kindsl.judgement.analysis.analysis import Analysis


class WorkspaceSymbol(NamedTuple):
    """A link, joint, frame or robot; `container` is the robot's name."""

    name: str
    kind: str
    container: str
    start: int
    end: int


def workspace_symbols(analysis: Analysis, query: str) -> tuple[WorkspaceSymbol, ...]:
    """Return what matches: the letters of the query in this order, whatever their case."""
    return tuple(s for s in _all(analysis) if is_match(query, s.name))


def is_match(query: str, name: str) -> bool:
    """Return whether the letters of a query stand in a name in this order."""
    letters = iter(name.casefold())
    return all(letter in letters for letter in query.casefold() if not letter.isspace())


def _all(analysis: Analysis) -> Iterator[WorkspaceSymbol]:
    robot = analysis.model.name
    for declared in analysis.model.declared:
        if declared.robot:
            yield WorkspaceSymbol(robot, "robot", "", *analysis.resolver.span(declared.robot))
    for symbol in flat_symbols(analysis):
        if symbol.name_start < symbol.name_end:
            yield WorkspaceSymbol(
                symbol.name, symbol.kind, robot, symbol.name_start, symbol.name_end
            )
