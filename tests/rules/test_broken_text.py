"""Where nothing is concluded, because the syntax is broken there or the text ends."""

from collections.abc import Iterator

import pytest
from tests.support.examples import STEEL_BALL, link, robot

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.rules.broken_text import is_cut_off
from kindsl.language.semantics.places import Place, has_problem_within


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


FRAME = "frames { hub { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }"
IN_HUB = STEEL_BALL[:-1] + "ref_frame = hub }"
UPPER = link("upper", 1, "lower via elbow").removesuffix("}\n") + FRAME + "}\n"
PAIR = robot(UPPER, link("lower", 2, inertia=IN_HUB), base="upper via lift", joints="lift elbow")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("link upper {\n    id = 1", "link {\n    id = 2", "reuses id 2 of a link without a name"),
        ("link lower {\n    id = 2", "link {\n    id = 1", "expected a name"),
        ("link upper", "link", "expected a name"),
        ("link lower", "link", "expected a name"),
        ("link upper {\n    id = 1", "link {\n    id = 7", "expected a name"),
        ("id = 1\n    inertia_params {", "id\n", "expected 'inertia_params' after 'id'"),
        ("link lower", "link lower { inertia_params { } children { } }\n", "expected 'link'"),
        ("inertia_params {\n        mass", "mass", "expected 'inertia_params' after '1'"),
    ],
)
def test_no_message_quotes_nothing(old: str, new: str, message: str) -> None:
    assert old in PAIR
    told = list(quoted(PAIR.replace(old, new, 1)))
    assert any(message in text for text in told), told
    assert not [text for text in told if "''" in text]


def quoted(text: str) -> Iterator[str]:
    for finding in analyse(text).findings:
        yield finding.message
        yield from (each.message for each in finding.related)
        yield from (fix.title for fix in (finding.fix,) if fix)
