"""Files of meshes: found as descriptions name them, never outside the folder."""

import os
from pathlib import Path

import pytest

from kindsl.robots.interchange import mesh_files
from kindsl.robots.interchange.mesh_files import MeshFile, mesh_file, package_of
from kindsl.robots.interchange.urdf.visuals import visuals_of_urdf


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """Return a package of the usual layout, with a secret beside it."""
    for name in ("arm/urdf", "arm/meshes"):
        (tmp_path / name).mkdir(parents=True)
    (tmp_path / "arm/package.xml").write_text("<package/>")
    (tmp_path / "arm/urdf/arm.urdf").write_text("<robot/>")
    (tmp_path / "arm/meshes/a b.stl").write_text("solid")
    (tmp_path / "arm/meshes/notes.txt").write_text("text")
    (tmp_path / "secret.stl").write_text("solid")
    return tmp_path / "arm"


def found(package: Path, address: str) -> tuple[str, bytes | None]:
    description = package / "urdf/arm.urdf"
    file = mesh_file(address, description, package_of(description))
    return file.problem(), file.read()


@pytest.mark.parametrize(
    "address",
    [
        "package://arm/meshes/a%20b.stl",
        "package:///arm/meshes/a b.stl",
        "../meshes/a b.stl",
        " package://arm/meshes/a b.stl ",
    ],
)
def test_a_mesh_is_found_in_the_package(package: Path, address: str) -> None:
    assert found(package, address) == ("", b"solid")


def test_a_file_is_found_by_its_whole_path(package: Path) -> None:
    assert found(package, f"file://{package}/meshes/a b.stl") == ("", b"solid")


@pytest.mark.parametrize(
    ("address", "problem"),
    [
        ("package://arm/../secret.stl", "outside 'arm'"),
        ("../../secret.stl", "outside 'arm'"),
        ("../%2e%2e/secret.stl", "outside 'arm'"),
        ("file:///etc/passwd", "outside 'arm'"),
        ("//host/share/x.stl", "outside 'arm'"),
        ("http://example.org/x.stl", "not found in 'arm'"),
        ("package://other/x.stl", "not found in 'arm'"),
        ("package://arm/meshes", "not found in 'arm'"),
        ("package://arm/meshes/notes.txt", "neither STL, OBJ nor COLLADA"),
        ("package://arm/meshes/\0.stl", "not found in 'arm'"),
        ("package://", "not found in 'arm'"),
    ],
)
def test_nothing_else_is_read(package: Path, address: str, problem: str) -> None:
    assert found(package, address) == (problem, None)


def test_a_link_that_leads_out_is_refused_also_if_it_is_made_later(package: Path) -> None:
    outside, mesh = package.parent / "secret.stl", package / "meshes/later.stl"
    mesh.write_text("solid")
    file = mesh_file("../meshes/later.stl", package / "urdf/arm.urdf", package)
    assert file.read() == b"solid"
    mesh.unlink()
    mesh.symlink_to(outside)
    assert (file.problem(), file.read()) == ("outside 'arm'", None)
    (package / "all").symlink_to(package.parent)
    assert found(package, "package://arm/all/secret.stl") == ("outside 'arm'", None)


def test_a_pipe_and_a_file_too_large_are_refused(
    package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    os.mkfifo(package / "meshes/pipe.stl")
    assert found(package, "package://arm/meshes/pipe.stl") == ("not found in 'arm'", None)
    monkeypatch.setattr(mesh_files, "LARGEST", 2)
    assert found(package, "../meshes/a b.stl") == ("larger than 0 MB", None)


def test_a_file_may_be_as_large_as_the_limit(
    package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mesh = package / "meshes/a b.stl"
    file = mesh_file("../meshes/a b.stl", package / "urdf/arm.urdf", package)
    for size, problem in ((64 * 2**20, ""), (64 * 2**20 + 1, "larger than 64 MB")):
        os.truncate(mesh, size)
        assert file.problem() == problem
    mesh.write_text("solid")
    monkeypatch.setattr(mesh_files, "LARGEST", 5)
    assert file.read() == b"solid"


def test_the_addresses_of_a_mesh_are_tried_in_turn(package: Path) -> None:
    """A folder of all packages has the package in it, and that of the package what is in it."""
    description = package / "urdf/arm.urdf"
    around = package.parent
    assert mesh_file("package://arm/meshes/a b.stl", description, around).path == (
        around / "arm/meshes/a b.stl"
    )
    for name, where in (("arm", "arm"), ("other", "arm/other")):
        file = mesh_file(f"package://{name}/none.stl", description, package)
        assert file.path == around / where / "none.stl"
    (package / "meshes/x.stl").symlink_to("a b.stl")
    inner = mesh_file("package://other/meshes/x.stl", description, package)
    assert (inner.path, inner.read()) == (package / "meshes/x.stl", b"solid")


def test_a_file_that_grows_while_it_is_read_is_left_out(
    package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(MeshFile, "problem", lambda _: "")
    assert found(package, "../meshes/a b.stl")[1] is not None
    monkeypatch.setattr(mesh_files, "LARGEST", 2)
    assert found(package, "../meshes/a b.stl")[1] is None


def test_the_folder_is_the_package_else_where_the_description_is(package: Path) -> None:
    assert package_of(package / "urdf/arm.urdf") == package
    (package / "package.xml").unlink()
    assert package_of(package / "urdf/arm.urdf") == package / "urdf"


def test_visuals_are_read_with_their_sizes_and_broken_ones_left_out() -> None:
    visual = '<visual><origin xyz="0 0 1"/><geometry>{}</geometry></visual>'
    shapes = (
        '<box size="1 2 3"/>',
        '<cylinder radius="1" length="2"/>',
        '<sphere radius="0.5"/>',
        '<mesh filename="a.stl" scale="0.001 0.001 0.001"/>',
        '<mesh filename="b.dae"/>',
        '<box size="1 2"/>',
        "<mesh/>",
        "<capsule/>",
    )
    drawn = "".join(visual.format(shape) for shape in shapes)
    found = visuals_of_urdf(f'<robot name="r"><link name="a">{drawn}</link></robot>')
    assert [(v.form, v.size, v.file) for v in found] == [
        ("box", (1.0, 2.0, 3.0), ""),
        ("cylinder", (1.0, 2.0), ""),
        ("sphere", (0.5,), ""),
        ("mesh", (0.001, 0.001, 0.001), "a.stl"),
        ("mesh", (1.0, 1.0, 1.0), "b.dae"),
    ]
    assert found[0].link_T_visual.translation == (0.0, 0.0, 1.0)
