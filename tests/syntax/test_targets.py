"""Which target takes what: the forms of a value, the notes of an island, and their rewrites."""

import pytest
from tests.support import robots

from kindsl.language.syntax.document import parse
from kindsl.language.syntax.portability import PortabilityNote, portability
from kindsl.language.syntax.scanner import scan
from kindsl.language.syntax.value_forms import accepted_by
from kindsl.language.text.edits import TextEdit, apply_edits

BOTH, A, B, NONE = {"robcogen", "robcogen2"}, {"robcogen"}, {"robcogen2"}, set()
ROBOT = robots.STUB.replace("(PI/2.0, 0.0, 0.0)", "(0.0, 0.0, PI)")


@pytest.mark.parametrize(
    ("text", "targets"),
    [
        ("1.0", BOTH), ("-.5", BOTH), ("+1.0", BOTH), ("007.50", BOTH),
        ("1", NONE), ("-1", NONE), ("1.", B), ("1e-3", B), ("1.0e-3", B), ("- 1.0", B),
        ("1.0e3", BOTH), ("-1.0e3", BOTH), ("- 1.0e3", B), ("--1.0", B),
        ("PI", BOTH), ("-PI", BOTH), ("- PI", BOTH), ("PI/2.0", BOTH), ("PI/-2.0", BOTH),
        ("PI/.5", BOTH), ("PI/2", B), ("2*PI", B), ("2.0*PI", B), ("2.0 PI", A), ("2.0PI", A),
        ("pi", BOTH), ("pI/2.0", BOTH), ("|i", B), ("P|/2.0", B), ("PI*2.0", NONE),
        ("3.0*PI/4.0", NONE), ("(PI)", NONE), ("PI+1.0", NONE), ("+PI", NONE),
        ("x", BOTH), ("-x", BOTH), ("-x/2.0", BOTH), ("2.0 x", A), ("-2.0 x", A), ("2.0*x", B),
        ("x/2", B), ("2.0*3.0", B), ("1.0/3.0", B), ("1/3", NONE), ("x*y", NONE),
        ("2.0*-x", NONE), ("x[1.0]", B), ("x[1]", B), ("x[1e-3]", B), ("-x[1.0]", B),
        ("2.0*x[1.0]", B), ("x[1.0]/2.0", B), ("x[PI]", NONE), ("2.0 x[1.0]", NONE),
        ("<k=1.0>", B), ("<k=1>", B), ("<k>", B), ("-<k=1.0>", B), ("2.0*<k>", B),
        ("<k=PI>", NONE), ("<pitch=1.0>", B), ("pitch", A), ("PIx/2.0", A), ("2.0*pitch", NONE),
        ("2.0 pitch", A), ("pitch[1.0]", NONE), ("^x", A), ("^x[1.0]", NONE), ("é", B),
        ("2.0 é", NONE), ("x" * 9, BOTH), ("0x10", NONE), ("1_0.0", NONE), ("1.0.5", NONE),
    ],
)  # fmt: skip
def test_forms_of_a_value(text: str, targets: set[str]) -> None:
    tokens = scan(text)
    assert tokens[-1].end == len(text)
    assert accepted_by(tokens) == targets


def notes(text: str) -> list[PortabilityNote]:
    return [note for island in parse(text).islands for note in portability(island)]


def rewritten(text: str) -> str:
    document = parse(text)
    edits = [
        TextEdit(start + edit.start, start + edit.end, edit.text)
        for start, island in zip(document.starts, document.islands, strict=True)
        for note in portability(island)
        for edit in (note.repair.edits if note.repair else ())
    ]
    return apply_edits(text, edits)


def test_what_both_take_has_no_note() -> None:
    assert notes(ROBOT) == []


@pytest.mark.parametrize(
    ("old", "new", "target", "kind", "mended"),
    [
        ("(0.0, 0.0, PI)", "(0.0, 0.0, 2.0*PI)", "robcogen", "value-form", "(0.0, 0.0, PI/0.5)"),
        ("(0.0, 0.0, PI)", "(0.0, 0.0, -2.0 PI)", "robcogen2", "value-form", "(0.0, 0.0, -PI/0.5)"),
        ("(0.0, 0.0, PI)", "(0.0, 0.0, PI/2)", "robcogen", "value-form", "(0.0, 0.0, PI/2.0)"),
        ("(0.0, 0.0, PI)", "(0.0, 0.0, - 1.5e-3)", "robcogen", "value-form", "(0.0, 0.0, -0.0015)"),
        ("(0.0, 0.0, PI)", "(0.0, 0.0, 2.0*3.0)", "robcogen", "value-form", "(0.0, 0.0, 6.0)"),
        ("(0.0, 0.0, PI)", "(0.0, 0.0, x[1.0])", "robcogen", "value-form", None),
        ("(0.0, 0.0, PI)", "(0.0, 0.0, 3.0*PI)", "robcogen", "value-form", None),
        ("(0.0, 0.0, PI)", "(0.0, 0.0, pitch)", "robcogen2", "value-form", None),
        ("(0.0, 0.0, PI)", "(0.0, 0.0, mass)", "robcogen", "keyword-as-name", None),
        ("(0.0, 0.0, PI)", "(0.0, 0.0, ^x)", "robcogen2", "escaped-name", None),
        ("link upper", "linkupper", "robcogen", "glued-keyword", "link upper"),
        ("Robot arm", "Robotarm", "robcogen", "glued-keyword", "Robot arm"),
        ("mass = 1.0 CoM", "mass = 1.0CoM", "robcogen2", "glued-number", "mass = 1.0 CoM"),
        ("id = 1", "id = 01", "robcogen", "id-form", "id = 1"),
        ("id = 1", "/* a */\nid = 1", "robcogen2", "block-comment", "// a\nid = 1"),
        ("id = 1", "// a\rid = 1", "robcogen", "comment-end", "// a\nid = 1"),
        ("Robot arm", "Robot árm", "robcogen", "non-ascii-name", None),
        ("shoulder {", "shoulder { id = 0", "robcogen", "id-form", None),
    ],
)  # fmt: skip
def test_notes(old: str, new: str, target: str, kind: str, mended: str | None) -> None:
    text = ROBOT.replace(old, new, 1)
    assert [(note.target, note.kind) for note in notes(text)] == [(target, kind)]
    assert rewritten(text) == ROBOT.replace(old, mended or new, 1)


def test_missing_inertia_is_noted() -> None:
    start = ROBOT.index("inertia_params")
    text = ROBOT[:start] + ROBOT[ROBOT.index("children") :]
    assert [(note.target, note.kind) for note in notes(text)] == [("robcogen", "missing-inertia")]


def test_notes_are_kept_with_the_island() -> None:
    island = parse(ROBOT).islands[1]
    assert portability(island) is portability(island)
