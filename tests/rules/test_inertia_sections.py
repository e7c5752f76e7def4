"""Masses, shapes and placeholders: each sentence of their rules, and what they leave alone."""

import pytest
from tests.support.example_documents import document_of
from tests.support.examples import STEEL_BALL, link, placed_joint, robot
from tests.support.one_rule import body, found, row, section, told, with_base

from kindsl.language.semantics.parameters import Binding
from kindsl.language.text.edits import apply_edits


@pytest.mark.parametrize(
    ("mass", "severity", "message"),
    [
        ("4.1", None, ""),
        ("0.0", "warning", "mass of the moving link 'ball' is zero"),
        ("-0.0", "warning", "mass of the moving link 'ball' is zero"),
        ("-4.1", "error", "mass of 'ball' is negative: -4.1 kg"),
        ("-m", "error", "mass of 'ball' is negative: -2 kg"),
        ("unbound", None, ""),
        ("-; 4.1", None, ""),
    ],
)
def test_a_mass_that_is_not_positive(mass: str, severity: str | None, message: str) -> None:
    told_as = [
        (f.severity, f.message)
        for f in found("KD303", body(mass, "0.0, 0.0, 0.0", 0.1, 0.1, 0.1), m=2.0)
    ]
    assert told_as == ([] if severity is None else [(severity, message)])


@pytest.mark.parametrize(
    ("mass", "com", "moments", "fixed"),
    [
        ("-4.1", "0.0, 0.0, 0.0", (0.1, 0.1, 0.1), "4.1"),
        ("-4.1", "0.0, 0.0, 0.1", (0.1, 0.1, 0.1), "4.1"),
        ("-4.1", "0.0, 0.0, 0.3", (0.1, 0.1, 0.1), None),
        ("-4.1", "0.0, 0.0, 0.0", (0.1, 0.1, 0.3), None),
        ("-4.1", "0.0, 0.0, 0.0", (0.1, 0.1, 0.2), None),
        ("-4.1", "0.0, 0.0, x", (0.1, 0.1, 0.1), None),
        ("-4.1", "0.0, 0.0, 0.0", (0.1, 0.1, "0.1 Ix=0.2"), None),
        ("-m", "0.0, 0.0, 0.0", (0.1, 0.1, 0.1), None),
    ],
)
def test_a_sign_is_taken_away_where_the_body_is_possible_then(
    mass: str, com: str, moments: tuple[object, ...], fixed: str | None
) -> None:
    text = document_of(body(mass, com, *moments))
    (finding,) = found("KD303", text, m=2.0)
    assert (finding.fix is not None) == (fixed is not None)
    if finding.fix is not None:
        assert finding.fix.title == f"Write {fixed}"
        assert f"mass = {fixed} CoM" in apply_edits(text, finding.fix.edits)


@pytest.mark.parametrize("mass", ["0.0", "-1.0"])
def test_a_fixed_base_may_have_any_mass(mass: str) -> None:
    given = section(mass, "0.0, 0.0, 0.0", 0.1, 0.1, 0.1)
    assert told("KD303", with_base("", given)) == []
    assert len(told("KD303", with_base("floating", given))) == 1


@pytest.mark.parametrize(
    ("text", "targets", "expected"),
    [
        (link("a", 1, inertia=""), (), ("warning", "link 'a' has no inertia")),
        (link("a", 1, inertia=""), ("robcogen2",), ("warning", "link 'a' has no inertia")),
        (link("a", 1, inertia=""), ("robcogen",), ("error", "link 'a' has no inertia")),
        (with_base("floating", ""), (), ("error", "floating base 'ground' has no inertia")),
        (
            with_base("floating", ""),
            ("robcogen2",),
            ("error", "floating base 'ground' has no inertia"),
        ),
        (with_base("", ""), (), None),
        (link("a", 1, inertia="; "), (), None),
    ],
)
def test_a_body_without_inertia(
    text: str, targets: tuple[str, ...], expected: tuple[str, str] | None
) -> None:
    told_as = [(f.severity, f.message) for f in found("KD304", text, *targets)]
    assert told_as == ([] if expected is None else [expected])


@pytest.mark.parametrize(
    ("place", "targets", "severity"),
    [
        ("0.0, 0.0, 0.0", (), "hint"),
        ("0.0, 0.0, 0.1", (), "warning"),
        ("0.0, 0.0, 0.0", ("robcogen",), "error"),
    ],
)
def test_a_link_between_two_axes_of_one_joint_may_be_without_inertia(
    place: str, targets: tuple[str, ...], severity: str
) -> None:
    links = link("slide", 1, "torso via turn", inertia="") + link("torso", 2)
    text = robot(
        links, placed_joint("turn", place, "0.0, 0.0, 0.0"), base="slide via shift", joints="shift"
    )
    assert [f.severity for f in found("KD304", text, *targets)] == [severity]


