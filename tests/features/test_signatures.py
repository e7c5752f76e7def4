"""Which component of which vector is being typed."""

import pytest
from tests.support.cursor import at_cursor

from kindsl.frontends.features.signature_help import signature_help

FRAME = "link l { frames { f { "


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        ("translation = (", ("translation", 0)),
        ("translation (", ("translation", 0)),
        ("translation = (1.0", ("translation", 0)),
        ("translation = (1.0,", ("translation", 1)),
        ("translation = (1.0, 2.0, 3.0", ("translation", 2)),
        ("translation = (1.0, 2.0, 3.0, 4.0, ", ("translation", 2)),
        # In a part of a component it is still that component.
        ("translation = (1.0, 2.0*(3.0 + ", ("translation", 1)),
        ("translation = (1.0, ((2.0) - (", ("translation", 1)),
        ("translation = ((1.0 + 2.0)*x, (3.0), ", ("translation", 2)),
        ("translation = (1.0, 2.0, 3.0) rotation = (1.0, ", ("rotation", 1)),
        # Outside of the parentheses it is none.
        ("translation = ", None),
        ("translation = (1.0, 2.0, 3.0)", None),
        ("translation = (1.0, 2.0, 3.0) rotation", None),
        ("translation = ((1.0), 2.0, 3.0)", None),
        ("translation = (1.0, 2.0, ((3.0) + 1.0))", None),
        ("translation = (1.0, } tip ", None),
        ("translation = (1.0, } tip { rotation = ", None),
        ("translation = (1.0, rotation = ", None),
        ("(", None),
    ],
)
def test_the_component_at_the_cursor(typed, expected):
    found = signature_help(*at_cursor(f"{FRAME}{typed}$0"))
    told = None if found is None else (found.label.partition(" ")[0], found.active)
    assert told == expected


def test_what_stands_behind_the_cursor_does_not_count():
    found = signature_help(*at_cursor(FRAME + "rotation = (1.0,$0 2.0, 3.0) } } }"))
    assert found is not None
    assert found.active == 1
    shown = [(found.label[p.start : p.end], p.documentation) for p in found.parameters]
    assert shown == [
        ("rx", "radians, about x"),
        ("ry", "radians, about the new y"),
        ("rz", "radians, about the new z"),
    ]
    assert signature_help(*at_cursor(FRAME + "rotation = $0(1.0, 2.0, 3.0) } } }")) is None


@pytest.mark.parametrize(("first", "is_found"), [("1.0", True), ("- 1.0", False)])
def test_a_vector_is_looked_for_within_four_hundred_signs(first, is_found):
    # The word, the equals sign, the parenthesis and 397 numbers and pluses; or a sign more.
    typed = f"translation = ({first}" + " + 1.0" * 198
    found = signature_help(*at_cursor(f"{FRAME}{typed}$0 , 2.0, 3.0) }} }} }}"))
    assert (found is not None) == is_found
