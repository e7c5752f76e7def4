import pytest
from tests.features.samples import ARM, PARAMETRIC
from tests.support.cursor import at_cursor

from kindsl.frontends.features.completion.completion import completions, documentation
from kindsl.frontends.features.completion.item import without_placeholders
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.language.syntax.tables import KEYWORDS
from kindsl.language.text.edits import TextEdit, apply_edits


def labels(marked, settings=None):
    found = completions(*at_cursor(marked, settings)).items
    return [item.label for item in found if not is_shape(item.label)]


def is_shape(label):
    """Whether it is one of the shapes in an empty inertia, which a fix makes moments of."""
    return label.endswith((" of a mass", " of a density"))


HEAD = "Robot R {\nRobotBase b { children { l via j } }\n"


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        ("$0", ["Robot"]),
        ("Ro$0", ["Robot"]),
        ("Robot R {\n$0", ["RobotBase", "RobotBase floating"]),
        ("Robot R {\nRobotBase b $0", ["floating"]),
        (HEAD + "$0", ["link"]),
        (HEAD + "link l { id = 1 children {} }\n$0", ["link", "r_joint", "p_joint"]),
        (HEAD + "link l { id = 1 } r_joint j { ref_frame { } }\n$0", ["r_joint", "p_joint"]),
        (HEAD + "link l { $0", ["id", "inertia_params", "children", "children {}", "frames"]),
        (HEAD + "link l { id = 1 $0 children {} }", ["inertia_params"]),
        (HEAD + "link l { id = 1 children {} $0 }", ["frames"]),
        (HEAD + "link l { id = 1 inertia_params { $0", [
            "mass", "CoM", "Ix … Iyz", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz", "ref_frame",
        ]),
        (HEAD + "link l { inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix=1.0 Iy=1.0 $0 } }", [
            "Iz … Iyz", "Iz", "Ixy", "Ixz", "Iyz", "ref_frame",
        ]),
        (HEAD + "r_joint j { $0", ["ref_frame", "id"]),
        (HEAD + "r_joint j { ref_frame { $0", ["translation", "rotation"]),
        (HEAD + "r_joint j { ref_frame { translation = (0.0, 0.0, 0.0) $0", ["rotation"]),
        (HEAD + "link l { frames { $0", ["frame"]),
        (HEAD + "link l { frames { f { tr$0", ["translation"]),
        (HEAD + "link l { children { a $0", ["via"]),
        (HEAD + "link $0", ["l"]),
        (HEAD + "link l {} p_joint $0", ["j"]),
        (HEAD + "link l { id = $0", ["1"]),
        (HEAD + "link k { id = 1 } link m { id = 3 } link l { id = $0 }", ["2"]),
        (HEAD + "link l { // id $0", []),
        (HEAD + "link l { /* id $0 */ }", []),
        (HEAD + "link l { id = 1$0", []),
        ("Robot $0", []),
    ],
)  # fmt: skip
def test_only_what_the_grammar_allows_next(marked, expected):
    assert labels(marked) == expected


def test_children_not_yet_attached_come_first():
    text = ARM.replace("lower via elbow", "$0")
    assert labels(text) == ["lower via …", "lower", "link1 via elbow"]
    first = completions(*at_cursor(text)).items[0]
    assert first.text == "lower via ${1:elbow}"


def test_joints_not_yet_used_come_first():
    assert labels(ARM.replace("lower via elbow", "lower via $0")) == ["elbow", "shoulder"]
    assert labels(ARM.replace("lower via elbow", "lower via sh$0")) == ["shoulder"]


@pytest.mark.parametrize("n_links", range(1, 4))
def test_a_new_joint_is_named_after_the_child_it_is_typed_for(n_links):
    names = [f"part_{letter}" for letter in "abc"[:n_links]]
    for typed in names:
        links = "".join(
            f"link {name} {{ id = {number} "
            f"children {{ {'gadget via $0' if name == typed else ''} }} frames {{ }} }}\n"
            for number, name in enumerate(names, 1)
        )
        children = " ".join(f"{name} via {name}_axis" for name in names)
        text = f"Robot R {{\nRobotBase b {{ children {{ {children} }} }}\n{links}}}"
        assert labels(text)[0] == "gadget_joint"


def test_own_frames_stand_behind_ref_frame():
    assert labels(PARAMETRIC.replace("ref_frame = grip", "ref_frame = $0")) == ["grip"]


def test_parameters_of_the_right_class_come_first():
    found = labels(PARAMETRIC.replace("(0.0, -tilt, 0.0)", "(0.0, $0"))
    assert found == ["tilt", "PI/2.0", "-PI/2.0", "PI", "-PI", "0.0", "<offset>"]
    assert labels(PARAMETRIC.replace("width/2.0", "$0"))[:2] == ["width", "0.0"]
    assert labels(PARAMETRIC.replace("mass = 0.1", "mass = $0"))[0] == "m"


