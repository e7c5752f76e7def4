"""Transforms documents are read past what does not fit, one message a mistake."""

import random

import pytest
from tests.support.amount import usually

from kindsl.language.syntax.transforms_text import read_transforms

GOOD = """\
Robot arm
Frames { fr_base, fr_upper, base, tip }
Transforms { base=fr_base, target=fr_upper  base=tip, target=base }
Jacobians { base=fr_base, target=tip }
"""
WORDS = [*GOOD.replace(",", " , ").replace("=", " = ").split(), "<-", "->"]


def told(text: str) -> list[tuple[str, str]]:
    """Return the message and the stretch of each defect."""
    return [(d.message, text[d.start : d.end]) for d in read_transforms(text).defects]


def test_a_good_document_is_read_whole() -> None:
    document = read_transforms(GOOD)
    assert document.defects == ()
    assert document.robot is not None and document.robot.text == "arm"
    assert [word.text for word in document.frames] == ["fr_base", "fr_upper", "base", "tip"]
    pairs = [(pair.base.text, pair.target.text) for pair in document.transforms]
    assert pairs == [("fr_base", "fr_upper"), ("tip", "base")]
    assert [GOOD[word.start : word.end] for word in document.jacobians[0]] == ["fr_base", "tip"]


NEXT = "'Frames', 'Jacobians' or 'Transforms'"
SEPARATED = "',' or '}'"
PAIR = "a frame, 'base', '}' or 'target'"


@pytest.mark.parametrize(
    ("old", "new", "message", "stretch"),
    [
        ("base, fr_up", "base fr_up", f"expected {SEPARATED} instead of 'fr_upper'", "fr_upper"),
        ("fr_upper, base", "fr_upper,, base", "expected a frame instead of ','", ","),
        ("tip }\nT", "tip\nT", f"expected {SEPARATED} instead of 'Transforms'", "Transforms"),
        ("base=tip,", "base=,", "expected a frame instead of ','", ","),
        ("base=tip, target", "base=tip, ; target", "expected 'target' instead of ';'", ";"),
        (
            "base=tip, target=base",
            "tip < fr_base",
            "expected '<-' or '->' instead of '<'",
            "< fr_base",
        ),
        ("base=tip, target=base", "tip <- -> fr_base", "expected a frame instead of '->'", "->"),
        ("tip }\nT", "tip } ;;% ;\nT", f"expected {NEXT} instead of ';'", ";;% ;"),
        (
            "get=tip }",
            "get=tip",
            "expected a frame, 'base', '}' or 'target' instead of the end of the document",
            "",
        ),
        ("Transforms {", "Jacobians {", "'Jacobians' is repeated", "Jacobians"),
    ],
)
def test_a_mistake_is_one_message(old: str, new: str, message: str, stretch: str) -> None:
    text = GOOD.replace(old, new, 1)
    assert text != GOOD
    assert told(text) == [(message, stretch)]


@pytest.mark.parametrize(
    "pair",
    ["base=a target=b", "base=a, target=b", "a <- b", "a<-b", "b -> a", "target=b, base=a",
     "right=b left=a", "left_frame = a, right_frame = b"],
)  # fmt: skip
def test_a_pair_is_said_in_many_ways(pair: str) -> None:
    document = read_transforms(f"Model arm Frames {{ a, b }} Transforms {{ {pair} c <- d }}")
    assert document.defects == ()
    assert [[word.text for word in both] for both in document.transforms] == [
        ["a", "b"],
        ["c", "d"],
    ]


@pytest.mark.parametrize("half", ["tip", "tip <-", "base", "base=tip", "base=tip, target="])
def test_half_a_pair_hides_nothing_behind_it(half: str) -> None:
    document = read_transforms(GOOD.replace("base=tip, target=base", half))
    assert (len(document.defects), len(document.transforms), len(document.jacobians)) == (1, 1, 1)


def test_sections_out_of_order_are_read_all_the_same() -> None:
    lines = GOOD.splitlines(keepends=True)
    text = "".join([lines[0], lines[3], lines[2], lines[1]])
    assert told(text) == [
        ("'Transforms' must stand before 'Jacobians'", "Transforms"),
        ("'Frames' must stand before 'Jacobians'", "Frames"),
    ]
    document = read_transforms(text)
    assert (len(document.frames), len(document.transforms), len(document.jacobians)) == (4, 2, 1)


def test_mistakes_are_told_each() -> None:
    text = GOOD.replace("fr_base, fr_upper", "fr_base fr_upper").replace(
        "tip, target", "tip, ; target"
    )
    text = text.replace("Jacobians {", "Jacobians { ;")
    assert [stretch for _, stretch in told(text)] == ["fr_upper", ";", ";"]
    assert len(read_transforms(text).frames) == 4 and len(read_transforms(text).jacobians) == 1


def test_any_words_are_read_and_places_are_in_the_text() -> None:
    rng = random.Random(5)
    for _ in range(usually(200, 3000)):
        words = list(WORDS)
        for _ in range(rng.randint(1, 4)):
            at = rng.randrange(len(words) + 1)
            words[at : at + rng.randint(0, 2)] = rng.choices(
                [*WORDS, "?", "/*", "é1", "\x00"], k=rng.randint(0, 2)
            )
        text = " ".join(words)
        document = read_transforms(text)
        last = 0
        for defect in document.defects:
            assert last <= defect.start <= defect.end <= len(text), text
            last = defect.start
        pairs = (word for pair in (*document.transforms, *document.jacobians) for word in pair)
        for word in (*document.frames, *pairs):
            assert text[word.start : word.end] == word.text != ""
