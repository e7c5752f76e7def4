"""What is made of a body is made again where something it is made of has changed."""

from kindsl.analysis.analysis import analyse
from kindsl.rules.examples import link, robot
from kindsl.rules.memory import Memory


def test_what_is_made_is_remembered_while_nothing_has_changed() -> None:
    body = analyse(robot(link("arm", 1))).model.links[0]
    made: list[str] = []
    memories = {what: Memory[str](what) for what in ("weight", "size", "nothing")}

    def make(what: str, *given: object) -> str:
        def making() -> str:
            made.append(what)
            return f"{what} of {given}"

        return memories[what].of(body, given, making)

    assert make("weight", 1, 2) == "weight of (1, 2)"
    assert make("weight", 1, 2) == "weight of (1, 2)"
    assert make("size", 1, 2) == "size of (1, 2)"
    assert made == ["weight", "size"]
    assert make("weight", 1, 3) == "weight of (1, 3)"
    assert make("weight", 1, 2) == "weight of (1, 2)"
    assert made == ["weight", "size", "weight", "weight"]
    assert make("nothing") == make("nothing") == "nothing of ()"
    assert made[4:] == ["nothing"]
