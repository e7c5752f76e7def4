"""What follows what is found once for all readings, but not kept for ever."""

from sys import getrefcount

import pytest

from kindsl.language.syntax.automaton import Stack, initial
from kindsl.language.syntax.document import parse

# Of resident memory, by which a server grows with each stack that it keeps of random edits.
_BYTES = 1300


def test_a_reading_knows_what_another_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Stack, "made", 0)
    text = "Robot R {\nlink a { id = 1 children { b via } } ("
    parse(text)
    before = Stack.made
    parse(text.replace("link a", "link other"))
    assert Stack.made == before


def test_stacks_are_forgotten_when_they_take_ten_megabytes(monkeypatch: pytest.MonkeyPatch) -> None:
    first = initial("link")
    monkeypatch.setattr(Stack, "made", Stack.made + 10_000_000 // _BYTES)
    assert initial("link") is not first


def test_none_is_kept_longer_than_others(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Stack, "made", 1_000_000_000)
    other = initial("joint")
    monkeypatch.setattr(Stack, "made", 2_000_000_000)
    initial("link")
    assert getrefcount(other) == 2, "by this test alone"


def test_of_what_may_be_lost_no_token_is_left_out_that_can_stand() -> None:
    link = initial("link")
    name = link.after("link")
    assert name is not None
    assert [kind for kind, _ in link.losable()] == ["link"]
    assert name.losable() == (("NAME", name.after("NAME")),)
