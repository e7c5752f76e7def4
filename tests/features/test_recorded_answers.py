"""What every feature answers at both ends of every token of a few documents, in full.

The answers are in `recorded/`, a file for each document; how they get there:
`tests/support/recorded.py`.
"""

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

import pytest
from tests.features.samples import ARM, BROKEN, COMMENTED, PARAMETRIC, TANGLED
from tests.support.recorded import Teller, assert_as_recorded

from kindsl.frontends.features.actions.code_actions import code_actions, fix_all_action
from kindsl.frontends.features.code_lenses import code_lenses
from kindsl.frontends.features.completion.completion import completions, narrowed, suggestions
from kindsl.frontends.features.hover.hover import hover
from kindsl.frontends.features.inlay_hints import InlayHintOptions, inlay_hints
from kindsl.frontends.features.navigation import (
    bound_parameter,
    definitions,
    hierarchy_items,
    highlights,
    linked_ranges,
    predecessors,
    references,
    successors,
)
from kindsl.frontends.features.outline import (
    document_symbols,
    is_match,
    kinematic_outline,
    workspace_symbols,
)
from kindsl.frontends.features.ranges import folds, selection_ranges
from kindsl.frontends.features.rename import rename, rename_range
from kindsl.frontends.features.semantic_tokens import semantic_tokens
from kindsl.frontends.features.signature_help import signature_help
from kindsl.judgement.analysis.analysis import Analysis, analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.span import Span

FOLDER = Path(__file__).parent / "recorded"
BOUND = Settings(
    bindings={
        "width": Binding(0.25, 0.1, None, "kindsl.toml"),
        "m": Binding(2.0),
        "tilt": Binding(0.0, -1.0, 1.0),
    }
)
DOCUMENTS = {
    "arm": (ARM, Settings()),
    "gripper": (PARAMETRIC, BOUND),
    "half": (BROKEN, Settings()),
    "commented": (f"\n {COMMENTED} \n", Settings()),
    "tangled": (TANGLED, Settings()),
    "nothing": ("", Settings()),
}
Answers = Callable[[Analysis, Teller, list[int]], Iterator[str]]


def edges_of_tokens(analysis: Analysis) -> list[int]:
    """Return where tokens begin and end, and both ends of the text."""
    found = {0, analysis.syntax.length}
    for island, start in zip(analysis.syntax.islands, analysis.syntax.starts, strict=True):
        for token in island.tokens:
            found |= {start + token.start, start + token.end}
    return sorted(found)


def at_each(name: str, ask: Callable[[Analysis, int], object]) -> tuple[str, Answers]:
    def answers(analysis: Analysis, teller: Teller, offsets: list[int]) -> Iterator[str]:
        yield from teller.grouped(lambda offset: ask(analysis, offset), offsets)

    return name, answers


def of_all(name: str, ask: Callable[[Analysis], object]) -> tuple[str, Answers]:
    def answers(analysis: Analysis, teller: Teller, _: list[int]) -> Iterator[str]:
        yield from teller.told(ask(analysis))

    return name, answers


def neighbours(analysis: Analysis) -> Iterable[object]:
    for name in dict.fromkeys(str(body.name) for body in analysis.model.bodies):
        yield from (name, predecessors(analysis, name), successors(analysis, name))


def hover_place(analysis: Analysis, offset: int) -> Span | None:
    found = hover(analysis, offset)
    return Span(found.start, found.end) if found is not None else None


FEATURES = (
    of_all("symbols", document_symbols),
    of_all("tree", kinematic_outline),
    of_all("neighbours", lambda a: list(neighbours(a))),
    of_all(
        "symbols that match",
        lambda a: (*(s for s in workspace_symbols(a) if is_match("E", s.name)),),
    ),
    of_all("folds", folds),
    of_all("colours", semantic_tokens),
    of_all("lenses", code_lenses),
    of_all("hints", lambda a: inlay_hints(a, 0, a.syntax.length, InlayHintOptions(units=True))),
    of_all("hints unless asked for more", lambda a: inlay_hints(a, 0, a.syntax.length)),
    of_all("fix of all", fix_all_action),
    at_each("hover", hover),
    at_each("place of the hover", hover_place),
    at_each("signature", signature_help),
    at_each("definition", definitions),
    at_each("bound parameter", bound_parameter),
    at_each("references", references),
    at_each("highlights", highlights),
    at_each("linked", linked_ranges),
    at_each("hierarchy", hierarchy_items),
    at_each("name to change", rename_range),
    at_each("renaming", lambda a, offset: rename(a, offset, "gate")),
    at_each("renaming to what is there", lambda a, offset: rename(a, offset, "tip")),
    at_each("selection", lambda a, offset: selection_ranges(a, offset)[:2]),
    at_each("completion", lambda a, offset: completions(a, offset).items),
    at_each("suggestions", lambda a, offset: [i.label for i in suggestions(a, offset).items]),
    at_each("narrowed", lambda a, offset: [i.label for i in narrowed(a, offset).items]),
    at_each("actions", lambda a, offset: code_actions(a, offset, offset)),
)


@pytest.mark.parametrize("name", DOCUMENTS)
def test_answers_are_as_recorded(name: str) -> None:
    text, settings = DOCUMENTS[name]
    analysis = analyse(text, settings)
    offsets = edges_of_tokens(analysis)
    told = [
        line
        for title, answers in FEATURES
        for line in (f"## {title}", *answers(analysis, Teller(text), offsets))
    ]
    assert_as_recorded(FOLDER / f"{name}.txt", told)
