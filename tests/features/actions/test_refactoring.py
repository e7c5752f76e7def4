import pytest
from tests.features.samples import ARM, PARAMETRIC
from tests.support.cursor import at_cursor
from tests.support.documents import sound_documents
from tests.support.kept import remarks
from tests.support.mechanisms import assert_same_mechanism, mechanics_by_name

from kindsl.frontends.features.actions.code_actions import refactorings
from kindsl.frontends.features.rename import rename
from kindsl.frontends.features.symbol_at import named_places
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.edits import apply_edits


def offered(marked, settings=None):
    analysis, offset = at_cursor(marked, settings)
    return {action.title: action for action in refactorings(analysis, offset, offset)}


def refactored(marked, title, settings=None):
    analysis, _ = at_cursor(marked, settings)
    action = offered(marked, settings)[title]
    return apply_edits(analysis.text, action.edits)


def has_no_problem(text):
    return not [f for f in analyse(text).findings if f.code.startswith("KD0")]


def test_a_number_becomes_a_parameter_with_default():
    marked = ARM.replace("mass = 2.0", "mass = 2$0.0")
    text = refactored(marked, "Extract to a parameter 'upper_mass' with default")
    assert "mass = upper_mass[2.0]" in text
    assert_same_mechanism(*(mechanics(each) for each in (ARM, text)))


def mechanics(text, values=None):
    return mechanics_by_name(
        analyse(text), {"reach": 0.4, "width": 0.2, "tilt": 0.1, **(values or {})}
    )


@pytest.mark.parametrize(
    ("old", "marked", "name"),
    [
        ("(0.5, 0.0, 0.0)", "($00.5, 0.0, 0.0)", "elbow_x"),
        ("(-PI/2.0, 0.0, 0.0)", "(-PI/2.0, 0.$00, 0.0)", "shoulder_ry"),
        ("Iz=0.2", "Iz=$00.2", "upper_iz"),
        ("PI/2.0, 0.0)\n        }", "PI/2.0, $00.0)\n        }", "tip_rz"),
    ],
)
def test_the_name_tells_the_place(old, marked, name):
    titles = offered(ARM.replace(old, marked))
    assert f"Extract to a parameter '{name}' with default" in titles


def test_the_name_is_new():
    text = ARM.replace("reach", "elbow_x").replace("(0.5, 0.0, 0.0)", "($00.5, 0.0, 0.0)")
    assert "Extract to a parameter 'elbow_x_2' with default" in offered(text)


def test_for_a_target_without_defaults_the_value_goes_to_the_configuration():
    marked = ARM.replace("mass = 2.0", "mass = 2$0.0")
    settings = Settings(frozenset({"robcogen"}))
    action = offered(marked, settings)["Extract to a parameter 'upper_mass', bound in kindsl.toml"]
    assert action.bindings == (("upper_mass", 2.0),)
    assert action.edits[0].text == "upper_mass"


def test_parts_of_a_value_are_not_extracted():
    assert not [t for t in offered(ARM.replace("-PI/2.0", "-PI/2$0.0")) if "Extract" in t]


def test_a_parameter_is_inlined_wherever_it_stands():
    settings = Settings(bindings={"width": Binding(-0.3)})
    marked = PARAMETRIC.replace("width/2.0", "wid$0th/2.0")
    text = refactored(marked, "Inline the parameter 'width'", settings)
    assert "translation = (-0.15, 0.0, 0.0)" in text
    assert "translation = (0.0, 0.0, -0.3)" in text
    before = mechanics(PARAMETRIC, {"width": -0.3})
    assert_same_mechanism(before, mechanics(text))


def test_a_default_is_inlined_and_an_unknown_value_is_not():
    text = refactored(PARAMETRIC.replace("m[1.5]", "$0m[1.5]"), "Inline the parameter 'm'")
    assert "mass = 1.5" in text
    assert not [t for t in offered(PARAMETRIC.replace("-tilt", "-$0tilt")) if "Inline" in t]


def test_links_are_renumbered():
    swapped = ARM.replace("id = 1", "id = 7").replace("link upper", "link $0upper")
    text = refactored(swapped, "Renumber the links")
    model = analyse(text).model
    assert [(str(link.name), link.id) for link in model.links] == [("upper", 1), ("lower", 2)]
    assert "Renumber the links" not in offered(ARM.replace("link upper", "link $0upper"))


