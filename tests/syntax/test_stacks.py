"""What follows what is found once for all readings, but not kept for ever."""

import pytest

from kindsl.language.syntax.automaton import Stack, initial
from kindsl.language.syntax.document import parse


def test_a_reading_knows_what_another_found() -> None:
    text = "Robot R {\nlink a { id = 1 children { b via } } ("
    parse(text)
    before = Stack.made
    parse(text.replace("a", "other"))
    assert Stack.made == before


def test_stacks_are_forgotten_when_there_have_been_many(monkeypatch: pytest.MonkeyPatch) -> None:
    first = initial("link")
    monkeypatch.setattr(Stack, "made", Stack.made + 1_000_000)
    assert initial("link") is not first


def test_of_what_may_be_lost_no_token_is_left_out_that_can_stand() -> None:
    link = initial("link")
    name = link.after("link")
    assert name is not None
    assert [kind for kind, _ in link.losable()] == ["link"]
    assert name.losable() == (("NAME", name.after("NAME")),)
