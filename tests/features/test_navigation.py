import pytest
from tests.features.samples import ARM, PARAMETRIC
from tests.support.cursor import at_cursor

from kindsl.frontends.features.navigation import (
    bound_parameter,
    definitions,
    highlights,
    references,
    uses,
)
from kindsl.frontends.features.symbol_at import Entity, EntityKind, Role, symbol_at
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding


@pytest.mark.parametrize(
    ("marked", "entity"),
    [
        (ARM.replace("Robot Arm", "Robot A$0rm"), Entity(EntityKind.ROBOT, "Arm")),
        (ARM.replace("link upper", "link $0upper"), Entity(EntityKind.LINK, "upper")),
        (ARM.replace("lower via", "lower$0 via"), Entity(EntityKind.LINK, "lower")),
        (ARM.replace("via elbow", "via elb$0ow"), Entity(EntityKind.JOINT, "elbow")),
        (ARM.replace("tip {", "t$0ip {"), Entity(EntityKind.FRAME, "tip", "lower")),
        (ARM.replace("reach", "rea$0ch"), Entity(EntityKind.PARAMETER, "reach")),
        (PARAMETRIC.replace("= grip", "= gr$0ip"), Entity(EntityKind.FRAME, "grip", "palm")),
        (PARAMETRIC.replace("*<offset", "*<$0offset"), Entity(EntityKind.CONSTANT, "offset")),
        (PARAMETRIC.replace("m[1.5]", "$0m[1.5]"), Entity(EntityKind.PARAMETER, "m")),
        (PARAMETRIC.replace("-tilt", "-$0tilt"), Entity(EntityKind.PARAMETER, "tilt")),
    ],
)
def test_a_name_stands_for_what_it_means_at_its_place(marked, entity):
    symbol = symbol_at(*at_cursor(marked))
    assert symbol is not None
    assert symbol.entity == entity


@pytest.mark.parametrize("marked", [ARM.replace("mass", "ma$0ss", 1), ARM.replace("2.0", "2.$00")])
def test_keywords_and_numbers_name_nothing(marked):
    assert symbol_at(*at_cursor(marked)) is None


def defined(marked):
    analysis, offset = at_cursor(marked)
    found = definitions(analysis, offset)
    return [analysis.text[d.start : d.end].split("{")[0].strip() for d in found]


def test_the_definition_of_a_child_is_its_block():
    assert defined(ARM.replace("lower via", "low$0er via")) == ["link lower"]
    assert defined(ARM.replace("via elbow", "via $0elbow")) == ["p_joint elbow"]


def test_a_parameter_is_defined_by_its_default_else_where_it_stands_first():
    assert defined(PARAMETRIC.replace("m[1.5]", "$0m[1.5]")) == ["m[1.5]"]
    assert defined(PARAMETRIC.replace("width/2.0", "wid$0th/2.0")) == ["width"]


def test_a_constant_is_defined_by_its_value():
    assert defined(PARAMETRIC.replace("2.0*<offset", "2.0*<off$0set")) == ["<offset=0.05>"]


def test_a_parameter_bound_outside_is_named():
    settings = Settings(bindings={"width": Binding(0.1, origin="kindsl.toml")})
    marked = PARAMETRIC.replace("width/2.0", "wid$0th/2.0")
    assert bound_parameter(*at_cursor(marked, settings)) == "width"
    assert bound_parameter(*at_cursor(marked)) is None


def test_references_are_all_places_with_their_roles():
    analysis, offset = at_cursor(ARM.replace("link upper", "link up$0per"))
    found = references(analysis, offset)
    assert [analysis.text[p.start : p.end] for p in found] == ["upper", "upper"]
    assert [p.role for p in found] == [Role.READ, Role.DECLARATION]
    assert [p.role for p in uses(analysis, offset)] == [Role.READ]


def test_frames_of_two_links_with_one_name_are_two_things():
    text = ARM.replace("children {\n        lower", "frames { tip { } } children {\n        lower")
    analysis, offset = at_cursor(text.replace("tip { }", "t$0ip { }"))
    assert len(references(analysis, offset)) == 1


def test_highlights_tell_reading_from_writing():
    analysis, offset = at_cursor(PARAMETRIC.replace("<offset=", "<off$0set="))
    assert [h.kind for h in highlights(analysis, offset)] == ["write", "read"]


def test_a_bracket_lights_up_its_partner():
    analysis, offset = at_cursor(ARM.replace("link lower {", "link lower $0{"))
    found = highlights(analysis, offset)
    assert [analysis.text[h.start] for h in found] == ["{", "}"]
    assert found[0].start == offset