UNSORTED = """\
Robot R {
RobotBase b { children { k via jk } } // base
// about l
link l { id = 2 children {} } // beside l

/* about k
   at length */
link k { id = 1 children { l via jl } } // beside k
r_joint jk { ref_frame { translation = (0.0, 0.0, 1.0) rotation = (0.0, 0.0, 0.0) } }
r_joint jl { ref_frame { translation = (0.0, 1.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
"""


def test_links_are_sorted_with_their_comments():
    text = refactored(UNSORTED.replace("link l {", "link $0l {"), "Sort the links, parents first")
    assert text == UNSORTED.replace(
        UNSORTED[UNSORTED.index("// about l") : UNSORTED.index("r_joint jk")],
        "\n/* about k\n   at length */\n"
        "link k { id = 1 children { l via jl } } // beside k\n"
        "// about l\nlink l { id = 2 children {} } // beside l\n",
    )


def test_sorting_on_one_line_does_not_comment_anything_out():
    one_line = UNSORTED.replace("// beside k\nr_joint", "r_joint").replace(
        " // base\n// about l\n", ""
    )
    text = refactored(one_line.replace("link l {", "link $0l {"), "Sort the links, parents first")
    assert has_no_problem(text)
    assert [str(link.name) for link in analyse(text).model.links] == ["k", "l"]
    assert len(analyse(text).model.joints) == 2


def test_sorted_links_are_left_alone():
    assert "Sort the links, parents first" not in offered(ARM.replace("link upper", "link $0upper"))


FRAMED = ARM.replace(
    "        lower via elbow\n    }\n",
    "        lower via elbow\n    }\n    frames {\n        side {\n"
    "            translation = (0.1, -0.2, 0.3)\n            rotation = (0.4, -PI/2.0, 1.1)\n"
    "        }\n    }\n",
)
IN_UPPER = ("mass = 2.0", "ma$0ss = 2.0")


def test_inertia_moves_to_a_frame_and_back():
    there = refactored(FRAMED.replace(*IN_UPPER), "Give the inertia of 'upper' in 'side'")
    assert "Iyz=" in there and "ref_frame = side" in there
    assert has_no_problem(there)
    assert_same_mechanism(mechanics(FRAMED), mechanics(there))
    back = refactored(there.replace(*IN_UPPER), "Give the inertia of 'upper' in its link frame")
    assert "ref_frame = side" not in back
    assert_same_mechanism(mechanics(FRAMED), mechanics(back))
    assert back.count("\n") == FRAMED.count("\n")


def test_inertia_moves_to_a_new_frame_at_the_com():
    title = "Give the inertia of 'upper' about its CoM, in a new frame 'upper_com'"
    for text in (ARM, FRAMED):
        new = refactored(text.replace(*IN_UPPER), title)
        assert has_no_problem(new)
        upper = analyse(new).model.body_named["upper"]
        assert [c.text for c in upper.inertia.com.components] == ["0.0", "0.0", "0.0"]
        assert upper.inertia.moments["Iy"].text == "0.075"
        assert_same_mechanism(mechanics(text), mechanics(new))


def test_inertia_in_one_line_moves_too():
    link = "link upper { id = 1 inertia_params { mass = 2.0 CoM = (0.25, 0.0, 0.0) Ix=0.01 Iy=0.2"
    link += " Iz=0.2 Ixy=0.0 Ixz=0.0 Iyz=0.0} children { lower via elbow } }\n"
    text = ARM[: ARM.index("link upper")] + link + ARM[ARM.index("link lower") :]
    title = "Give the inertia of 'upper' about its CoM, in a new frame 'upper_com'"
    new = refactored(text.replace(*IN_UPPER), title)
    assert has_no_problem(new)
    assert_same_mechanism(mechanics(text), mechanics(new))


