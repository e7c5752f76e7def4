"""No honest robot is convicted, neither as a URDF nor as a document of the language."""

from collections.abc import Iterator
from random import Random

import pytest
from tests.support.solid_robots import DESIGNS, hand, solid_robots, star

from kindsl.judgement.analysis.analysis import analyse
from kindsl.robots.interchange.kindsl_writing import written_kindsl
from kindsl.robots.interchange.urdf.urdf_reading import robot_of_urdf

NUMBER = 4 * len(DESIGNS)


def told(text: str) -> Iterator[str]:
    for found in analyse(text).findings:
        if found.severity in ("error", "warning"):
            yield f"{found.code} {found.message}"


@pytest.mark.parametrize("seed", [1, 2])
def test_nothing_is_told_of_urdfs(seed: int) -> None:
    found = {name: [*told(text)] for name, text in solid_robots(NUMBER, seed)}
    assert not any(found.values()), found


def test_nothing_is_told_of_documents() -> None:
    robots = solid_robots(NUMBER, 3, are_exact=True)
    texts = {name: written_kindsl(robot_of_urdf(text, name)).text for name, text in robots}
    found = {name: [*told(text)] for name, text in texts.items()}
    assert not any(found.values()), found


@pytest.mark.parametrize("chance", ["4242 262", "4242 302"])
def test_links_with_motors_at_both_ends_have_moments_about_their_com(chance: str) -> None:
    assert not [*told(star(Random(chance)).urdf())]


@pytest.mark.parametrize("chance", ["77881 164", "77881 284"])
def test_fingers_have_moments_about_their_com(chance: str) -> None:
    assert not [*told(hand(Random(chance)).urdf())]
