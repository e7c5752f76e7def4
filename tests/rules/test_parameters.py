"""Parameters, constants and values: each sentence of their rules, and what they leave alone."""

import pytest
from tests.support.example_documents import document_of
from tests.support.examples import STEEL_BALL, joint, link, robot
from tests.support.one_rule import found, told

from kindsl.judgement.rules.checks.kd404_unused_binding import unused_bindings
from kindsl.language.text.edits import apply_edits


def at(translation: str, rotation: str = "0.1, 0.2, 0.3", name: str = "elbow") -> str:
    """Return a revolute joint at a pose."""
    return joint(name, rotation=rotation).replace("0.0, 0.0, 0.3", translation, 1)


def ball(mass: str = "4.1", com: str = "0.0, 0.0, 0.0", **moments: str) -> str:
    section = STEEL_BALL.replace("4.1", mass, 1).replace("0.0, 0.0, 0.0", com)
    for name, value in moments.items():
        given = "0.0041" if len(name) == 2 else "0.0"
        section = section.replace(f"{name}={given}", f"{name}={value}")
    return link("ball", 1, inertia=section)


def framed(translation: str, rotation: str = "0.0, 0.0, 0.0") -> str:
    pose = f"{{ translation = ({translation}) rotation = ({rotation}) }}"
    return link("head", 1).removesuffix("}\n") + f"frames {{ eye {pose} }} }}\n"


@pytest.mark.parametrize(
    ("text", "messages"),
    [
        (at("x, 0.0, 0.0"), ["parameter 'x' (length) has no value"]),
        (at("0.0, 0.0, 0.0", "x, 0.0, 0.0"), ["parameter 'x' (angle) has no value"]),
        (ball("x"), ["parameter 'x' (dynamics) has no value"]),
        (
            at("x, x, y"),
            ["parameter 'x' (length) has no value", "parameter 'y' (length) has no value"],
        ),
        (at("x, x[0.5], 0.0"), []),
        (at("elbow, 0.0, 0.0"), []),
        (at("on_elbow, 0.0, 0.0"), []),
        (at("0.0, 0.0, 0.0", "\N{GREEK SMALL LETTER PI}, 0.0, 0.0"), []),
        (at("0.3m, 0.0, 0.0"), []),
        (at("x, 0.0, 0.0; "), []),
    ],
)
def test_parameters_without_values(text: str, messages: list[str]) -> None:
    assert told("KD401", text) == messages
    assert told("KD401", text, x=0.5, y=0.5) == []


def test_a_parameter_without_value_is_told_where_one_place_is_sound() -> None:
    text = at("x, 0.0, 0.0") + at("x, 0.0, 0.0;", name="wrist")
    assert told("KD401", text) == ["parameter 'x' (length) has no value"]


@pytest.mark.parametrize(
    ("targets", "is_fixed"),
    [
        ((), False),
        (("robcogen",), False),
        (("robcogen2",), True),
        (("robcogen", "robcogen2"), False),
    ],
)
def test_robcogen2_alone_has_defaults(targets: tuple[str, ...], is_fixed: bool) -> None:
    (finding,) = found("KD401", at("x, 0.0, 0.0"), *targets)
    assert (finding.fix is not None) == is_fixed


@pytest.mark.parametrize(
    ("code", "translation", "messages"),
    [
        ("KD402", "x[0.5], x[0.50], x", []),
        (
            "KD402",
            "x[0.5], x[0.4], x[0.5]",
            ["parameter 'x' has conflicting defaults: 0.5 and 0.4"],
        ),
        (
            "KD402",
            "x[0.5], x[0.4], x[0.3]",
            [
                "parameter 'x' has conflicting defaults: 0.5 and 0.4",
                "parameter 'x' has conflicting defaults: 0.5 and 0.3",
            ],
        ),
        ("KD407", "<k=0.5>, <k=0.50>, <k>", []),
        ("KD407", "<k=0.5>, <k>, <k=0.50>", []),
        ("KD407", "<k>, <k=0.5>, <k=0.4>", ["constant 'k' is 0.4 here and 0.5 elsewhere"]),
        (
            "KD407",
            "<k=0.5>, <k=0.4>, <k=0.3>",
            [
                "constant 'k' is 0.4 here and 0.5 elsewhere",
                "constant 'k' is 0.3 here and 0.5 elsewhere",
            ],
        ),
    ],
)
def test_each_value_is_compared_with_the_first(
    code: str, translation: str, messages: list[str]
) -> None:
    assert told(code, at(translation)) == messages