@pytest.mark.parametrize(
    ("name", "severity"),
    [("torso_shift", "hint"), ("torso_turn", "warning"), ("chest_shift", "warning")],
)
def test_a_link_named_after_what_it_carries_and_its_joint_is_part_of_a_joint(
    name: str, severity: str
) -> None:
    links = link(name, 1, "torso via turn", inertia="") + link("torso", 2)
    turn = placed_joint("turn", "0.0, 0.0, 0.1", "0.0, 0.0, 0.0")
    text = robot(links, turn, base=f"{name} via shift", joints="shift")
    assert [f.severity for f in found("KD304", text)] == [severity]


@pytest.mark.parametrize("height", [0.5, 0.0])
@pytest.mark.parametrize("size", [1e-4, 1e-2, 1.0, 10.0])
@pytest.mark.parametrize(
    ("about_com", "shape"),
    [
        ((0.0, 0.0, 0.0), "a point mass"),
        ((0.01, 0.01, 0.0), "an infinitely thin rod"),
        ((0.01, 0.01, 0.02), "an infinitely thin plate"),
        ((0.01, 0.03, 0.04), "an infinitely thin plate"),
    ],
)
def test_bodies_without_extent_at_any_size(
    about_com: tuple[float, ...], shape: str, size: float, height: float
) -> None:
    """Each of 1 kg on the z axis, at the origin or half as far from it as its size."""
    ix, iy, iz = (size**2 * moment for moment in about_com)
    square = (height * size) ** 2
    text = body(
        "1.0",
        f"0.0, 0.0, {height * size:.12f}",
        *(f"{m:.12f}" for m in (ix + square, iy + square, iz)),
    )
    assert told("KD305", text) == [f"inertia of 'ball' describes {shape}"]


SAME = section("2.0", "0.0, 0.0, 0.1", "0.05", "0.05", "0.01", "0.001")


@pytest.mark.parametrize(
    ("sections", "names", "count"),
    [
        ((SAME, SAME, SAME), "upper lower hand", 1),
        ((SAME, SAME, SAME.replace("0.1)", "0.2)")), "upper lower hand", 1),
        ((SAME, SAME, SAME.replace("2.0", "2.1")), "upper lower hand", 0),
        ((SAME, SAME, SAME.replace("0.001", "0.002")), "upper lower hand", 0),
        ((SAME, SAME, SAME), "left_upper right_upper hand", 0),
        ((SAME, SAME), "upper lower", 0),
        ((SAME.replace("2.0", "m"),) * 3, "upper lower hand", 0),
        ((SAME.replace("0.01 ", "i "),) * 3, "upper lower hand", 0),
        ((SAME.replace("Iyz=0.0", ""),) * 3, "upper lower hand", 0),
        ((SAME.replace("2.0", "0.0"),) * 3, "upper lower hand", 0),
        ((SAME.replace("mass = 2.0", ""),) * 3, "upper lower hand", 0),
        ((section("2.0", "0.0, 0.0, 0.0", "0.0", "0.0", "0.0"),) * 3, "upper lower hand", 0),
        ((section("2.0", "0.0, 0.0, 0.0", "0.0", "0.0", "0.1"),) * 3, "upper lower hand", 1),
        ((section("2.0", "0.0, 0.0, 0.0", "0.1", "0.0", "0.0"),) * 3, "upper lower hand", 1),
        ((section("1.0", "0.0, 0.0, 0.0", "1.0", "1.0", "1.0"),) * 3, "upper lower hand", 3),
        (("", "", ""), "upper lower hand", 0),
    ],
)
def test_the_same_numbers_in_three_parts(sections: tuple[str, ...], names: str, count: int) -> None:
    assert len(found("KD310", row(*sections, names=names))) == count


@pytest.mark.parametrize(("word", "count"), [("", 0), ("floating", 1)])
def test_a_placeholder_in_a_fixed_base_matters_to_nobody(word: str, count: int) -> None:
    ones = section("1.0", "0.0, 0.0, 0.0", "1.0", "1.0", "1.0")
    assert len(found("KD310", with_base(word, ones))) == count


@pytest.mark.parametrize(
    ("ix", "iy", "smallest"), [("0.030", "0.020", "-0.07"), ("0.030", "0.050", "-0.06")]
)
def test_the_smallest_of_three_moments_is_told(ix: str, iy: str, smallest: str) -> None:
    """Each of 1 kg at 0.3 m on z, which takes 0.09 kg·m² from two of them."""
    assert told("KD301", body("1.000", "0.000, 0.000, 0.300", ix, iy, "0.040")) == [
        "inertia of 'ball' is not positive definite: "
        f"smallest principal moment about the CoM is {smallest} kg·m²"
    ]


