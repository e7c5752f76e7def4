"""What stands in each table of a review, in full."""

import pytest
from tests.cli.samples import GOOD, arm
from tests.reports.test_review import page, rows

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.base import Severity
from kindsl.products.reports.page.blocks import Block, Heading, Page, Paragraph, Table
from kindsl.products.reports.review.page import review_page

FLOATING = arm(floating=True)
LONE = "Robot Arm {\nRobotBase base {\n    children {}\n}\n}\n"
_LOWER = GOOD[GOOD.index("link lower") : GOOD.index("r_joint")]
_ELBOW = GOOD[GOOD.index("p_joint") : -2]
SHORT = GOOD.replace(_LOWER, "").replace(_ELBOW, "").replace("lower via elbow", "")


def edited(*pairs: tuple[str, str], text: str = GOOD) -> str:
    """Return a document in which each text has been replaced once."""
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new, 1)
    return text


def section(blocks: Page, title: str) -> list[Block]:
    """Return what stands between a heading of the second level and the next."""
    starts = [i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.level == 2]
    (start,) = [i for i in starts if blocks[i] == Heading(title)]
    return list(blocks[start + 1 : next((i for i in starts if i > start), len(blocks))])


def titles(blocks: Page) -> list[str]:
    return [block.text for block in blocks if isinstance(block, Heading) and block.level == 2]


def test_sections_stand_in_an_order_and_only_where_there_is_something_to_say() -> None:
    assert page(GOOD, GOOD) == (Paragraph("old and new: nothing changed."),)
    other = page(GOOD, edited(("children { lower via elbow }", "children {}"), ("= 2.0", "= 3.0")))
    assert other[0] == Heading("arm: old to new", 1)
    assert titles(other) == ["What changed", "Numbers", "Pictures", "Tree", "Masses", "Findings"]
    assert titles(page(GOOD, edited(("0.5,", "0.6,")))) == [
        "What changed", "Numbers", "Pictures", "Balance at zero", "Findings",
    ]  # fmt: skip
    assert titles(page("", "\n")) == ["Findings"]
    assert page("", "\n")[0] == Heading("(unnamed): old to new", 1)
    assert page(GOOD, "")[0] == page("", GOOD)[0] == Heading("arm: old to new", 1)


def test_a_document_that_came_or_went_is_said() -> None:
    there = kindsl.parse(GOOD, Settings())
    assert review_page(None, there, ("a", "b"))[1] == Paragraph(
        "The document is not in a: it is new."
    )
    assert review_page(there, None, ("a", "b"))[1] == Paragraph("The document is no longer in b.")
    blocks = review_page(there, kindsl.parse(edited(("= 2.0", "= 3.0")), Settings()), ("a", "b"))
    assert not [b for b in blocks if isinstance(b, Paragraph) and "The document" in b.text]


@pytest.mark.parametrize("turn", [1, -1])
def test_who_has_no_tree_and_who_has_errors_is_named(turn: int) -> None:
    names = ("old", "new")[::turn]
    told = [b.text for b in page(*("", GOOD)[::turn]) if isinstance(b, Paragraph)]
    assert told[0] == f"{names[0]} does not describe a tree of links."
    broken = edited(("mass = 2.0", "mass = -2.0"))
    told = [b.text for b in page(*(broken, GOOD)[::turn]) if isinstance(b, Paragraph)]
    assert told[0] == f"{names[0]} has 1 error: showing the rest."
    assert not any(f"{names[1]} has" in text for text in told)


def test_a_renamed_joint_is_one_row_and_other_joints_that_come_and_go_have_theirs() -> None:
    renamed = GOOD.replace("elbow", "knee")
    assert rows(page(GOOD, renamed), "What changed") == [("joint", "knee", "renamed, was 'elbow'")]
    gone, come = (rows(page(*pair), "What changed") for pair in ((GOOD, SHORT), (SHORT, GOOD)))
    assert [row[:3] for row in gone[:3]] == [
        ("link", "lower", "removed"), ("joint", "elbow", "removed"), ("frame", "tip", "removed"),
    ]  # fmt: skip
    assert [row[:3] for row in come[:3]] == [
        ("link", "lower", "added"), ("joint", "elbow", "added"), ("frame", "tip", "added"),
    ]  # fmt: skip


