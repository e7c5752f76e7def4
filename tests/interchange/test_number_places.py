"""Places of numbers in other formats, and numbers that have none."""

from collections.abc import Callable
from pathlib import Path

import pytest
from tests.interchange.round_trips import read

from kindsl.robots.comparison.written import TextPlace
from kindsl.robots.interchange.descriptions import read_description
from kindsl.robots.interchange.format import AS_WRITTEN
from kindsl.robots.interchange.mjcf.mjcf_reading import numbers_of_mjcf
from kindsl.robots.interchange.registry import format_named
from kindsl.robots.interchange.sdf.numbers import numbers_of_sdf
from kindsl.robots.interchange.urdf.urdf_reading import numbers_of_urdf
from kindsl.robots.interchange.written_numbers import FileNumbers

DOCUMENTS = Path(__file__).parent / "documents"
FIND = {".urdf": numbers_of_urdf, ".sdf": numbers_of_sdf, ".xml": numbers_of_mjcf}


@pytest.mark.parametrize("name", ["floating.urdf", "floating.sdf"])
def test_in_another_encoding_places_are_those_of_the_text(name: str, tmp_path: Path) -> None:
    text = (DOCUMENTS / name).read_text("utf-8")
    robots = []
    for encoding in ("utf-8", "utf-16"):
        path = tmp_path / encoding / name
        path.parent.mkdir()
        path.write_bytes(f'<?xml version="1.0" encoding="{encoding}"?>\n{text}'.encode(encoding))
        robots.append(read_description(path, name, None).robot)
    one, other = ([n for parts in r.inertias for p in parts for n in p.numbers] for r in robots)
    assert robots[0].skeleton == robots[1].skeleton
    assert [n and (n.text, n.at.line) for n in other] == [n and (n.text, n.at.line) for n in one]
    assert any(one)


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
    found = numbers_of_urdf(text)
    assert ("link", "trunk", "mass") not in found
    assert found["link", "trunk", "Ix"].value == 0.3


@pytest.mark.parametrize("name", ["fixed.urdf", "nested.sdf", "fixed.xml"])
def test_a_number_that_is_none_has_no_value(name: str) -> None:
    text = (DOCUMENTS / name).read_text("utf-8").replace("1.25", "1.25kg")
    found = FIND[Path(name).suffix](text)["link", "upper", "mass"]
    assert (found.text, found.value != found.value, found.half) == ("1.25kg", True, 0.0)
    assert isinstance(found.at, TextPlace)
    assert text[found.at.start : found.at.end] == "1.25kg"


@pytest.mark.parametrize("find", FIND.values())
@pytest.mark.parametrize("text", ["", "no xml", "<r/>", "<sdf><model/></sdf>"])
def test_what_is_no_robot_has_no_numbers(find: Callable[[str], FileNumbers], text: str) -> None:
    assert find(text) == {}


def test_bytes_are_read_as_the_text_that_they_are(tmp_path: Path) -> None:
    text = (DOCUMENTS / "fixed.urdf").read_text("utf-8")
    urdf = format_named("urdf")
    assert numbers_of_urdf(text) == numbers_of_urdf(text.encode())
    assert read(text, urdf, tmp_path).robot == urdf.parse(text, "robot", AS_WRITTEN).robot


def test_lines_of_windows_and_comments_move_no_place() -> None:
    text = (DOCUMENTS / "nested.sdf").read_text("utf-8").replace("1.25<", "1.25\n<!-- 2 --><")
    plain = numbers_of_sdf(text.replace("<!-- 2 -->", ""))
    assert plain["link", "upper", "mass"].text == "1.25"
    assert ("link", "upper", "mass") not in numbers_of_sdf(text)
    windows = text.replace("<!-- 2 -->", "").replace(">", ">\r\n").replace("\n", "\r\n")
    found = numbers_of_sdf(windows)
    assert found.keys() == plain.keys()
    for number in found.values():
        assert isinstance(number.at, TextPlace)
        assert windows[number.at.start : number.at.end].split() == number.text.split()
