"""What lights up with the cursor, is coloured, is hinted or is typed together."""

import pytest
from tests.features.samples import ARM
from tests.support.cursor import at_cursor

from kindsl.frontends.features.inlay_hints import InlayHintOptions, inlay_hints
from kindsl.frontends.features.navigation import highlights, linked_ranges
from kindsl.frontends.features.semantic_tokens import island_tokens, semantic_tokens
from kindsl.frontends.features.symbol_at import named_places
from kindsl.judgement.analysis.analysis import analyse

BASE = "Robot R { RobotBase b { children { l via j } } "


def lit(marked, ask=highlights):
    analysis, offset = at_cursor(marked)
    found = ask(analysis, offset)
    assert isinstance(found, tuple)
    return [(place.start, analysis.text[place.start : place.end]) for place in found]


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        ("$0Robot R { }", []),
        ("Robot R { } $0? }", []),
        ("Robot R { RobotBase b $0{ children { } } }", [(22, "{"), (37, "}")]),
        ("Robot R { RobotBase b { children { } $0} }", [(22, "{"), (37, "}")]),
        ("Robot R { RobotBase b { children { }$0", [(33, "{"), (35, "}")]),
        ("Robot R { RobotBase b { children $0{", []),
        ("link a { frames { f { translation = $0(1.0, 2.0, 3.0) } } }", [(36, "("), (50, ")")]),
        ("link a { frames { f { translation = (1.0$0, 2.0, 3.0) } } }", []),
        ("link a { inertia_params { mass = $0<c> } }", [(33, "<"), (35, ">")]),
        ("link a { inertia_params { mass = p$0[2.0] } }", [(33, "p")]),
        ("link a { inertia_params { mass = p[2.0]$0 } }", [(34, "["), (38, "]")]),
    ],
)
def test_a_bracket_lights_up_with_its_partner(marked, expected):
    assert lit(marked) == expected


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        (BASE + "link $0l { } }", [(35, "l"), (52, "l")]),
        (BASE.replace("l via", "$0l via") + "link l { } }", []),
        (BASE + "link $0k { } }", []),
        (BASE + "link $0^l { } }", []),
        (BASE + "link $0l { } link l { } }", []),
        (BASE + "link l { inertia_params { mass = $0p Ix = p } } }", []),
        (BASE + "link l { inertia_params { mass = $0p[1.0] Ix = p } } }", []),
        (
            BASE + "link l { inertia_params { mass = <$0c=1.0> Ix = <c> } } }",
            [(81, "c"), (94, "c")],
        ),
        ("Robot $0R { }", []),
        ("Robot R { $0}", []),
    ],
)
def test_names_declared_once_are_typed_together(marked, expected):
    assert lit(marked, linked_ranges) == expected


def test_a_comment_is_coloured_line_by_line():
    text = "/* a\r\n\r\n \n b */ // c"
    found = [(t.start, text[t.start : t.end]) for t in semantic_tokens(analyse(text))]
    assert found == [(0, "/* a"), (8, " "), (10, " b */"), (16, "// c")]


def test_what_is_missing_has_no_colour():
    text = "Robot { link { id 1 children { b } inertia_params { mass 1.0 CoM 1.0, ) } } r_joint { }"
    assert all(token.start < token.end for token in semantic_tokens(analyse(text)))


def test_colours_of_a_range():
    text = "Robot R { RobotBase b { } }"
    found = [text[t.start : t.end] for t in semantic_tokens(analyse(text), 7, 10)]
    assert found == ["R", "RobotBase"]
    assert [text[t.start : t.end] for t in semantic_tokens(analyse(text), 8, 9)] == []


def hints(text, start, end, **options):
    every = dict.fromkeys(InlayHintOptions._fields, False)
    found = inlay_hints(analyse(text), start, end, InlayHintOptions(**every | options))
    return [(h.offset, h.text) for h in found]


def test_hints_are_those_of_the_range():
    text = ARM.replace("(-PI/2.0, 0.0, 0.0)", "(-PI/2.0, PI, PI/4.0)")
    at = [text.index(word) + len(word) for word in ("-PI/2.0", "PI,", "PI/4.0")]
    at[1] -= 1
    every = list(zip(at, ["-90°", "180°", "45°"], strict=True))
    assert hints(text, at[0], at[2], angles=True) == every
    assert hints(text, at[0] + 1, at[2] - 1, angles=True) == every[1:2]
    assert hints(text, at[1], at[1], angles=True) == every[1:2]
    assert hints(text, at[1] + 1, at[1], angles=True) == []


@pytest.mark.parametrize(
    ("value", "told"),
    [
        ("2.0", []),
        ("-2.0", []),
        ("1.0 - 3.0", ["= -2"]),
        ("-(2.0)", ["= -2"]),
        ("m[2.0]", ["= 2"]),
        ("-m[2.0]", ["= -2"]),
        ("m", []),
    ],
)
def test_what_is_no_plain_number_is_hinted(value, told):
    text = f"link l {{ inertia_params {{ mass = {value} }} }}"
    assert [hint for _, hint in hints(text, 0, len(text), values=True)] == told


def test_units_are_the_only_hints_that_must_be_asked_for():
    text = ARM.replace("reach", "0.5*2.0")
    found = {hint.kind for hint in inlay_hints(analyse(text), 0, len(text))}
    assert found == {"angle", "inertia", "value"}


def test_units_of_what_is_there():
    text = "link l { inertia_params { CoM = (1.0, 2.0, 3.0) Ix = 1.0 } }"
    assert hints(text, 0, len(text), units=True) == [(47, "m")]
    text = "link l { inertia_params { mass = 2.0 } frames { f { rotation = (0.0, 0.0, 0.0) } } }"
    assert hints(text, 0, len(text), units=True) == [(36, "kg"), (78, "rad")]


def test_the_box_stands_behind_the_brace_of_a_moving_body():
    body = "{ mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix=1.0 Iy=2.0 Iz=2.5 Ixy=0.0 Ixz=0.0 Iyz=0.0 }"
    text = f"RobotBase b {{ inertia_params {body} }}"
    assert hints(text, 0, len(text), inertia=True) == []
    text = text.replace("b {", "b floating {")
    told = "as a 1.7 × 3 × 4.6 m box of 0.042 kg/m³"
    assert hints(text, 0, len(text), inertia=True) == [(text.index("mass") - 1, told)]
    assert hints(text.replace("params {", "params"), 0, 40, inertia=True) == [(37, told)]


def test_an_island_is_coloured_and_searched_for_names_once():
    for island in analyse(ARM).syntax.islands:
        assert island_tokens(island) is island_tokens(island)
        assert named_places(island) is named_places(island)