def test_a_link_of_a_renamed_joint_s_name_keeps_its_rows() -> None:
    """Only the joint's own coming and going is what its renaming says."""
    old = edited(("r_joint shoulder", "r_joint turn"), ("via shoulder", "via turn"))
    old = edited(("tip {", "swivel {"), text=old)
    new = edited(("r_joint turn", "r_joint swivel"), ("via turn", "via swivel"), text=old)
    new = edited(("swivel {", "turn {"), text=new)
    found = rows(page(old, new), "What changed")
    assert ("joint", "swivel", "renamed, was 'turn'") in found
    assert ("frame", "turn", "added") in found and ("frame", "swivel", "removed") in found
    assert ("joint", "swivel", "added") not in found and ("joint", "turn", "removed") not in found


def test_the_tree_marks_what_hangs_elsewhere() -> None:
    moved = edited(
        ("children { upper via shoulder }", "children { upper via shoulder lower via elbow }"),
        ("children { lower via elbow }", "children {}"),
    )
    assert rows(page(GOOD, moved), "Tree") == [
        ("base", "base", "base", ""),
        ("  upper", "base via shoulder", "base via shoulder", ""),
        ("  lower", "upper via elbow", "base via elbow", "changed"),
    ]
    assert "Tree" not in titles(page(GOOD, f"\n{GOOD}"))


def test_the_tree_follows_renamed_links_and_ends_with_those_that_are_gone() -> None:
    renamed = GOOD.replace("upper", "thigh")
    assert "Tree" not in titles(page(GOOD, renamed))
    assert rows(page(GOOD, LONE), "Tree") == [
        ("base", "base", "base", ""),
        ("upper", "base via shoulder", "-", "changed"),
        ("lower", "upper via elbow", "-", "changed"),
    ]
    assert rows(page(LONE, GOOD), "Tree")[1:] == [
        ("  upper", "-", "base via shoulder", "changed"),
        ("    lower", "-", "upper via elbow", "changed"),
    ]


def test_a_link_that_nothing_carries_is_said_to_hang_on_nothing() -> None:
    loose = edited(("children { lower via elbow }", "children {}"))
    assert ("lower", "upper via elbow", "nothing", "changed") in rows(page(GOOD, loose), "Tree")


def test_masses_stand_beside_each_other() -> None:
    heavier = edited(("mass = 2.0", "mass = 2.5"))
    assert rows(page(GOOD, heavier), "Masses") == [
        ("base", "1", "1", ""), ("upper", "2", "2.5", "+25 %"), ("lower", "1", "1", ""),
    ]  # fmt: skip
    weightless = edited(("mass = 2.0", "mass = 0.0"))
    assert ("upper", "0", "2", "+2 kg") in rows(page(weightless, GOOD), "Masses")
    assert ("upper", "2", "0", "-100 %") in rows(page(GOOD, weightless), "Masses")
    parametric = edited(("mass = 2.0", "mass = m"))
    assert ("upper", "2", "-", "") in rows(page(GOOD, parametric), "Masses")


def test_numbers_are_flush_right() -> None:
    longer = edited(("0.5,", "0.6,"), ("mass = 2.0", "mass = 2.5"))
    blocks = page(GOOD, longer)
    flush = {t: table.right for t in titles(blocks) for table in section(blocks, t)
             if isinstance(table, Table)}  # fmt: skip
    assert flush == {
        "What changed": frozenset(), "Numbers": {3, 4}, "Masses": {1, 2, 3},
        "Balance at zero": {1, 2, 3},
    }  # fmt: skip


def test_masses_of_renamed_new_and_gone_links() -> None:
    renamed = edited(("mass = 2.0", "mass = 3.0"), text=GOOD.replace("upper", "thigh"))
    assert ("thigh", "2", "3", "+50 %") in rows(page(GOOD, renamed), "Masses")
    assert ("upper", "-", "2", "") in rows(page(LONE, GOOD), "Masses")
    assert rows(page(GOOD, LONE), "Masses") == [
        ("base", "1", "-", ""), ("upper", "2", "-", ""), ("lower", "1", "-", ""),
    ]  # fmt: skip


