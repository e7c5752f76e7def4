"""What is made of a thing and of something else is made again where that has changed."""

from kindsl.language.text.facts import Fact, Facts


def test_what_is_made_is_kept_while_what_is_given_is_equal() -> None:
    facts, made = Facts(), list[str]()
    kinds = {what: Fact[tuple[object, str]](what) for what in ("weight", "size", "nothing")}

    def make(what: str, *given: object) -> str:
        def making() -> str:
            made.append(what)
            return f"{what} of {given}"

        return facts.made_of(kinds[what], given, making)

    assert make("weight", 1, 2) == "weight of (1, 2)"
    assert make("weight", 1, 2) == "weight of (1, 2)"
    assert make("size", 1, 2) == "size of (1, 2)"
    assert made == ["weight", "size"]
    assert make("weight", 1, 3) == "weight of (1, 3)"
    assert make("weight", 1, 2) == "weight of (1, 2)"
    assert made == ["weight", "size", "weight", "weight"]
    assert make("nothing") == make("nothing") == "nothing of ()"
    assert made[4:] == ["nothing"]
