"""Packages and models that are looked for in folders: which is found, and where one looks."""

import os
from pathlib import Path

import pytest

from kindsl.robots.interchange.format import FormatError, ReadingChoices
from kindsl.robots.interchange.registry import format_named
from kindsl.robots.interchange.sdf import including
from kindsl.robots.interchange.xacro import packages
from kindsl.robots.interchange.xacro.packages import package_folder


def package(folder: Path, manifest: str = "<package/>") -> Path:
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(manifest)
    return folder


def test_a_package_is_looked_for_four_folders_deep(tmp_path: Path) -> None:
    deep = package(tmp_path / "a/b/c/deep")
    package(tmp_path / "a/b/c/d/deeper")
    assert package_folder("deep", [tmp_path]) == deep
    assert package_folder("deeper", [tmp_path]) is None


def test_a_package_hides_what_is_in_it_and_so_do_folders_of_programs(tmp_path: Path) -> None:
    outer = package(tmp_path / "outer", "<package><name> leg </name></package>")
    package(outer / "inner")
    for skipped in ("build", "log", "node_modules", "__pycache__", ".git"):
        package(tmp_path / skipped / "inner")
    assert package_folder("leg", [tmp_path]) == package_folder("leg", [outer]) == outer
    assert package_folder("inner", [tmp_path]) is None
    assert package_folder("inner", [tmp_path / "build"]) == tmp_path / "build" / "inner"


@pytest.mark.parametrize("manifest", ["<package/>", "<package><name/></package>", "no xml"])
def test_a_package_without_a_name_has_its_folders(tmp_path: Path, manifest: str) -> None:
    assert package_folder("leg", [tmp_path]) is None
    folder = package(tmp_path / "src" / "leg", manifest)
    assert package_folder("leg", [tmp_path]) == folder


def test_packages_are_looked_for_near_the_file_then_where_ros_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("AMENT_PREFIX_PATH", os.pathsep.join(("/opt/ros", "", "/opt/ours")))
    monkeypatch.setenv("ROS_PACKAGE_PATH", "/src")
    told = [Path("/opt/ros/share"), Path("/opt/ours/share"), Path("/src")]
    file, given = tmp_path / "leg" / "urdf" / "leg.xacro", (tmp_path / "given", Path("/src"))
    found = packages.searched_folders(file, given)
    assert found == [*given, tmp_path / "leg" / "urdf", *told[:2]]
    own = package(tmp_path / "leg")
    assert packages.searched_folders(file, ()) == [own, tmp_path, *told]


def test_models_are_looked_for_near_the_file_then_where_gazebo_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for variable in ("SDF_PATH", "GZ_SIM_RESOURCE_PATH", "GAZEBO_MODEL_PATH"):
        monkeypatch.setenv(variable, os.pathsep.join((f"/{variable}", "", "/all")))
    file = tmp_path / "robots" / "arm.sdf"
    found = including.searched_folders(file, [tmp_path / "given"])
    told = [Path(p) for p in ("/SDF_PATH", "/all", "/GZ_SIM_RESOURCE_PATH", "/GAZEBO_MODEL_PATH")]
    assert found == [tmp_path / "given", tmp_path / "robots", tmp_path, *told]


ROBOT = """<sdf version="1.9"><model name="arm">
<joint name="weld" type="fixed"><parent>world</parent><child>{own}::a</child></joint>
<include><uri>{uri}</uri>{more}</include></model></sdf>"""
MODEL = """<sdf version="1.9"><model name="own"><pose>0 0 1 0 0 0</pose>
<link name="a"/><link name="b"/><frame name="f" attached_to="a"><pose>0 1 0 0 0 0</pose></frame>
<joint name="j" type="revolute"><parent>a</parent><child>b</child></joint></model></sdf>"""


