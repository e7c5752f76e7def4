"""The robot of a transforms document, among the files of its folder."""

from collections.abc import Callable
from pathlib import Path

import pytest

from kindsl.judgement.config.robots import robot_beside

NAMES = {"a.kindsl": "A", "b.kindsl": "B"}


def beside(folder: Path, transforms: str, robot: str | None) -> str | None:
    name_of: Callable[[str], str | None] = lambda file: NAMES.get(Path(file).name)  # noqa: E731
    found = robot_beside(str(folder / transforms), robot, name_of)
    return found and Path(found).name


@pytest.mark.parametrize(
    ("files", "transforms", "robot", "expected"),
    [
        (["a.kindsl", "b.kindsl"], "b.dtdsl", "A", "b.kindsl"),
        (["a.kindsl", "b.kindsl"], "c.dtdsl", "B", "b.kindsl"),
        (["a.kindsl", "b.kindsl"], "c.dtdsl", "C", None),
        (["a.kindsl", "b.kindsl"], "c.dtdsl", None, None),
        (["a.kindsl", "c.kindsl"], "d.dtdsl", None, None),
        (["a.kindsl", "notes.txt"], "c.dtdsl", "C", "a.kindsl"),
        ([], "c.dtdsl", "C", None),
    ],
)
def test_the_name_counts_before_the_robot_and_that_before_being_alone(
    tmp_path, files, transforms, robot, expected
):
    for file in files:
        (tmp_path / file).touch()
    assert beside(tmp_path, transforms, robot) == expected