@pytest.mark.parametrize(
    ("text", "messages"),
    [
        (at("x, x, 2.0 x"), []),
        (at("x, x, y", "y, x, x"), [("an angle", "a length", "y"), ("an angle", "a length", "x")]),
        (ball("x") + at("x, 0.0, 0.0"), [("a length", "a property of inertia", "x")]),
        (
            ball("x") + at("x, 0.0, 0.0", "x, 0.0, 0.0"),
            [
                ("a length", "a property of inertia", "x"),
                ("an angle", "a property of inertia", "x"),
            ],
        ),
    ],
)
def test_each_other_kind_is_told_once(text: str, messages: list[tuple[str, str, str]]) -> None:
    expected = [
        f"parameter '{name}' is {here} here and {first} elsewhere: the generators keep two values"
        for here, first, name in messages
    ]
    assert sorted(told("KD403", text)) == sorted(expected)


def test_what_is_bound_in_vain_is_told_with_what_is_free() -> None:
    assert unused_bindings(["lenght"], ["width", "length"]) == {
        "lenght": "no document uses parameter 'lenght'; did you mean 'length'?"
    }
    assert unused_bindings(["elbwo"], ["elbow"], "joint") == {
        "elbwo": "no document has a joint 'elbwo'; did you mean 'elbow'?"
    }
    assert unused_bindings(["lenght", "length"], ["length"]) == {
        "lenght": "no document uses parameter 'lenght'"
    }
    assert unused_bindings(["length"], ["length"]) == {}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (ball(), None),
        (ball("m"), "the mass is parametric, the moments are not"),
        (ball("2.0 m", "m, 0.0, 0.0"), "the mass is parametric, the moments are not"),
        (ball("4.1", "0.0, x, 0.0"), "the CoM is parametric, the moments are not"),
        (ball("<k>"), None),
        (ball("4.1", Ixy="x"), "the moments are parametric, the mass is not"),
        (ball("<k>", Ix="x"), "the moments are parametric, the mass is not"),
        (ball("m", Iz="m/100.0"), None),
        (ball("m", Ix="0.0", Iy="0.0", Iz="0.0"), None),
        (ball("m", Ix="0.0", Iy="0.0", Iz="0.1"), "the mass is parametric, the moments are not"),
    ],
)
def test_an_inertia_is_parametric_as_a_whole(text: str, message: str | None) -> None:
    expected = [] if message is None else [f"inertia of 'ball': {message}"]
    assert told("KD405", text) == expected


@pytest.mark.parametrize("word, count", [("", 0), ("floating", 1)])
def test_a_fixed_base_may_be_parametric_in_part(word: str, count: int) -> None:
    section = STEEL_BALL.replace("4.1", "m", 1)
    text = robot(link("a", 1), base="a via j", joints="j")
    text = text.replace("ground {", f"ground {word} {{ {section}")
    assert len(told("KD405", text)) == count


def test_a_constant_that_is_meant_is_written_at_all_places() -> None:
    text = document_of(at("<reach=0.5>, <raech>, <raech>"))
    (finding,) = found("KD406", text)
    assert finding.message == "constant 'raech' has no value; did you mean 'reach'?"
    assert finding.fix is not None and finding.fix.title == "Replace 'raech' with 'reach'"
    assert "<reach=0.5>, <reach>, <reach>" in apply_edits(text, finding.fix.edits)


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (at("<k>, 0.0, 0.0"), 1),
        (at("<k>, 0.0, 0.0;"), 0),
        (at("<k>, 0.0, 0.0") + at("0.0, 0.0, k; 0.0", name="wrist"), 0),
        (at("<k>, 0.0, 0.0") + at("0.0, 0.0, q; 0.0", name="wrist"), 1),
    ],
)
def test_a_constant_may_be_defined_where_the_syntax_is_broken(text: str, count: int) -> None:
    assert len(told("KD406", text)) == count


