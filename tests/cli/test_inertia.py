"""`kindsl inertia` prints a block; what it noticed goes to stderr."""

from io import BytesIO, TextIOWrapper
from pathlib import Path

import pytest
from tests.cad.test_meshes import as_binary, box
from tests.cad.test_reports import FOLDER, REPORTS
from tests.cad.test_sentences import ON_AXIS
from tests.cli.conftest import Runner

REPORT = str(FOLDER / "SolidWorks_upper_arm.txt")
DOCUMENT = """Robot arm {
RobotBase ground { children { upper via shoulder } }
link upper {
    id = 1
    inertia_properties {
        mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix=0.1 Iy=0.1 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0
    }
    children {}
    frames { cad { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } }
}
r_joint shoulder { ref_frame { translation = (0.0, 0.0, 1.0) rotation = (0.0, 0.0, 0.0) } }
}
"""


def test_a_report_is_printed_as_a_block(kindsl: Runner) -> None:
    run = kindsl("inertia", REPORT)
    assert (run.status, run.err) == (0, "")
    assert run.out.startswith("inertia_params {\n    mass = ") and run.out.endswith("}\n")


def test_stdin_is_read(kindsl: Runner, monkeypatch: pytest.MonkeyPatch) -> None:
    content = BytesIO(REPORTS["SolidWorks_upper_arm"].encode())
    monkeypatch.setattr("sys.stdin", TextIOWrapper(content))
    assert kindsl("inertia", "-").out == kindsl("inertia", REPORT).out


def test_an_unproved_sign_is_a_note(kindsl: Runner, folder: Path) -> None:
    (folder / "report.txt").write_text(ON_AXIS.format(notation=""))
    run = kindsl("inertia", "report.txt")
    assert run.status == 0 and "Ixy = 0.0030" in run.out
    assert "report.txt: note: the sign of the products is unproved" in run.err


def test_a_contradiction_leaves_nothing_written(kindsl: Runner, folder: Path) -> None:
    (folder / "report.txt").write_text(ON_AXIS.format(notation="").replace("Iyx = 0", "Iyx = 1"))
    run = kindsl("inertia", "report.txt")
    assert (run.status, run.out) == (1, "")
    assert run.err == "report.txt: error: Ixy is 0.0030, but Iyx is 1.0030\n"


def test_what_is_no_report_or_no_file(kindsl: Runner, folder: Path) -> None:
    (folder / "report.txt").write_text("A text.")
    assert kindsl("inertia", "report.txt").status == 2
    assert kindsl("inertia", "absent.txt").status == 2


def test_squares_in_latin_1_are_read(kindsl: Runner, folder: Path) -> None:
    text = REPORTS["Onshape_finger"].replace("m³", "m^3")
    (folder / "report.txt").write_bytes(text.encode("latin-1"))
    assert kindsl("inertia", "report.txt").status == 0


def test_a_shape_is_printed(kindsl: Runner) -> None:
    run = kindsl("inertia", "--box", "0.04,0.04,0.3", "--density", "2700")
    assert run.status == 0 and "mass = 1.296\n" in run.out and "Ix = 0.0098928\n" in run.out


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ((), "give one of REPORT"),
        (("--sphere", "0.1"), "either --mass or --density"),
        (("--sphere", "0.1", "--mass", "1", "--density", "1"), "either --mass or --density"),
        (("--sphere", "0.1", "--box", "1,1,1", "--mass", "1"), "give one of REPORT"),
        ((REPORT, "--mass", "1"), "belong to a shape"),
        ((REPORT, "--link", "upper"), "must be used together"),
        ((REPORT, "--document", "arm.kindsl", "--link", "uper"), "did you mean 'upper'"),
    ],
)
def test_options_that_do_not_fit(
    kindsl: Runner, folder: Path, options: tuple[str, ...], said: str
) -> None:
    (folder / "arm.kindsl").write_text(DOCUMENT)
    run = kindsl("inertia", *options)
    assert run.status == 2 and said in run.err


def test_a_size_that_no_body_has(kindsl: Runner) -> None:
    run = kindsl("inertia", "--sphere=-0.1", "--mass", "1")
    assert run.status == 1 and "not positive" in run.err


def test_a_mesh_is_read(kindsl: Runner, folder: Path) -> None:
    (folder / "part.stl").write_bytes(as_binary(box()))
    run = kindsl("inertia", "--stl", "part.stl", "--mass", "3")
    assert run.status == 0 and "CoM = (0.25, 0.125, 1.0)" in run.out
    (folder / "part.stl").write_bytes(as_binary(box()[1:]))
    run = kindsl("inertia", "--stl", "part.stl", "--mass", "3")
    assert run.status == 1 and "part.stl: error: the mesh is not closed" in run.err


def test_a_document_gives_keyword_and_frame(kindsl: Runner, folder: Path) -> None:
    (folder / "arm.kindsl").write_text(DOCUMENT)
    text = REPORTS["SolidWorks_upper_arm"].replace("-- default --", "cad")
    (folder / "report.txt").write_text(text)
    run = kindsl("inertia", "report.txt", "--document", "arm.kindsl", "--link", "upper")
    assert run.out.startswith("inertia_properties {") and "    ref_frame = cad\n" in run.out
    assert run.err == ""
