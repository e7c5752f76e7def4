"""`kindsl review` of a document and another format: both robots in one picture's frame."""

from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.comparison.trials import ARM, described_text
from tests.comparison.variants import urdf_of, variant

from kindsl.products.reports.review.mechanics_page import HEAVIER, MOVED


@pytest.fixture
def arm(folder: Path) -> Path:
    path = folder / "arm.kindsl"
    path.write_text(ARM)
    return path


def test_what_differs_is_told_and_drawn_on_both_sides(kindsl: Runner, arm: Path) -> None:
    kindsl("convert", "-q", arm, "arm.urdf")
    text = Path("arm.urdf").read_text()
    Path("arm.urdf").write_text(text.replace('xyz="0.35', 'xyz="0.45'))
    line = text[: text.index('xyz="0.35')].count("\n") + 1
    assert kindsl("review", arm.name, "arm.urdf", "-o", "out").status == 0
    page = Path("out/review.md").read_text()
    row = f"| joint | elbow | x | 0.35 m (line 27) | 0.45 m (line {line}) | "
    assert page.startswith("# arm.kindsl and arm.urdf\n\nThe mechanics differ.")
    assert row in page
    assert "before.svg" in page
    before, after = (Path("out", f"{name}.svg").read_text() for name in ("before", "after"))
    assert before != after
    assert MOVED in before
    assert MOVED in after
    assert "before.svg" not in Path("out/comment.md").read_text()


@pytest.mark.parametrize(
    ("old", "new", "colors"),
    [
        ('value="1.3"', 'value="1.4"', {HEAVIER}),
        ('xyz="0.35', 'xyz="0.45', {MOVED}),
        ('xyz="0.125', 'xyz="0.25', {MOVED}),
        ("arm", "robot", set()),
    ],
)
def test_colours_tell_what_moved_and_what_is_heavier(
    kindsl: Runner, arm: Path, old: str, new: str, colors: set[str]
) -> None:
    frame = "frames { tip { translation = (0.125, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }\n    "
    arm.write_text(ARM.replace("children {}", f"children {{}} {frame}"))
    kindsl("convert", "-q", arm, "arm.urdf")
    text = Path("arm.urdf").read_text()
    assert text.count(old) == 1
    Path("arm.urdf").write_text(text.replace(old, new))
    assert kindsl("review", arm.name, "arm.urdf", "-o", "out").status == 0
    for side in ("before", "after"):
        picture = Path(f"out/{side}.svg").read_text()
        assert {color for color in (MOVED, HEAVIER) if color in picture} == colors


def test_conventions_are_listed_and_both_pictures_are_one(kindsl: Runner, arm: Path) -> None:
    skeleton = described_text(ARM)[0].skeleton
    Path("arm.urdf").write_text(urdf_of(variant(skeleton, 3)))
    assert kindsl("review", "arm.urdf", arm.name, "-o", "out").status == 0
    page = Path("out/review.md").read_text()
    assert "The mechanics are equal" in page
    assert "## Numbers" not in page
    assert "## Conventions" in page


def test_a_side_that_is_partly_broken_is_shown_as_far_as_it_goes(kindsl: Runner, arm: Path) -> None:
    kindsl("convert", "-q", arm, "arm.urdf")
    arm.write_text(ARM.replace("mass = 0.8", "mass = "))
    run = kindsl("review", arm.name, "arm.urdf", "-o", "out")
    assert run.status == 0
    page = Path("out/review.md").read_text()
    assert "The mechanics are equal as far as both can be read." in page
    assert "arm.kindsl has errors: showing the rest." in page


def test_what_cannot_be_read_is_refused_and_nothing_is_written(kindsl: Runner, arm: Path) -> None:
    Path("arm.urdf").write_text("<robot name='a'><link name='b'>")
    run = kindsl("review", arm.name, "arm.urdf", "-o", "out")
    assert run.status == 2
    assert "arm.urdf: error: not a readable URDF: not well-formed XML at line 1" in run.err
    assert not Path("out").exists()
