"""Which written numbers changed, as they were written, and what a factor says."""

from math import pi

import pytest
from tests.cli.samples import GOOD

import kindsl
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding
from kindsl.products.reports.review.written_numbers import written_changes

_NONE: dict[str, str] = {}
Row = tuple[str, str, str, str, str, str]


def side(text: str, **values: float) -> Analysis:
    bindings = {name: Binding(value) for name, value in values.items()}
    return kindsl.parse(text, Settings(bindings=bindings))


def changes(old: str, new: str, **values: float) -> list[Row]:
    found = list(written_changes(side(old, **values), side(new, **values), _NONE, _NONE))
    return [tuple(change) for change in found]


def with_length(text: str) -> str:
    return GOOD.replace("(0.5, 0.0, 0.0)", f"({text}, 0.0, 0.0)")


@pytest.mark.parametrize(
    ("old", "new", "remark"),
    [
        ("0.5", "-0.5", "sign swapped"),
        ("0.5", "500.0", "1000 times: another unit?"),
        ("500.0", "0.5", "a thousandth: another unit?"),
        ("0.5", f"{0.5 * 180 / pi:.5f}", "180/PI times: degrees?"),
        ("0.5", f"{0.5 * pi / 180:.7f}", "PI/180 times: radians?"),
        ("0.5", "0.6", ""),
        ("0.0", "500.0", ""),
        ("0.5", "0.0", ""),
        ("0.5", "500.04", "1000 times: another unit?"),
        ("0.5", "500.06", ""),
        ("0.5", "1.0/0.0", ""),
    ],
)
def test_a_number_that_changed_is_told_as_it_was_written(old: str, new: str, remark: str) -> None:
    assert changes(with_length(old), with_length(new)) == [
        ("joint", "elbow", "translation x", old, new, remark)
    ]


@pytest.mark.parametrize(
    ("old", "new"),
    [("0.5", "0.50"), ("0.5", "1.0/2.0"), ("0.5", "0.50000000000001"), ("x", "x"), ("0.0", "-0.0")],
)
def test_the_same_value_is_no_change_however_it_is_written(old: str, new: str) -> None:
    assert changes(with_length(old), with_length(new)) == []


def test_without_values_the_words_decide() -> None:
    assert changes(with_length("x"), with_length("y")) == [
        ("joint", "elbow", "translation x", "x", "y", "")
    ]
    assert changes(with_length("x"), with_length("0.5"), x=0.5) == []


def test_joints_frames_and_links_in_this_order_with_all_their_numbers() -> None:
    new = with_length("0.6").replace("tip { translation = (0.0,", "tip { translation = (0.1,")
    new = new.replace("mass = 2.0 CoM = (0.0, 0.0, 0.0)", "mass = 2.5 CoM = (0.0, 0.0, 0.2)")
    new = new.replace("Ix = 0.0101", "Ix = 0.0111")
    assert changes(GOOD, new) == [
        ("joint", "elbow", "translation x", "0.5", "0.6", ""),
        ("frame", "lower.tip", "translation x", "0.0", "0.1", ""),
        ("link", "upper", "mass", "2.0", "2.5", ""),
        ("link", "upper", "CoM z", "0.0", "0.2", ""),
        ("link", "upper", "Ix", "0.0101", "0.0111", ""),
    ]


def test_a_number_that_is_new_or_gone_has_one_side() -> None:
    without = GOOD.replace("mass = 2.0 ", "")
    assert changes(without, GOOD) == [("link", "upper", "mass", "", "2.0", "")]
    assert changes(GOOD, without) == [("link", "upper", "mass", "2.0", "", "")]


def test_things_that_are_on_one_side_only_have_no_rows() -> None:
    other = GOOD.replace("elbow", "knee").replace("tip", "end").replace("lower", "shin")
    assert changes(GOOD, with_length("0.7").replace("elbow", "knee")) == []
    assert changes(GOOD, other.replace("mass = 1.0", "mass = 9.0")) == [
        ("link", "base", "mass", "1.0", "9.0", "")
    ]


def test_renamed_things_keep_their_numbers() -> None:
    new = with_length("0.6").replace("elbow", "knee").replace("lower", "shin")
    new = new.replace("tip { translation = (0.0,", "tip { translation = (0.1,")
    renamed = written_changes(side(GOOD), side(new), {"lower": "shin"}, {"elbow": "knee"})
    assert [change[:3] for change in renamed] == [
        ("joint", "knee", "translation x"), ("frame", "shin.tip", "translation x"),
    ]  # fmt: skip
