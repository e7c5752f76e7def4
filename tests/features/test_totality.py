"""No feature fails, whatever the text and wherever the cursor."""

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.features.samples import ALL

from kindsl.frontends.features.actions.code_actions import code_actions, fix_all_action
from kindsl.frontends.features.code_lenses import code_lenses
from kindsl.frontends.features.completion.completion import completions
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
    flat_symbols,
    kinematic_outline,
    workspace_symbols,
)
from kindsl.frontends.features.ranges import folds, selection_ranges
from kindsl.frontends.features.rename import Renaming, rename, rename_range
from kindsl.frontends.features.semantic_tokens import semantic_tokens
from kindsl.frontends.features.signature_help import signature_help
from kindsl.frontends.features.symbol_at import symbol_at
from kindsl.frontends.features.tree_path import path_at, token_at
from kindsl.frontends.lsp.handlers.highlighting import MODIFIERS, TYPES
from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.text.edits import apply_edits

SMALL = (
    "Robot R{RobotBase b floating{inertia_params{mass=m[1.0] CoM=(0.0,<k=1.0>,-x/2.0)Ix=2.0*<k>"
    " ref_frame=f}children{l via j}frames{f{translation=(y,0.0,0.0)rotation=(PI/2.0,0.0,0.0)}}}"
    "link l{id=1 children{}}r_joint j{ref_frame{translation=(0.0,0.0,x)}}}//e\n"
)
AT_OFFSET = (
    symbol_at, definitions, bound_parameter, references, highlights, rename_range,
    selection_ranges, linked_ranges, hierarchy_items, hover, signature_help, completions,
)  # fmt: skip
WHOLE = (document_symbols, kinematic_outline, folds, semantic_tokens, code_lenses)


def visit(text, offsets):
    analysis = analyse(text)
    for feature in WHOLE:
        feature(analysis)
    inlay_hints(analysis, 0, len(text), InlayHintOptions(units=True))
    for offset in offsets:
        for feature in AT_OFFSET:
            feature(analysis, offset)
        check_places(analysis, offset)
        for action in code_actions(analysis, offset, offset):
            assert action.title
            apply_edits(analysis.text, action.edits)
    check_outline(analysis)
    check_tokens(analysis)


def check_places(analysis, offset):
    symbol = symbol_at(analysis, offset)
    if symbol is not None:
        assert symbol in references(analysis, offset)
        assert analysis.text[symbol.start : symbol.end].removeprefix("^") == symbol.entity.name
    renaming = rename(analysis, offset, "a_new_name")
    if isinstance(renaming, Renaming):
        assert "a_new_name" in apply_edits(analysis.text, renaming.edits)
    spans = selection_ranges(analysis, offset)
    assert all(b.start <= a.start and a.end <= b.end for a, b in pairwise(spans))
    assert spans[-1] == (0, len(analysis.text))
    token_at(analysis.syntax, offset)
    place = analysis.syntax.island_at(offset)
    path_at(place.island, offset - place.start)


def check_outline(analysis):
    flat = list(flat_symbols(analysis))
    for symbol in flat:
        assert symbol.start <= symbol.name_start <= symbol.name_end <= symbol.end
        assert symbol.name
        predecessors(analysis, symbol.name)
        successors(analysis, symbol.name)
    text = _unrolled(document_symbols(analysis))
    assert all(
        symbol.start <= child.start and child.end <= symbol.end
        for symbol in text
        for child in symbol.children
    )
    entries = sorted(s[:7:3] for s in flat)
    assert sorted(s[:7:3] for s in text if s.kind != "robot") == entries
    assert sorted(s[:7:3] for s in _unrolled(kinematic_outline(analysis))) == entries
    assert len([*workspace_symbols(analysis)]) <= len(flat) + 1


def _unrolled(symbols):
    found = [*symbols]
    for symbol in found:
        found += symbol.children
    return found


def check_tokens(analysis):
    tokens = semantic_tokens(analysis)
    assert all(a.end <= b.start for a, b in pairwise(tokens))
    for token in tokens:
        assert token.type in TYPES
        assert set(token.modifiers) <= set(MODIFIERS)
        assert "\n" not in analysis.text[token.start : token.end]
    for fold in folds(analysis):
        assert fold.start <= fold.end


def test_every_offset_of_every_prefix_of_a_small_document():
    for length in range(len(SMALL) + 1):
        visit(SMALL[:length], [*range(max(length - 1, 0), length + 2), length // 2])


@pytest.mark.parametrize("text", ALL)
def test_every_offset(text):
    visit(text, range(-1, len(text) + 2, 3))


@pytest.mark.parametrize("feature", AT_OFFSET, ids=lambda feature: feature.__name__)
def test_what_is_beyond_an_end_is_at_it(feature):
    for text in (SMALL, SMALL.rstrip()[:-4], "Rob", ""):
        analysis = analyse(text)
        assert feature(analysis, -3) == feature(analysis, 0)
        assert feature(analysis, len(text) + 3) == feature(analysis, len(text))


def test_a_range_that_ends_before_it_begins_has_nothing():
    analysis = analyse(SMALL)
    assert inlay_hints(analysis, 60, 50, InlayHintOptions(units=True)) == ()
    assert semantic_tokens(analysis, 60, 50) == ()


@given(st.lists(st.tuples(st.integers(0, len(SMALL)), st.integers(0, 9)), max_size=4), st.data())
@settings(max_examples=60, deadline=None, derandomize=True)
def test_mutilated_documents(cuts, data):
    text = SMALL
    for at, length in cuts:
        text = text[:at] + text[at + length :]
    visit(text, [data.draw(st.integers(0, len(text)))])


@given(st.text("{}()=,[]<>*/+-.1\n aΩ^|\"'\r/*\x00\u2028", max_size=60))
@settings(max_examples=150, deadline=None, derandomize=True)
def test_noise(text):
    fix_all_action(analyse(text))
    visit(text, range(0, len(text) + 1, 3))
