import random

from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.analysis.analysis import analyse
from kindsl.analysis.settings import Settings
from kindsl.rules.examples import link, robot
from kindsl.rules.renumbering import renumbering
from kindsl.text.edits import apply_edits

NUMBERS = Settings(select=("KD101", "KD109", "KD110"))


def chain(*numbers: int) -> str:
    names = [f"part{n}x" for n in range(len(numbers))]
    links = [
        link(name, number, f"{below} via to_{below}" if below else "")
        for name, number, below in zip(names, numbers, [*names[1:], ""], strict=True)
    ]
    joints = " ".join(f"to_{name}" for name in names)
    return robot(*links, base=f"{names[0]} via to_{names[0]}", joints=joints)


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 10**9), size=st.integers(1, 12))
def test_renumbered_links_are_numbered_regularly(seed: int, size: int) -> None:
    generator = random.Random(seed)
    text = chain(*(generator.randrange(1, 2 * size + 1) for _ in range(size)))
    analysis = analyse(text, NUMBERS)
    fix = renumbering(analysis.model)
    assert bool(analysis.findings) == (fix is not None)
    for finding in analysis.findings[:1]:
        assert finding.fix is not None
        after = analyse(apply_edits(text, finding.fix.edits), NUMBERS)
        assert after.findings == ()
        assert [body.id for body in after.model.links] == list(range(1, size + 1))


def test_as_few_numbers_as_possible_change() -> None:
    analysis = analyse(chain(1, 2, 4, 5), NUMBERS)
    fix = renumbering(analysis.model)
    assert fix is not None
    assert [change.text for change in fix.changes] == ["3", "4"]


def test_what_is_no_tree_is_not_renumbered() -> None:
    loop = robot(
        link("one", 3, "other via b"), link("other", 4, "one via a"), base="", joints="a b"
    )
    assert renumbering(analyse(loop).model) is None
