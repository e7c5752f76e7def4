"""What is made of a body is made again where something it is made of has changed."""

from kindsl.analysis.analysis import analyse
from kindsl.rules.broken_text import has_problem_within
from kindsl.rules.duplicates import repeats
from kindsl.rules.examples import link, robot
from kindsl.rules.memory import remembered
from kindsl.semantics.places import Place


def test_what_is_made_is_remembered_while_nothing_has_changed() -> None:
    body = analyse(robot(link("arm", 1))).model.links[0]
    made: list[str] = []

    def make(what: str, *given: object) -> str:
        def making() -> str:
            made.append(what)
            return f"{what} of {given}"

        return remembered(body, what, given, making)

    assert make("weight", 1, 2) == "weight of (1, 2)"
    assert make("weight", 1, 2) == "weight of (1, 2)"
    assert make("size", 1, 2) == "size of (1, 2)"
    assert made == ["weight", "size"]
    assert make("weight", 1, 3) == "weight of (1, 3)"
    assert make("weight", 1, 2) == "weight of (1, 2)"
    assert made == ["weight", "size", "weight", "weight"]
    assert make("nothing") == make("nothing") == "nothing of ()"
    assert made[4:] == ["nothing"]


def test_things_repeat_what_the_first_of_their_kind_has() -> None:
    words = ["arm", "leg", "", "Arm", "", "ARM", "hand"]
    assert repeats(words, str.lower) == [("arm", "Arm"), ("arm", "ARM")]
    assert repeats([1, 2, 3], lambda _: None) == []


def test_a_problem_within_a_place_or_right_beside_it_counts() -> None:
    text = robot(link("arm", 1).replace("id = 1", "id = 1 %%%"))
    (island,) = (i for i in analyse(text).model.islands if i.problems)
    (problem,) = island.problems
    start, end = problem.start, problem.end
    places = [(end, end + 3), (end + 1, end + 3), (start - 3, start), (start - 3, start - 1)]
    found = [has_problem_within(Place(island, *place)) for place in [*places, (start, end)]]
    assert found == [True, False, True, False, True]
