"""What is told to people: columns, numbers, the health of a robot, changes in words."""

import pytest
from tests.cli.samples import GOOD, arm

import kindsl
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.parameters import Binding
from kindsl.products.reports.card import card_page
from kindsl.products.reports.columns import aligned, number
from kindsl.products.reports.difference_text import change_rows
from kindsl.products.reports.page.blocks import Figure, Heading, Page, Paragraph, Table
from kindsl.products.reports.robot_facts import branches, health_facts, robot_facts
from kindsl.products.reports.robot_text import health_text, robot_text
from kindsl.robots.comparison.difference import Difference, difference


def document(text: str) -> kindsl.Document:
    return kindsl.parse(text, Settings())


def table(blocks: Page, title: str) -> Table:
    start = blocks.index(Heading(title))
    found = blocks[start + 1]
    assert isinstance(found, Table)
    return found


def test_columns_are_as_wide_as_their_widest_cell_and_numbers_flush_right() -> None:
    rows = [("a", "1", "x"), ("long", "234", ""), ("", "", "")]
    assert aligned(rows) == "a     1    x\nlong  234\n\n"
    assert aligned(rows, frozenset((1,))) == "a       1  x\nlong  234\n\n"
    assert aligned([]) == ""


def test_a_number_has_its_unit_or_is_a_dash() -> None:
    assert (number(None, "kg"), number(2.0), number(1234567.0, "kg")) == (
        "-", "2", "1.23457e+06 kg",
    )  # fmt: skip


def finding(code: str, severity: Severity, start: int = 0) -> Diagnostic:
    (template,) = document(arm(reach="1")).findings
    return template._replace(code=code, severity=severity, message=f"{code} is so", start=start)


def place(offset: int) -> dict[str, int]:
    return {"line": offset + 1, "column": 7, "offset": offset}


def test_health_puts_errors_before_warnings_and_counts_by_subject() -> None:
    health = health_facts(
        [
            finding("KD301", Severity.WARNING, 3),
            finding("KD101", Severity.ERROR, 5),
            finding("KD102", Severity.ERROR, 4),
            finding("KD501", Severity.HINT, 1),
        ],
        place,
    )
    assert [(f["code"], f["severity"], f["line"]) for f in health["findings"]] == [
        ("KD101", "error", 6), ("KD102", "error", 5), ("KD301", "warning", 4),
    ]  # fmt: skip
    assert health["verdict"] == "broken"
    assert health["subjects"]["names and ids"]["error"] == 2
    assert health["subjects"]["geometry"] == {s.value: int(s is Severity.HINT) for s in Severity}
    assert health_text(health) == (
        "health           broken\n"
        "  names and ids  2 errors\n"
        "  inertia        1 warning\n"
        "  6:7  [KD101] KD101 is so\n"
        "  5:7  [KD102] KD102 is so\n"
        "  4:7  [KD301] KD301 is so\n"
    )


@pytest.mark.parametrize(
    ("severities", "verdict"),
    [
        ((), "good"),
        ((Severity.HINT, Severity.INFORMATION), "good"),
        ((Severity.WARNING, Severity.HINT), "suspect"),
        ((Severity.WARNING, Severity.ERROR), "broken"),
    ],
)
def test_health_is_as_bad_as_the_worst_finding(
    severities: tuple[Severity, ...], verdict: str
) -> None:
    health = health_facts([finding("KD301", severity) for severity in severities], place)
    assert health["verdict"] == verdict
    serious = [s for s in severities if s in (Severity.ERROR, Severity.WARNING)]
    assert len(health["findings"]) == len(serious)
    assert health_text(health).startswith(f"health{' ' * (5 if serious else 2)}{verdict}\n")


def test_health_shows_ten_findings_and_counts_the_rest() -> None:
    for n in (10, 11, 13):
        health = health_facts([finding("KD301", Severity.ERROR)] * n, place)
        lines = health_text(health).splitlines()
        assert sum("[KD301]" in line for line in lines) == 10
        more = [line for line in lines if "more" in line]
        assert more == ([f"  and {n - 10} more, see kindsl lint"] if n > 10 else [])