def test_balance_tells_where_the_mass_went_and_what_holds_it() -> None:
    upright = "rotation = (0.0, 0.0, 0.0) }\n}\np_"
    lying = edited((upright, upright.replace("(0.0,", "(-PI/2.0,", 1)))
    longer = edited(("(0.5, 0.0, 0.0)", "(1.5, 0.0, 0.0)"), text=lying)
    shift, table = section(page(lying, longer), "Balance at zero")
    assert isinstance(shift, Paragraph) and isinstance(table, Table)
    # 1 kg of the 3 kg that move goes 1 m along x.
    assert shift.text == (
        "The centre of mass shifts by 333.3 mm: (0.166667, 0, 0.5) m to (0.5, 0, 0.5) m."
    )
    # The shoulder's axis is the base's y: 1 kg at 0.5 m, then at 1.5 m.
    held, now = 0.5 * 9.81, 1.5 * 9.81
    assert table.rows == (
        ("shoulder", f"{-held:.6g}", f"{-now:.6g}", f"{held - now:+.4g}"),
        ("elbow", "0", "0", ""),
    )


def test_balance_without_mass_or_joints_says_what_is_left() -> None:
    weightless = GOOD.replace("mass = 2.0", "mass = 0.0").replace("mass = 1.0", "mass = 0.0")
    assert "Balance at zero" not in titles(page(weightless, f"\n{weightless}"))
    (table,) = section(page(GOOD, GOOD.replace("elbow", "knee")), "Balance at zero")[1:]
    assert isinstance(table, Table)
    assert [row[0] for row in table.rows] == ["shoulder", "knee", "elbow"]
    assert [row[1:] for row in table.rows if row[0] == "knee"] == [("-", "9.81", "")]


def test_a_floating_base_counts_in_the_balance_and_its_joints_keep_their_names() -> None:
    renamed = FLOATING.replace("elbow", "knee")
    shift, table = section(page(FLOATING, renamed), "Balance at zero")
    assert isinstance(shift, Paragraph) and isinstance(table, Table)
    # 2 kg at a height of 0.5 m, 1 kg at (0.5, 0, 0.5), and the base's 1 kg at the origin.
    assert shift.text.endswith("by 0 mm: (0.125, 0, 0.375) m to (0.125, 0, 0.375) m.")
    assert [row[0] for row in table.rows] == ["shoulder", "knee", "elbow"]


def test_findings_are_counted_and_have_their_own_places() -> None:
    bad = edited(("mass = 2.0", "mass = -2.0"))
    told, new, table = section(page(GOOD, bad), "Findings")
    assert isinstance(told, Paragraph) and isinstance(table, Table)
    n = len(table.rows)
    assert told == Paragraph(f"{n} new, 0 gone, 0 kept") and new == Heading("New", 3)
    line = bad.partition("mass = -2.0")[0].count("\n") + 1
    (place,) = [row[0] for row in table.rows if row[2] == "KD303"]
    column = bad.splitlines()[line - 1].index("-2.0") + 1
    assert place == f"{line}:{column}"
    same = page(GOOD, f"\n{GOOD}")
    assert section(same, "Findings") == [Paragraph("0 new, 0 gone, 0 kept")]
    down = page(bad, "\n" + bad)
    assert section(down, "Findings")[0] == Paragraph(f"0 new, 0 gone, {n} kept")
    assert rows(down, "Kept")[0][0].startswith(f"{line + 1}:")


def test_hints_are_no_findings_of_a_review() -> None:
    hinted = edited(("rotation = (0.0, 0.0, 0.0)", "rotation = (0.0, 1.2345678912, 0.0)"))
    found = kindsl.parse(hinted, Settings()).findings
    assert [finding.severity for finding in found] == [Severity.HINT]
    assert section(page(GOOD, hinted), "Findings") == [Paragraph("0 new, 0 gone, 0 kept")]
