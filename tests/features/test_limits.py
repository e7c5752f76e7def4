"""Where a feature stops counting: what it says at its limit and one further."""

from math import pi

import pytest
from tests.support.cursor import at_cursor

from kindsl.frontends.features.completion.completion import completions
from kindsl.frontends.features.hover.hover import hover
from kindsl.frontends.features.manipulation.value_text import fraction_of_pi
from kindsl.frontends.features.outline import DocumentSymbol, kinematic_outline
from kindsl.judgement.analysis.analysis import Analysis, analyse


def chain(n_links: int) -> Analysis:
    """Return links of which each carries the next."""
    names = [f"l{n}" for n in range(1, n_links + 1)]
    children = [f"{name} via j{name}" for name in names[1:]] + [""]
    links = "\n".join(
        f"link {name} {{ id = {number} children {{ {child} }} }}"
        for number, (name, child) in enumerate(zip(names, children, strict=True), 1)
    )
    return analyse(f"Robot R {{\nRobotBase b {{ children {{ l1 via jl1 }} }}\n{links}\n}}\n")


def depth(symbol: DocumentSymbol) -> int:
    return 1 + max(map(depth, symbol.children), default=0)


def test_a_branch_deeper_than_a_hundred_begins_anew() -> None:
    assert [depth(symbol) for symbol in kinematic_outline(chain(100))] == [101]
    assert [depth(symbol) for symbol in kinematic_outline(chain(103))] == [101, 3]


@pytest.mark.parametrize(("length", "skipped"), [(200, 0), (201, 1)])
def test_a_word_of_two_hundred_letters_is_replaced_as_a_whole(length: int, skipped: int) -> None:
    analysis, offset = at_cursor(f"Robot R {{\n {'a' * length}$0")
    found = completions(analysis, offset)
    assert offset - found.start in (length - skipped, length - skipped + 1)


@pytest.mark.parametrize(("n_uses", "more"), [(8, None), (9, " and 1 more"), (11, " and 3 more")])
def test_eight_uses_of_a_parameter_are_shown(n_uses: int, more: str | None) -> None:
    joints = "\n".join(
        f"r_joint j{n} {{ ref_frame {{ translation = (0.0, 0.0, {'$0' * (not n)}x) }} }}"
        for n in range(n_uses)
    )
    found = hover(*at_cursor(joints))
    assert found is not None
    (told,) = (line for line in found.markdown.splitlines() if "uses: " in line)
    assert told.startswith(f"- {n_uses} uses: translation z of joint `j0`; ")
    assert told.count(";") == 7
    assert told.endswith(more or "joint `j7`")


@pytest.mark.parametrize(
    ("divisor", "text"), [(1.0, "PI"), (2.0, "PI/2.0"), (360.0, "PI/360.0"), (361.0, None)]
)
def test_a_fraction_of_pi_is_half_a_degree_at_least(divisor: float, text: str | None) -> None:
    for sign in (1.0, -1.0):
        found = fraction_of_pi(sign * pi / divisor)
        shown = text if text is None or sign > 0.0 else f"-{text}"
        assert (found.text if found is not None else None) == shown


@pytest.mark.parametrize(("angle", "text"), [(9e-13, "0.0"), (-9e-13, "0.0"), (1.1e-12, None)])
def test_what_is_left_of_zero_is_zero(angle: float, text: str | None) -> None:
    found = fraction_of_pi(angle)
    assert (found.text if found is not None else None) == text