def test_values_go_on_behind_a_sign():
    assert labels(PARAMETRIC.replace("-tilt", "-$0")) == ["tilt", "PI/2.0", "PI", "<offset>"]
    assert labels(PARAMETRIC.replace("-tilt", "2.0*$0")) == ["tilt", "PI", "<offset>"]
    assert labels(PARAMETRIC.replace("width/2.0", "-$0")) == ["width", "<offset>"]


def test_constants_are_named_behind_their_bracket():
    assert labels(PARAMETRIC.replace("2.0*<offset>", "2.0*<$0")) == ["offset"]


@pytest.mark.parametrize(
    ("targets", "is_offered"),
    [
        ((), True),
        (("robcogen",), False),
        (("robcogen2",), True),
        (("robcogen", "robcogen2"), False),
    ],
)
def test_a_target_without_constants_is_offered_none(targets, is_offered):
    settings = Settings(frozenset(targets))
    assert ("<offset>" in labels(PARAMETRIC.replace("-tilt", "-$0"), settings)) == is_offered


def test_details_tell_what_a_parameter_is_bound_to():
    settings = Settings(bindings={"width": Binding(0.25)})
    items = completions(*at_cursor(PARAMETRIC.replace("width/2.0", "wi$0"), settings)).items
    assert [item.detail for item in items] == ["length parameter, 0.25"]


def test_the_whole_word_is_replaced():
    analysis, offset = at_cursor(ARM.replace("via elbow", "via el$0bow"))
    found = completions(analysis, offset)
    assert analysis.text[found.start : found.end] == "elbow"


def test_snippets_make_documents_without_problems():
    analysis, offset = at_cursor("$0")
    found = completions(analysis, offset)
    for target in ("robcogen", "robcogen2"):
        robot = analyse(found.items[0].plain_text, Settings(frozenset({target})))
        assert not robot.findings
        assert "$" not in robot.text


@pytest.mark.parametrize("label", ["link", "r_joint", "p_joint"])
def test_blocks_fill_what_is_missing(label):
    text = HEAD + "link k { id = 1 children {} }\n"
    analysis = analyse(text)
    item = next(i for i in completions(analysis, len(text)).items if i.label == label)
    after = analyse(apply_edits(text, [TextEdit(len(text), len(text), item.plain_text)]))
    assert not any(problem for island in after.syntax.islands[:-1] for problem in island.problems)
    assert ("l" if label == "link" else "j") in {
        str(thing.name) for thing in (*after.model.links, *after.model.joints)
    }
    assert all(link.id in (1, 2) for link in after.model.links)


def test_placeholders_can_be_left_out():
    assert without_placeholders("link ${1:a} {$0}") == "link a {}"


def test_documentation_is_asked_for_one_by_one():
    analysis = analyse(ARM)
    assert "link `upper`" in documentation(analysis, "link", "upper")
    assert "revolute" in documentation(analysis, "joint", "shoulder")
    assert "reach" in documentation(analysis, "parameter", "reach")
    assert "intrinsic" in documentation(analysis, "snippet", "rotation")


@pytest.mark.parametrize(
    ("kind", "label", "told"),
    [
        ("link", "nobody", None),
        ("joint", "nobody", None),
        ("parameter", "nobody", "There is no parameter `nobody`."),
        ("constant", "<nobody>", "There is no constant `nobody`."),
        ("value", "nobody", None),
    ],
)
def test_what_is_gone_has_no_documentation(kind, label, told):
    assert documentation(analyse(ARM), kind, label) == told


def test_many_names_are_cut():
    links = "".join(f"link l{i} {{ id = {i} children {{}} }}\n" for i in range(1, 300))
    found = completions(*at_cursor(f"Robot R {{ RobotBase b {{ children {{ $0 }} }}\n{links}}}"))
    assert len(found.items) == 100


@pytest.mark.parametrize("text", [ARM, PARAMETRIC])
def test_whatever_is_offered_the_grammar_takes(text):
    for offset in [k for k in range(len(text) + 1) if text[k - 1 : k] in "{}(,="]:
        found = completions(analyse(text[:offset]), offset)
        for item in (i for i in found.items if not is_shape(i.label)):
            new = analyse(text[: found.start] + item.plain_text + " ").syntax
            problems = [p.message for island in new.islands for p in island.problems]
            assert not [p for p in problems if p.startswith("unexpected")], (offset, item.label)


@pytest.mark.parametrize("text", [ARM, PARAMETRIC])
def test_every_keyword_is_offered_where_it_stands(text):
    syntax = analyse(text).syntax
    for island, start in zip(syntax.islands, syntax.starts, strict=True):
        for token in island.tokens:
            if token.text in KEYWORDS:
                offset = start + token.start
                items = completions(analyse(text[:offset]), offset).items
                assert [i for i in items if token.text in i.text.split()], (token, offset)