def changed(old: str, new: str) -> Difference:
    return difference(document(old).skeleton(), document(new).skeleton())


def rows(old: str, new: str) -> list[tuple[str, str, str]]:
    return [tuple(row) for row in change_rows(changed(old, new))]


def test_a_moved_joint_is_told_with_all_that_it_carries() -> None:
    longer = GOOD.replace("(0.5, 0.0, 0.0)", "(0.6, 0.0, 0.0)")
    assert rows(GOOD, longer) == [
        ("joint frame", "elbow", "moved 100 mm, turned 0 deg"),
        ("pose at zero", "lower", "moved 100 mm, turned 0 deg"),
        ("pose at zero", "tip", "moved 100 mm, turned 0 deg"),
        ("total", "reach", "1.5 -> 1.6 m (+6.67 %)"),
    ]
    turned = GOOD.replace("rotation = (0.0, 0.0, 0.0) } }", "rotation = (0.0, 0.0, 0.5) } }")
    assert rows(GOOD, turned)[0] == ("frame", "tip", "moved 0 mm, turned 28.65 deg")


def test_a_mass_is_told_with_its_share_and_in_the_total() -> None:
    assert rows(GOOD, arm(mass="2.5")) == [
        ("inertia", "upper", "mass 2 -> 2.5 kg (+25 %)"),
        ("total", "mass", "3 -> 3.5 kg (+16.7 %)"),
    ]
    assert ("inertia", "upper", "mass 0 -> 2 kg") in rows(arm(mass="0.0"), GOOD)


def test_a_centre_of_mass_and_moments_are_told_where_they_change() -> None:
    com = GOOD.replace("mass = 2.0 CoM = (0.0,", "mass = 2.0 CoM = (0.01,")
    found = {row[1]: row[2] for row in rows(GOOD, com) if row[2].startswith("CoM")}
    assert found == {"upper": "CoM moved 10 mm"}
    moment = GOOD.replace("Ix = 0.0101", "Ix = 0.0111")
    assert rows(GOOD, moment) == [
        (
            "inertia",
            "upper",
            "principal moments (0.0041, 0.0101, 0.0122) -> (0.0041, 0.0111, 0.0122) kg m^2",
        )
    ]


def test_axes_that_turn_and_keep_their_moments_are_told() -> None:
    swapped = GOOD.replace("Ix = 0.0101 Iy = 0.0122", "Ix = 0.0122 Iy = 0.0101")
    (row,) = rows(GOOD, swapped)
    assert row[:2] == ("inertia", "upper")
    assert row[2].startswith("principal axes turned, inertia about the CoM changed by ")
    digit = GOOD.replace("Ix = 0.0101", "Ix = 0.010100000001")
    assert rows(GOOD, digit) == []


def test_a_base_that_floats_is_told_and_nothing_is_nothing() -> None:
    assert ("base", "", "fixed -> floating") in rows(GOOD, arm(floating=True))
    assert rows(GOOD, GOOD) == []


def test_info_shows_parameters_with_range_places_and_what_binds_them() -> None:
    text = arm(reach="length", mass="m").replace("CoM = (0.0, 0.0, 0.0)", "CoM = (0.0, 0.0, x)")
    text = text.replace("rotation = (0.0, 0.0, 0.0)", "rotation = (0.0, 0.0, tilt)")
    facts = robot_facts(document(text))
    by_name = {p["name"]: p for p in facts["parameters"]}
    by_name["m"].update(value=2.0, min=1.0, max=None, origin="--param")
    lines = robot_text(facts).splitlines()
    told = {line.split()[0]: line.split()[1:] for line in lines if line[:1].islower()}
    assert told["m"][:-1] == ["dynamics", "2", "1", "…", "-", "--param"]
    assert told["length"][:3] == ["length", "-", "nothing"]
    assert told["tilt"][:3] == ["angle", "-", "nothing"]
    assert len(told["tilt"]) == 3 + len(by_name["tilt"]["uses"])


