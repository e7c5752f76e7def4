"""Numbers of other formats whose places cannot be told: read, without a place."""

from pathlib import Path

import pytest
from tests.interchange.round_trips import read

from kindsl.robots.comparison.written import TextPlace
from kindsl.robots.interchange.descriptions import read_description
from kindsl.robots.interchange.format import AS_WRITTEN
from kindsl.robots.interchange.registry import format_named, format_of_suffix

DOCUMENTS = Path(__file__).parent / "documents"


@pytest.mark.parametrize("name", ["floating.urdf", "floating.sdf"])
def test_in_another_encoding_nothing_has_a_place(name: str, tmp_path: Path) -> None:
    text = (DOCUMENTS / name).read_text("utf-8")
    path = tmp_path / name
    path.write_bytes(f'<?xml version="1.0" encoding="utf-16"?>\n{text}'.encode("utf-16"))
    found, plain = (read_description(each, name, None).robot for each in (path, DOCUMENTS / name))
    assert found.skeleton == plain.skeleton
    numbers = [number for parts in found.inertias for part in parts for number in part.numbers]
    assert set(numbers) == {None}


def test_what_mujoco_alone_can_read_has_no_places(tmp_path: Path) -> None:
    text = (DOCUMENTS / "floating.xml").read_text("utf-8").replace("craft", "a<b")
    path = tmp_path / "robot.xml"
    path.write_text(text)
    robot = read_description(path, "robot", None).robot
    assert robot.skeleton.link_names == ("leg",)
    assert {number for joint in robot.joints for number in joint.numbers} == {None}


def test_a_number_that_a_document_type_gives_has_no_place() -> None:
    text = (DOCUMENTS / "legged.urdf").read_text("utf-8").replace(' value="3"', "")
    text = f'<!DOCTYPE robot [<!ATTLIST mass value CDATA "3">]>\n{text}'
    urdf = format_named("urdf")
    found = urdf.find_numbers(text).found
    assert ("link", "trunk", "mass") not in found
    assert found["link", "trunk", "Ix"].value == 0.3


@pytest.mark.parametrize("name", ["fixed.urdf", "nested.sdf", "fixed.xml"])
def test_a_number_that_is_none_has_no_value(name: str) -> None:
    text = (DOCUMENTS / name).read_text("utf-8").replace("1.25", "1.25kg")
    found = format_of_suffix(Path(name).suffix).find_numbers(text).found["link", "upper", "mass"]
    assert (found.text, found.value != found.value, found.half) == ("1.25kg", True, 0.0)
    assert isinstance(found.at, TextPlace)
    assert text[found.at.start : found.at.end] == "1.25kg"


@pytest.mark.parametrize("format", ["urdf", "sdf", "mjcf"])
@pytest.mark.parametrize("text", ["", "no xml", "<r/>", "<sdf><model/></sdf>"])
def test_what_is_no_robot_has_no_numbers(format: str, text: str) -> None:
    assert format_named(format).find_numbers(text) == ({}, {})


def test_bytes_are_read_as_the_text_that_they_are(tmp_path: Path) -> None:
    text = (DOCUMENTS / "fixed.urdf").read_text("utf-8")
    urdf = format_named("urdf")
    assert urdf.find_numbers(text) == urdf.find_numbers(text.encode())
    assert read(text, urdf, tmp_path).robot == urdf.parse(text, "robot", AS_WRITTEN).robot
