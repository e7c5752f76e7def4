"""One mistake: all other blocks survive, one message, near the mistake."""

from collections import Counter
from itertools import islice

import pytest
from tests.support.amount import usually
from tests.support.models import LAYOUTS, Style, random_model
from tests.support.mutants import Mutant, links_and_joints, messages, mutants

from kindsl.language.syntax.document import SyntaxDocument, parse

LINKS = usually(7, thoroughly=12)
STEP = usually(5, thoroughly=1)
FEWEST = usually(12, thoroughly=100)
# On one line, a token that makes "//" hides the rest of the document.
LEAST_SURVIVAL = {"usual": 1.0, "allman": 1.0, "one_line": 0.995}


def survives(mutant: Mutant, document: SyntaxDocument, intact: dict[str, object]) -> bool:
    found = links_and_joints(document)
    return all(found.get(k) == v for k, v in intact.items() if k not in mutant.touched)


def lines_off(mutant: Mutant, offset: int) -> int:
    lines = mutant.text.count("\n", 0, offset), mutant.text.count("\n", 0, mutant.offset)
    return abs(lines[0] - lines[1])


def is_nearly_all(count: int, total: int, share: float) -> bool:
    """Whether a share of all is there, or all but one: a small sample has no hundredths."""
    return count >= min(share * total, total - 1)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_one_mistake(layout: str) -> None:
    text = random_model(LINKS, 3, Style(layout=layout))
    intact = links_and_joints(parse(text))
    assert len(intact) == 2 * LINKS + 1
    counts: Counter[tuple[str, str]] = Counter()
    for mutant in islice(mutants(text), None, None, STEP):
        document = parse(mutant.text)
        told = messages(document)
        counts[mutant.kind, "all"] += 1
        counts[mutant.kind, "survive"] += survives(mutant, document, intact)
        counts[mutant.kind, "told"] += bool(told)
        counts[mutant.kind, "one"] += len(told) == 1
        counts[mutant.kind, "near"] += bool(told) and lines_off(mutant, told[0][0]) <= 1
    for kind in ("delete", "duplicate", "substitute", "brace", "truncate"):
        if kind == "truncate" and layout == "one_line":
            continue
        assert counts[kind, "all"] > FEWEST
        assert counts[kind, "survive"] >= LEAST_SURVIVAL[layout] * counts[kind, "all"]
        assert is_nearly_all(counts[kind, "one"], counts[kind, "told"], 0.99)
        assert is_nearly_all(counts[kind, "near"], counts[kind, "told"], 0.98)


@pytest.mark.parametrize("seed", range(3))
def test_a_keyword_in_place_of_a_brace_makes_no_phantom(seed: int) -> None:
    text = random_model(LINKS, seed, Style(layout="allman"))
    names = set(links_and_joints(parse(text)))
    places = [i for i, c in enumerate(text) if c == "{"]
    for place in places:
        for keyword in ("link", "r_joint", "p_joint", "RobotBase"):
            mutant = text[:place] + keyword + text[place + 1 :]
            document = parse(mutant)
            assert set(links_and_joints(document)) <= names | {"", keyword}
            assert len(messages(document)) == 1, mutant[place - 60 : place + 60]


def test_typing_a_link_disturbs_nothing_else() -> None:
    text = random_model(4)
    intact = links_and_joints(parse(text))
    place = text.index("link segment_3")
    typed = "link extra {\n    id = 5\n    children {\n        segment_4 via joint_4\n    }\n}\n"
    for count in range(len(typed) + 1):
        document = parse(text[:place] + typed[:count] + "\n" + text[place:])
        found = links_and_joints(document)
        assert {k: found.get(k) for k in intact} == intact, typed[:count]
        assert len(messages(document)) <= 1, (typed[:count], messages(document))