def test_of_many_places_info_shows_four() -> None:
    for n in (3, 4, 5):
        text = GOOD
        for axis in ("Ix = 0.0101", "Iy = 0.0122", "Iz = 0.0041", "Ix = 0.0017", "Iy = 0.0020")[:n]:
            text = text.replace(axis, f"{axis[:5]}m")
        (line,) = [x for x in robot_text(robot_facts(document(text))).splitlines() if x[:2] == "m "]
        assert line.endswith(" …") == (n > 4)
        assert line.count(":") == min(n, 4)


def test_info_shows_units_constants_and_names_that_are_missing() -> None:
    facts = robot_facts(document(arm(reach="length", mass="m")))
    for parameter in facts["parameters"]:
        parameter["value"] = 2.0
    assert " 2 m " in robot_text(facts) and "at least 1 kg" in robot_text(facts)
    facts = robot_facts(document(""))
    assert robot_text(facts).startswith("(unnamed): fixed base, 0 degrees of freedom, ")
    facts["dof"] = 1
    assert "1 degree of freedom, " in robot_text(facts)


def test_info_draws_the_tree() -> None:
    both = GOOD.replace("children { upper via shoulder }", "children { upper via a lower via b }")
    both = both.replace("children { lower via elbow }", "children { last via c }")
    both = both.replace("r_joint shoulder", "r_joint a").replace("p_joint elbow", "p_joint b")
    twin = both[both.index("p_joint b") :].replace("p_joint b", "p_joint c")
    both = both[: both.rindex("}")] + "link last { id = 3 children {} }\n" + twin
    lines = robot_text(robot_facts(document(both))).splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("link"))
    assert [line.partition("  ")[0] for line in lines[start + 1 : start + 5]] == [
        "base", "├─ upper", "│", "└─ lower",
    ]  # fmt: skip
    assert lines[start + 3].startswith("│  └─ last")


def test_info_draws_apart_what_nothing_carries() -> None:
    loose = GOOD.replace("children { lower via elbow }", "children {}")
    assert robot_text(robot_facts(document(loose))).split("\n\n")[:2] == [
        "arm: fixed base, 1 degree of freedom, 3 kg",
        "link      id  joint               mass  frames\n"
        "base       0                      1 kg\n"
        "└─ upper   1  shoulder  revolute  2 kg\n"
        "? lower    2                      1 kg  tip",
    ]


def test_info_aligns_its_columns() -> None:
    facts = robot_facts(document(arm(reach="length", mass="m")))
    facts["parameters"][0].update(value=2.5, min=1.0, max=3.0, origin="--param")
    assert robot_text(facts).split("\n\n")[1:3] == [
        "link         id  joint                mass  frames\n"
        "base          0                       1 kg\n"
        "└─ upper      1  shoulder  revolute      -\n"
        "   └─ lower   2  elbow     prismatic  1 kg  tip",
        "parameter  kind      value  range  bound by  places\n"
        "m          dynamics    2.5  1 … 3  --param   8:29\n"
        "length     length        -         nothing   21:32",
    ]


def test_info_shows_constants() -> None:
    facts = robot_facts(document(GOOD))
    facts["constants"] = [{"name": "half", "value": 0.5}, {"name": "x", "value": None}]
    assert "\nconstants\n  half     0.5\n  x          -\n\nrobcogen" in robot_text(facts)


def test_a_floating_base_weighs_and_moves() -> None:
    fixed, floating = (robot_facts(document(arm(floating=f))) for f in (False, True))
    assert (fixed["mass"], fixed["dof"]) == (3.0, 2)
    assert (floating["mass"], floating["dof"]) == (4.0, 8)


def test_bodies_without_an_id_come_last() -> None:
    facts = robot_facts(document(GOOD.replace("id = 1", "")))
    assert [body["id"] for body in facts["links"]] == [2, None]
    swapped = GOOD.replace("id = 1", "id = 7")
    assert [body["id"] for body in robot_facts(document(swapped))["links"]] == [2, 7]


