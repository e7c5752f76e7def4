"""The fuzzing targets on their fixed corpus and on bounded, seeded changes of it."""

import importlib
from pathlib import Path

import pytest
from tests.fuzz.changing import changed
from tests.fuzz.inputs import TARGETS, corpus, words
from tests.support.amount import usually

CHANGES, BLOCKS = 25, usually(2, 40)
FILES = [(target, path) for target in TARGETS for path in corpus(target)]


@pytest.mark.parametrize(("target", "path"), FILES, ids=lambda part: getattr(part, "name", part))
def test_the_corpus_breaks_nothing(target: str, path: Path) -> None:
    importlib.import_module(f"tests.fuzz.targets.{target}").one_input(path.read_bytes())


@pytest.mark.parametrize("block", range(BLOCKS))
@pytest.mark.parametrize("target", TARGETS)
def test_changes_of_the_corpus_break_nothing(target: str, block: int) -> None:
    one_input = importlib.import_module(f"tests.fuzz.targets.{target}").one_input
    inputs, known = [path.read_bytes() for path in corpus(target)], words(target)
    for seed in range(block * CHANGES, (block + 1) * CHANGES):
        data = changed(inputs[seed % len(inputs)], inputs, known, seed)
        try:
            one_input(data)
        except BaseException as error:
            error.add_note(f"{target}, seed {seed}: {data!r}")
            raise