def test_parametric_inertia_stays():
    marked = FRAMED.replace("mass = 2.0", "ma$0ss = m")
    assert not [title for title in offered(marked) if "inertia" in title]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("CoM = (0.25, 0.0, 0.0)", "CoM = (x, 0.0, 0.0)"),
        ("Iy=0.2", "Iy=iy"),
        ("Iy=0.2", "Iy=iy[0.2]"),
        ("Iy=0.2", ""),
        ("Iy=0.2", "Iy=0.2 Iy=0.2"),
        ("Iy=0.2", "Ix=0.2"),
        ("CoM = (0.25, 0.0, 0.0)", ""),
        ("CoM = (0.25, 0.0, 0.0)", "CoM = (0.25, 0.0, 0.0) CoM = (0.25, 0.0, 0.0)"),
    ],
)
def test_an_inertia_that_is_not_ten_plain_numbers_stays(old, new):
    marked = FRAMED.replace("mass = 2.0", "ma$0ss = 2.0")
    assert [title for title in offered(marked) if "inertia" in title]
    assert old in marked
    assert not [title for title in offered(marked.replace(old, new, 1)) if "inertia of" in title]


def test_a_generator_that_ignores_ref_frame_gets_none():
    settings = Settings(frozenset({"robcogen2"}))
    assert not [t for t in offered(FRAMED.replace(*IN_UPPER), settings) if "inertia of" in t]


@pytest.mark.parametrize(
    "marked",
    [
        "Robot R {\nRobotBase b { children { l via j } }\nlink l$0 {\n}\n",
        "Robot R { RobotBase b { children { l via j } } link l$0 {}",
        "Robot R { RobotBase b { children { l via j } } link $0l { children {} // c\n}",
        "Robot R { RobotBase b { children { l via j } } link $0l { id = 1 // c\n}",
        "Robot R { RobotBase b {$0} ",
        "Robot R { RobotBase b { children {} } r_joint $0j { id = 1 }",
        "Robot R { RobotBase b { inertia_params { Iy=1.0$0 } children {} } ",
        "Robot R { RobotBase b { inertia_params {\n    Iy=1.0$0\n } children {} } ",
        "Robot R { RobotBase b { children {} frames { f { rotation = (0.0, 0.0, 0.0) $0} } } ",
    ],
)
def test_missing_sections_are_added_where_they_belong(marked):
    (title,) = [title for title in offered(marked) if title.startswith("Add the missing")]
    analysis = analyse(refactored(marked, title))
    assert not [p for island in analysis.syntax.islands for p in island.problems]


def test_optional_sections_can_be_added():
    marked = "Robot R { RobotBase b { children {} } link k$0 { id = 1 children {} }"
    for title in ("Add an inertia section", "Add a frames section"):
        islands = analyse(refactored(marked, title)).syntax.islands
        assert not [problem for island in islands for problem in island.problems]


@pytest.mark.parametrize("path", sound_documents())
def test_refactorings_keep_the_mechanism(path):
    text = path.read_text(encoding="utf-8")
    analysis = analyse(text)
    values = {str(p.name): 0.3 for p in analysis.model.parameters}
    before = mechanics_by_name(analysis, values)
    bodies = analysis.model.bodies
    offsets = [analysis.resolver.span(body.name)[0] for body in bodies[:4]]
    offsets += [analysis.resolver.span(b.inertia.mass)[0] for b in bodies[:4] if b.inertia]
    done = set()
    for offset in offsets:
        for action in refactorings(analysis, offset, offset):
            new = analysis.edited(action.edits)
            assert_same_mechanism(before, mechanics_by_name(new, values))
            assert remarks(new) == remarks(analysis)
            done.add(action.title)
    assert done


@pytest.mark.parametrize("path", sound_documents())
def test_renaming_keeps_the_document(path):
    analysis = analyse(path.read_text(encoding="utf-8"))
    before = [f.code for f in analysis.findings if f.code < "KD3"]
    names = {
        s.entity: start + s.start
        for island, start in zip(analysis.syntax.islands, analysis.syntax.starts, strict=True)
        for s in named_places(island).symbols
    }
    for entity, offset in list(names.items())[::7]:
        new = analysis.edited(rename(analysis, offset, "renamed_thing").edits)
        assert [f.code for f in new.findings if f.code < "KD3"] == before, entity
        assert remarks(new) == remarks(analysis)
        assert new.text.count("renamed_thing") >= 1
