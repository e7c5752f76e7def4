"""Descriptions to compare: whether the base floats where a file leaves that open, and is told."""

from pathlib import Path

import numpy as np
import pytest

import kindsl
from kindsl.frontends.cli.main import main
from kindsl.mechanics.rigid.body import NO_BODY
from kindsl.robots.interchange.descriptions import ReadDescription, read_description, read_foreign
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.registry import all_formats

DOCUMENTS = Path(__file__).parent / "documents"
OPEN, TELLING = ("floating.sdf", "legged.urdf"), ("fixed.xml", "floating.xml")
NOTE = "{} leaves open whether its base floats: compared as {}, like the other"


def read(name: str, floating: bool | None) -> ReadDescription:
    return read_description(DOCUMENTS / name, name, floating)


def test_every_format_is_read() -> None:
    assert all(format.read for format in all_formats())


@pytest.mark.parametrize("name", OPEN)
@pytest.mark.parametrize(("floating", "kind"), [(True, "floating"), (False, "fixed")])
def test_a_base_that_is_left_open_is_as_asked(name: str, floating: bool, kind: str) -> None:
    found = read(name, floating)
    skeleton = found.robot.skeleton
    assert (found.tells_base, skeleton.is_floating) == (False, floating)
    assert (skeleton.masses[0] != NO_BODY) is floating
    assert found.notes == (NOTE.format(name, kind),)


@pytest.mark.parametrize("name", TELLING)
def test_a_base_that_is_told_is_as_told(name: str) -> None:
    told = read(name, None)
    for floating in (True, False):
        assert read(name, floating) == told
    assert told.tells_base and told.notes == ()


def told_by(names: tuple[str, ...], *documents: str) -> tuple[dict, list]:
    """Return whose base floats, and how each file was read."""
    asked = []

    def noted(path: str, floating: bool | None) -> ReadDescription:
        asked.append((path, floating))
        return read(path, floating)

    robots = [read(name, None).robot for name in documents]
    found = read_foreign(names, robots, noted)
    return {path: each.robot.skeleton.is_floating for path, each in found.items()}, asked


def test_with_a_document_each_is_read_once_and_as_that_is() -> None:
    names = ("legged.urdf", "fixed.xml")
    floats, asked = told_by(names, "floating.xml")
    assert floats == {"legged.urdf": True, "fixed.xml": False}
    assert asked == [(name, True) for name in names]


def test_without_a_document_the_one_that_tells_is_followed() -> None:
    floats, asked = told_by(("legged.urdf", "floating.xml"))
    assert floats == {"legged.urdf": True, "floating.xml": True}
    assert asked == [("legged.urdf", None), ("floating.xml", None), ("legged.urdf", True)]


def test_where_none_tells_each_is_read_as_it_stands() -> None:
    floats, asked = told_by(OPEN)
    assert floats == {"floating.sdf": True, "legged.urdf": False}
    assert asked == [(name, None) for name in OPEN]


def test_a_format_whose_numbers_have_no_places_is_read_all_the_same(tmp_path: Path) -> None:
    path = tmp_path / "arm.xacro"
    path.write_text((DOCUMENTS / "floating.urdf").read_text())
    parts = read_description(path, "arm", None).robot.inertias[1]
    assert [part.numbers for part in parts] == [(None,) * 10]


def test_generated_code_tells_its_base(tmp_path: Path) -> None:
    robot = str(DOCUMENTS / "written.kindsl")
    command = [
        "generate",
        robot,
        "--quantities",
        "poses",
        "--language",
        "python",
        "-o",
        str(tmp_path),
    ]
    assert main(command) == 0
    found = read_description(tmp_path, "code", True)
    assert found.tells_base and not found.robot.skeleton.is_floating
    theirs, ours = found.robot.skeleton, kindsl.load(Path(robot)).skeleton()
    np.testing.assert_allclose(
        [pose.numbers for pose in theirs.placements],
        [pose.numbers for pose in ours.placements],
        atol=1e-15,
    )
    for same in ("body_names", "joint_names", "joint_kinds", "parents", "masses", "frames"):
        assert getattr(theirs, same) == getattr(ours, same)


@pytest.mark.parametrize("files", [(), ("inertia_properties.h",), ("transforms.h",)])
def test_a_folder_of_anything_else_is_said(files: tuple[str, ...], tmp_path: Path) -> None:
    for name in files:
        (tmp_path / name).touch()
    with pytest.raises(FormatError, match=r"^no generated code in this folder$"):
        read_description(tmp_path, "folder", None)


@pytest.mark.parametrize("name", ["link_data_map.h", "joint_data_map.h"])
def test_generated_code_without_names_is_said(name: str, tmp_path: Path) -> None:
    for file in (DOCUMENTS / "robcogen").iterdir():
        (tmp_path / file.name).write_bytes(file.read_bytes())
    (tmp_path / name).write_text("")
    with pytest.raises(FormatError, match=f"^'{name}' names nothing$"):
        read_description(tmp_path, "folder", None)
    (tmp_path / name).unlink()
    with pytest.raises(FormatError, match=f"^has no '{name}'$"):
        read_description(tmp_path, "folder", None)