def test_a_constant_without_value_is_not_what_another_means() -> None:
    assert told("KD406", at("<reach>, <raech>, 0.0")) == [
        "constant 'reach' has no value",
        "constant 'raech' has no value",
    ]


@pytest.mark.parametrize(
    ("text", "messages"),
    [
        (at("pitch, 0.0, 0.0"), ["robcogen2 reads parameter 'pitch' as 'pi' and stops"]),
        (at("Pitch, 0.0, 0.0"), ["robcogen2 reads parameter 'Pitch' as 'Pi' and stops"]),
        (at("tip, epic, 0.0"), []),
        (at("elbow, 0.0, 0.0"), ["parameter 'elbow' has the same name as a joint"]),
        (at("on_elbow, 0.0, 0.0"), ["parameter 'on_elbow' has the same name as a link"]),
        (at("ground, 0.0, 0.0"), ["parameter 'ground' has the same name as a link"]),
        (at("elbow, 0.0, 0.0").replace("ref_frame", "; ref_frame"), []),
        (at("pitch, 0.0, 0.0").replace("ref_frame", "; ref_frame"), []),
        (
            at("2.5m, 0.0, 0.0") + at("0.0, 0.0, 0.0", name="m"),
            ["'2.5m' is 2.5 times a parameter 'm': numbers have no unit"],
        ),
        (at("0.0, pi, 0.0"), ["'pi' is a parameter for robcogen and the number for robcogen2"]),
        (at("0.0, Pi, 0.0"), ["'Pi' is a parameter for robcogen and the number for robcogen2"]),
        (at("0.0, pI, 0.0"), ["'pI' is a parameter for robcogen and the number for robcogen2"]),
        (at("0.0, PI, 0.0"), []),
        (at("0.0, 2.5kg, 0.0"), ["'2.5kg' is 2.5 times a parameter 'kg': numbers have no unit"]),
    ],
)
def test_names_that_are_taken_for_something_else(text: str, messages: list[str]) -> None:
    assert told("KD408", text) == messages


@pytest.mark.parametrize("target", ["robcogen", "robcogen2"])
def test_one_target_reads_a_name_in_one_way(target: str) -> None:
    assert told("KD408", at("pitch, 0.0, 0.0"), target) == []


def test_a_value_makes_a_greek_pi_a_parameter_as_any_other() -> None:
    text = at("0.0, 0.0, 0.0", "\N{GREEK SMALL LETTER PI}, \N{GREEK SMALL LETTER PI}, 0.0")
    message = "'\N{GREEK SMALL LETTER PI}' is a parameter, not the constant PI"
    assert told("KD408", text) == [message, message]
    assert told("KD408", text, **{"\N{GREEK SMALL LETTER PI}": 3.0}) == []


@pytest.mark.parametrize(
    ("text", "messages"),
    [
        (ball("1.0/0.0"), ["'1.0/0.0' divides by zero"]),
        (framed("0.0, x/0.0, 0.0"), ["'x/0.0' divides by zero"]),
        (at("0.0, 1.0/zero, 0.0"), ["'1.0/zero' divides by 'zero', which is zero"]),
        (at("0.0, 1.0/one, zero/1.0"), []),
        (at("0.0, 1.0/unbound, 0.0"), []),
        (at("2.0*zero, 0.0*2.0, one - zero"), []),
        (at("1.0/, 1.0/zero, 0.0"), []),
        (at("1.0/0.0, 1.0/zero, 0.0"), None),
    ],
)
def test_every_division_by_zero_is_told(text: str, messages: list[str] | None) -> None:
    if messages is None:
        messages = ["'1.0/0.0' divides by zero", "'1.0/zero' divides by 'zero', which is zero"]
    assert told("KD409", text, zero=0.0, one=1.0) == messages