def payload(moment: str, mass: str = "m") -> str:
    return body(mass, "0.0, 0.0, 0.3", moment, moment, "0.01")


@pytest.mark.parametrize(
    ("text", "value", "messages"),
    [
        (payload("0.1"), Binding(1.0, 0.5, 1.0), []),
        (
            payload("0.1"),
            Binding(1.0, 0.5, 2.0),
            ["inertia of 'ball' is physically impossible at m = 2"],
        ),
        (payload("0.1"), Binding(1.0, None, 2.0), []),
        (payload("0.1"), Binding(1.0, 0.5, None), []),
        (payload("0.1"), Binding(1.8, 0.5, 2.0), []),
        (payload("0.1", "<m=1.0>"), Binding(1.0, 0.5, 2.0), []),
        (payload("x"), Binding(1.0, 0.5, 2.0), []),
        (
            body("1.0", "0.0, 0.0, 0.0", "0.1", "0.1", "0.1", "0.0", "0.0", "0.0*1.0/m"),
            Binding(0.1, -0.3, 0.2),
            ["inertia of 'ball' could not be proved possible over the whole range"],
        ),
        (
            body("m", "0.0, 0.0, 0.300", "0.100", "0.100", "<p=0.010>"),
            Binding(1.0, 0.5, 2.0),
            ["inertia of 'ball' is physically impossible at m = 2"],
        ),
        (body("1.0", "0.0, 0.0, 0.3", "0.1", "0.1", "0.01"), Binding(1.0, 0.5, 2.0), []),
        (
            with_base("", section("m", "0.0, 0.0, 0.3", "0.1", "0.1", "0.01")),
            Binding(1.0, 0.5, 2.0),
            [],
        ),
    ],
)
def test_an_inertia_over_the_range_of_its_parameter(
    text: str, value: Binding, messages: list[str]
) -> None:
    assert told("KD411", text, m=value, p=Binding(0.2, 0.1, 0.3)) == messages


def test_keywords_of_an_inertia_are_written_alike_at_all_places() -> None:
    other = STEEL_BALL.replace("inertia_params", "inertia_properties")
    for sections, rare, usual, n_changes in (
        ((STEEL_BALL, other, STEEL_BALL), "inertia_properties", "inertia_params", 1),
        ((STEEL_BALL, other, other), "inertia_params", "inertia_properties", 1),
        ((STEEL_BALL, other, STEEL_BALL, other), "inertia_properties", "inertia_params", 2),
    ):
        names = ["upper", "lower", "hand", "tool"][: len(sections)]
        (finding,) = found("KD702", row(*sections, names=" ".join(names)))
        assert finding.message == f"'{rare}' here, '{usual}' in most of the document"
        assert finding.fix is not None and len(finding.fix.edits) == n_changes
    assert found("KD702", row(other, other, other)) == []
    assert found("KD702", row("", other, other)) == []


@pytest.mark.parametrize(
    ("moments", "names", "length", "expected"),
    [
        (("0.032345", "0.033579", "0.0023456"), "upper lower", "0.04", ["lower"]),
        # Few digits, or modules: that may be by chance, or meant.
        (("0.032", "0.033", "0.002"), "upper lower", "0.04", []),
        (("0.032345", "0.033579", "0.0023456"), "segment1 segment2", "0.3", []),
        # A module of another length has other numbers.
        (("0.032345", "0.033579", "0.0023456"), "segment1 segment2", "0.04", ["segment2"]),
        # Other parts do not hang on one another, and where there are twins these tell.
        (("0.032345", "0.033579", "0.0023456"), "upper,lower", "0.04", []),
    ],
)
def test_a_part_that_has_all_numbers_of_the_one_that_carries_it(
    moments: tuple[str, str, str], names: str, length: str, expected: list[str]
) -> None:
    first, second = names.replace(",", " ").split()
    numbers = section("1.2", "0.0, 0.0, 0.15", *moments)
    below, beside = (f"{second} via bend", "") if "," not in names else ("", f"{second} via bend")
    links = link(first, 1, below, numbers) + link(second, 2, "tip via end", numbers)
    links += link("tip", 3)
    ends = placed_joint("bend", "0.0, 0.0, 0.3", "0.0, 0.0, 0.0")
    ends += placed_joint("end", f"0.0, 0.0, {length}", "0.0, 0.0, 0.0")
    text = robot(links, ends, base=f"{first} via turn {beside}", joints="turn")
    told_of = [f.message for f in found("KD310", text)]
    assert told_of == [
        f"'{name}' has the mass, CoM and moments of '{first}', another part" for name in expected
    ]