def included(folder: Path, uri: str, more: str = "", own: str = "own") -> tuple[float, ...]:
    """Return where the base of a model is that another one includes."""
    path = folder / "robot.sdf"
    path.write_text(ROBOT.format(uri=uri, more=more, own=own))
    choices = ReadingChoices(model_paths=(folder / "models",))
    robot = format_named("sdf").read(path, choices).robot
    return robot.bodies[0].parts[0].pose.translation


@pytest.mark.parametrize(
    "uri", ["model://leg", "package://leg", "leg", "file://leg/model.sdf", " model://leg/model.sdf"]
)
def test_a_model_is_found_by_its_address(tmp_path: Path, uri: str) -> None:
    folder = tmp_path / "models" / "leg"
    folder.mkdir(parents=True)
    (folder / "model.sdf").write_text(MODEL)
    assert included(tmp_path, uri) == (0.0, 0.0, 1.0)
    manifest = "<model><sdf>none.sdf</sdf></model>"
    (folder / "model.config").write_text(manifest)
    assert included(tmp_path, uri, "<name>ours</name>", "ours") == (0.0, 0.0, 1.0)
    assert included(tmp_path, uri, "<pose>1 2 3 0 0 0</pose>") == (1.0, 2.0, 3.0)


@pytest.mark.parametrize("uri", ["", "https://example.org/leg", "model://none", "model://empty"])
def test_a_model_that_is_not_found_is_told_with_its_line(tmp_path: Path, uri: str) -> None:
    for name in ("empty", "https:/example.org/leg"):
        (tmp_path / "models" / name).mkdir(parents=True)
    for name in ("https:/example.org/leg", ""):
        (tmp_path / "models" / name / "model.sdf").write_text(MODEL)
    message = f"line 3: <include> names '{uri}', which is in none of {tmp_path / 'models'}, "
    with pytest.raises(FormatError) as caught:
        included(tmp_path, uri)
    assert str(caught.value).startswith(message)
    how = ": add a folder to GZ_SIM_RESOURCE_PATH, or give --model-path DIR to kindsl convert"
    assert str(caught.value).endswith(how)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("no xml", ": not a readable SDF: not well-formed XML at line 1: syntax error"),
        ("<sdf/>", ": has no model"),
        (None, " cannot be read: Permission denied"),
    ],
)
def test_a_model_that_cannot_be_read_is_told_with_its_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str | None, told: str
) -> None:
    file = tmp_path / "models" / "leg.sdf"
    file.parent.mkdir()
    file.write_text(text or "")
    if text is None:

        def refuse(_: str) -> None:
            raise PermissionError(13, "Permission denied")

        monkeypatch.setattr(including, "require_regular", refuse)
    with pytest.raises(FormatError) as caught:
        included(tmp_path, "leg.sdf")
    assert str(caught.value) == f"{file}{told}"


def test_models_may_be_in_models_in_models(tmp_path: Path) -> None:
    (tmp_path / "m0.sdf").write_text(MODEL)
    for depth in range(12):
        inner = f"<model name='own'><include><uri>m{depth}.sdf</uri></include></model>"
        (tmp_path / f"m{depth + 1}.sdf").write_text(f"<sdf version='1.9'>{inner}</sdf>")
    assert included(tmp_path, "m12.sdf", own="::".join(["own"] * 13)) == (0.0, 0.0, 1.0)


def test_of_an_included_model_its_frame_and_whether_it_is_static_may_be_said(
    tmp_path: Path,
) -> None:
    folder = tmp_path / "models" / "leg"
    folder.mkdir(parents=True)
    (folder / "model.sdf").write_text(MODEL.replace("<link", "<static>0</static><link", 1))
    path = tmp_path / "robot.sdf"
    path.write_text(
        "<sdf version='1.9'><world name='w'><include><uri>model://leg</uri><static>1</static>"
        "<placement_frame> f </placement_frame></include></world></sdf>"
    )
    found = format_named("sdf").read(path, ReadingChoices(model_paths=(tmp_path / "models",)))
    assert "the model is static: its joints can move here" in found.remarks
    assert found.robot.bodies[0].parts[0].pose.translation == (0.0, -1.0, 1.0)