def test_the_card_has_a_row_for_each_thing() -> None:
    blocks = card_page(document(GOOD))
    assert blocks[0] == Heading("arm", 1)
    assert blocks[1] == Paragraph("fixed base, 2 degrees of freedom, mass 3 kg")
    assert isinstance(blocks[2], Figure)
    assert table(blocks, "Tree") == Table(
        ("link", "id", "joint", "kind", "mass / kg", "frames"),
        (
            ("base", "0", "", "", "1", ""),
            ("  upper", "1", "shoulder", "revolute", "2", ""),
            ("    lower", "2", "elbow", "prismatic", "1", "tip"),
        ),
        frozenset((1, 4)),
    )
    assert table(blocks, "Joints").rows == (
        ("shoulder", "revolute", "base", "upper", "(0, 0, 0.5)", "(0, 0, 0)"),
        ("elbow", "prismatic", "upper", "lower", "(0.5, 0, 0)", "(0, 0, 0)"),
    )
    assert table(blocks, "Masses") == Table(
        ("link", "mass / kg", "CoM / m", "principal moments / kg m²", "shape"),
        (
            ("upper", "2", "(0, 0, 0)", "(0.0041, 0.0101, 0.0122)", "-"),
            ("lower", "1", "(0, 0, 0)", "(0.0014, 0.0017, 0.002)", "-"),
        ),
        frozenset((1,)),
    )
    assert table(blocks, "Frames").rows == (("tip", "lower", "(0, 0, 0.5)", "(0, 0, 0)"),)
    assert blocks[-2:] == (Heading("Health"), Paragraph("good"))


def test_the_card_turns_radians_into_degrees() -> None:
    turned = GOOD.replace("rotation = (0.0, 0.0, 0.0) } }", "rotation = (0.0, 0.0, PI/2.0) } }")
    assert table(card_page(document(turned)), "Frames").rows[0][3] == "(0, 0, 90)"


def test_the_card_of_a_floating_robot_has_the_base_s_mass() -> None:
    masses = table(card_page(document(arm(floating=True))), "Masses")
    assert [row[0] for row in masses.rows] == ["base", "upper", "lower"]


def test_the_card_says_what_is_not_known() -> None:
    bound = Settings(bindings={"length": Binding(0.5, 0.1, 0.9, "kindsl.toml")})
    assert table(card_page(kindsl.parse(arm(reach="length"), bound)), "Parameters").rows == (
        ("length", "length", "0.5 m", "0.1", "0.9", "kindsl.toml"),
    )
    blocks = card_page(document(arm(reach="length")))
    assert Paragraph("1 parameter has no value: drawn at a guess") in blocks
    assert table(blocks, "Parameters") == Table(
        ("parameter", "kind", "value", "minimum", "maximum", "bound by"),
        (("length", "length", "-", "-", "-", "nothing"),),
        frozenset((2, 3, 4)),
    )
    start = blocks.index(Heading("Health"))
    assert blocks[start + 1] == Paragraph("suspect")
    found = blocks[start + 2]
    assert isinstance(found, Table) and [row[:3] for row in found.rows] == [
        ("21:32", "warning", "KD401")
    ]


def test_the_card_of_nothing_has_no_name_and_no_picture() -> None:
    blocks = card_page(document(""))
    assert blocks[0] == Heading("(unnamed)", 1)
    assert not any(isinstance(block, Figure) for block in blocks)
    titles = [block.text for block in blocks if isinstance(block, Heading)]
    assert titles[1:] == ["Tree", "Health"]


def test_links_that_nothing_carries_come_last_and_start_anew() -> None:
    loose = GOOD.replace("children { lower via elbow }", "children {}").replace("id = 2", "")
    facts = robot_facts(document(loose))
    found = [(len(are_last), body["name"]) for are_last, body in branches(facts)]
    assert found == [(0, "base"), (1, "upper"), (0, "lower")]
    assert ("lower", "", "", "", "1", "tip") in table(card_page(document(loose)), "Tree").rows
    loop = GOOD.replace("children {}", "children { upper via shoulder }")
    assert [body["name"] for _, body in branches(robot_facts(document(loop)))].count("upper") == 1
