"""Where nothing is concluded, because the syntax is broken there or the text ends."""

import pytest

from kindsl.analysis.analysis import analyse
from kindsl.rules.broken_text import has_problem_within, is_cut_off
from kindsl.rules.examples import link, robot
from kindsl.semantics.places import Place


def test_a_problem_within_a_place_or_right_beside_it_counts() -> None:
    text = robot(link("arm", 1).replace("id = 1", "id = 1 %%%"))
    (island,) = (i for i in analyse(text).model.islands if i.problems)
    (problem,) = island.problems
    start, end = problem.start, problem.end
    places = [(end, end + 3), (end + 1, end + 3), (start - 3, start), (start - 3, start - 1)]
    found = [has_problem_within(Place(island, *place)) for place in [*places, (start, end)]]
    assert found == [True, False, True, False, True]


@pytest.mark.parametrize("n_links", range(4))
def test_a_document_without_its_end_is_cut_off(n_links: int) -> None:
    text = robot(*(link(f"part{n}", n + 1) for n in range(n_links)))
    assert not is_cut_off(analyse(text).model)
    assert is_cut_off(analyse(text.rstrip().removesuffix("}")).model)
    assert not is_cut_off(analyse(text + link("behind", 9)).model)
