"""Habits: each entry of the table matters, and is told in the sentence that stands beside it."""

import re

import pytest

from kindsl.language.syntax.habits.engine import Adapted, Habit, put_right
from kindsl.language.syntax.habits.table import HABITS
from kindsl.language.syntax.scanner import scan

LINK = """link upper {{
    id = 1
    inertia_params {{
        mass = 1.0
        Ixy = 0.0
        {}
    }}
    {}
}}
"""
IN_LINK = ("parent", "ref_frame", "children")


def link(habit: Habit) -> str:
    """A link in which somebody has the habit."""
    is_in_link = habit.example.startswith(IN_LINK)
    return LINK.format(*(("", habit.example) if is_in_link else (habit.example, "")))


def read(text: str, habits: tuple[Habit, ...]) -> tuple[list[tuple[str, str]], Adapted]:
    """What is read of a text, and what became of it."""
    found = put_right(text, scan(text), habits)
    return [(token.kind, token.text) for token in found.tokens], found


@pytest.mark.parametrize("habit", HABITS, ids=lambda habit: habit.example)
def test_each_habit_is_put_right_by_its_entry_alone(habit: Habit) -> None:
    text = link(habit)
    others = tuple(other for other in HABITS if other is not habit)
    meant, found = read(text, HABITS)
    assert meant != read(text, others)[0]
    assert read(text, (habit,))[0] != [(token.kind, token.text) for token in scan(text)]
    for problem in found.problems:
        assert problem.code == habit.code
        if habit.message:
            parts = re.split(r"\{\d\}", habit.message)
            assert re.fullmatch(".+".join(map(re.escape, parts)), problem.message)


@pytest.mark.parametrize("habit", HABITS, ids=lambda habit: habit.example)
def test_no_written_token_is_lost_or_read_twice(habit: Habit) -> None:
    text = link(habit)
    found = put_right(text, scan(text), HABITS)
    written = sorted((t.start, t.end) for t in (*found.tokens, *found.skipped) if not t.is_missing)
    done = 0
    for start, end in written:
        assert not text[done:start].strip()
        assert start >= done
        done = end
    assert not text[done:].strip()


@pytest.mark.parametrize("habit", HABITS, ids=lambda habit: habit.example)
def test_what_is_put_right_stays_so(habit: Habit) -> None:
    text = link(habit)
    found = put_right(text, scan(text), HABITS)
    again = put_right(text, found.tokens, HABITS)
    assert again.tokens == found.tokens
    assert again.problems == []


def test_semicolons_of_a_block_are_told_and_removed_at_once() -> None:
    text = link(HABITS[0]).replace(HABITS[0].example, "children { fore via knee; };")
    text = text.replace("mass = 1.0", "mass = 1.0;; CoM = (0.0; 0.0, 0.0);").replace(
        "id = 1", "id = 1;"
    )
    (problem,) = read(text, HABITS)[1].problems
    assert text[problem.start - 6 : problem.end] == "id = 1;"
    assert problem.repair is not None
    assert problem.repair.title == "Remove each ';' of this block"
    for start, end, new in reversed(problem.repair.edits):
        text = text[:start] + new + text[end:]
    assert text.count(";") == 1  # the one that separates components is another mistake
