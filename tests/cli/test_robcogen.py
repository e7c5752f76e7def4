"""RobCoGen's classes from the command line, and the transforms document made for them."""

import re
import sys
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.support.robots import LIFT

from kindsl.language.syntax.transforms_text import read_transforms
from kindsl.products.codegen.robcogen.files import RUNTIME
from kindsl.products.codegen.robcogen.robot import templates


@pytest.fixture
def document(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "arm.kindsl"
    path.write_text(LIFT)
    return path


GENERATE = ("generate", "arm.kindsl", "--language", "robcogen", "-o", "out")


def test_every_header_has_its_name(kindsl: Runner, document: Path) -> None:
    assert kindsl(*GENERATE).status == 0
    names = """
        CMakeLists.txt declarations.h default_dynparams_getter.h dynamics_parameters.h
        forward_dynamics.h forward_dynamics.impl.h inertia_properties.h inertia_properties.impl.h
        inverse_dynamics.h inverse_dynamics.impl.h jacobians.h jacobians.impl.h joint_data_map.h
        jsim.h jsim.impl.h kinematics_parameters.h kindsl-generated.json link_data_map.h
        miscellaneous.cpp miscellaneous.h traits.h transforms.h transforms.impl.h
    """
    assert sorted(path.name for path in Path("out").iterdir()) == sorted(names.split())
    assert kindsl("generate", "arm.kindsl", "--check", "out").status == 0


def test_the_runtime_comes_along_and_goes(kindsl: Runner, document: Path) -> None:
    assert kindsl(*GENERATE, "--runtime").status == 0
    shared = {path.relative_to(RUNTIME) for path in RUNTIME.rglob("*.h")}
    found = {path.relative_to("out") for path in Path("out").rglob("iit/**/*.h")}
    assert found == shared
    assert kindsl("generate", "arm.kindsl", "--check", "out").status == 0
    assert kindsl(*GENERATE).status == 0
    assert not list(Path("out").rglob("iit/**/*.h"))


def test_a_layout_has_the_folders_that_programs_include(kindsl: Runner, document: Path) -> None:
    assert kindsl(*GENERATE, "--layout", "robcogen", "--runtime").status == 0
    assert Path("out/iit/robots/arm/traits.h").is_file()
    assert Path("out/iit/rbd/rbd.h").is_file()
    told = Path("out/kindsl-generated.json").read_text()
    assert "--layout robcogen --runtime" in told
    assert kindsl("generate", "arm.kindsl", "--check", "out").status == 0


def test_names_stand_in_the_namespace_and_files_that_a_project_has(
    kindsl: Runner, document: Path
) -> None:
    options = ("--layout", "robcogen-0.5", "--namespace", "pronto::arm", "--sources")
    assert kindsl(*GENERATE, *options).status == 0
    found = {path.stem for path in Path("out").glob("*.cpp")}
    assert found == {
        "transforms", "jacobians", "jsim", "inverse_dynamics", "forward_dynamics",
        "inertia_properties", "miscellaneous",
    }  # fmt: skip
    for path in Path("out").glob("*.h"):
        text = path.read_text()
        assert path.name == "model_constants.h" or "namespace pronto {\nnamespace arm {" in text
        assert "iit::Arm" not in text and "IIT_ROBOT_PRONTO_ARM" in text
    assert kindsl("generate", "arm.kindsl", "--check", "out").status == 0


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("", "--namespace: '' is not a valid name in C++"),
        ("::a", "--namespace: '' is not a valid name in C++"),
        ("a::class", "--namespace: 'class' is a name that is taken in C++"),
        ("a-b", "--namespace: 'a-b' is not a valid name in C++"),
        ("a::iit::b", "--namespace: 'a::iit::b' would hide names of the headers 'iit/rbd'"),
    ],
)
def test_a_namespace_that_cannot_be_is_refused(
    given: str, message: str, kindsl: Runner, document: Path
) -> None:
    told = kindsl(*GENERATE, "--namespace", given)
    assert (told.status, message in told.err) == (2, True)
    assert not Path("out").exists()


def test_no_frames_are_none(kindsl: Runner, document: Path) -> None:
    assert kindsl(*GENERATE, "--frames", "").status == 0
    assert "_J_" not in Path("out/jacobians.h").read_text()
    pairs = set(re.findall(r"class Type_(\w+)", Path("out/transforms.h").read_text()))
    assert len(pairs) == 2 * LIFT.count("_joint ")
    assert kindsl("generate", "arm.kindsl", "--check", "out").status == 0
    for language in ("c", "python"):
        done = kindsl(
            "generate", "arm.kindsl", "--language", language, "--frames", "", "-o", language
        )
        assert done.status == 0, done.err


def test_files_do_not_tell_the_folder_that_they_are_in(kindsl: Runner, document: Path) -> None:
    for language in ("robcogen", "c", "python", "octave"):
        folders = [f"{language}/one", f"{language}/deeper/two"]
        for folder in folders:
            assert (
                kindsl("generate", "arm.kindsl", "--language", language, "-o", folder).status == 0
            )
        one, two = ({p.name: p.read_bytes() for p in Path(f).iterdir()} for f in folders)
        assert one == two
        assert any(b"may use it under any terms" in text for text in one.values())


def test_the_document_that_is_used_can_be_written_and_edited(
    kindsl: Runner, document: Path
) -> None:
    assert kindsl("generate", "arm.kindsl", "--write-transforms", "mine.dtdsl").status == 0
    text = Path("mine.dtdsl").read_text()
    made = read_transforms(text)
    assert not made.defects
    assert {pair.target.text for pair in made.transforms} == {"fr_upper", "fr_slider", "tool"}
    assert [pair.target.text for pair in made.jacobians] == ["tool"]
    kindsl(*GENERATE)
    before = Path("out/jacobians.h").read_text()
    kindsl(*GENERATE, "--transforms", "mine.dtdsl")
    assert Path("out/jacobians.h").read_text() == before
    Path("mine.dtdsl").write_text(text.replace("target=tool\n}\n", "target=fr_upper\n}\n"))
    kindsl(*GENERATE, "--transforms", "mine.dtdsl")
    header = Path("out/jacobians.h").read_text()
    assert "fr_base_J_fr_upper" in header and "fr_base_J_tool" not in header


def test_no_transforms_document_is_written_that_could_not_be_read(
    kindsl: Runner, document: Path
) -> None:
    document.write_text(LIFT.replace("slider", "größe"))
    told = kindsl("generate", document, "--write-transforms", "mine.dtdsl")
    assert (told.status, told.err) == (
        1,
        f"{document}: error: 'fr_größe' is not a valid name in RobCoGen's code: "
        "use letters a to z, digits and '_'\n",
    )
    assert not Path("mine.dtdsl").exists()


def test_the_base_is_chosen_by_its_name_too(kindsl: Runner, document: Path) -> None:
    for frame in ("base", "fr_base"):
        assert kindsl(*GENERATE, "--frames", frame).status == 0
        assert "fr_base_J_tool" in Path("out/jacobians.h").read_text()


def test_a_transforms_document_is_not_overwritten(kindsl: Runner, document: Path) -> None:
    Path("mine.dtdsl").write_text("mine")
    told = kindsl("generate", "arm.kindsl", "--write-transforms", "mine.dtdsl")
    assert (told.status, Path("mine.dtdsl").read_text()) == (2, "mine")
    assert "mine.dtdsl" in told.err and "--force overwrites it" in told.err


@pytest.mark.parametrize(
    ("options", "why"),
    [(("--layout", "robcogen"), "--layout has no effect without --language"),
     (("-o", "out"), "--output has no effect without --language"),
     (("--frames", "tool"), "--frames cannot be used with --write-transforms"),
     (("--language", "robcogen", "-o", "out", "--frames", ""),
      "--frames cannot be used with --write-transforms")],
)  # fmt: skip
def test_a_written_transforms_document_has_all_pairs(
    options: tuple[str, ...], why: str, kindsl: Runner, document: Path
) -> None:
    told = kindsl("generate", "arm.kindsl", "--write-transforms", "mine.dtdsl", *options)
    assert (told.status, told.err) == (2, f"kindsl generate: error: {why}\n")
    assert not Path("mine.dtdsl").exists()


def test_frames_of_joints_are_frames(kindsl: Runner, document: Path) -> None:
    text = "Robot Arm\nFrames { fr_lift, fr_slider, tool }\nTransforms { fr_lift <- tool }\n"
    Path("arm.dtdsl").write_text(f"{text}Jacobians {{ fr_slider <- fr_lift }}\n")
    assert kindsl(*GENERATE).status == 0
    assert "Type_fr_lift_X_tool fr_lift_X_tool;" in Path("out/transforms.h").read_text()
    assert kindsl("lint", "arm.dtdsl").status == 0
    assert kindsl(*GENERATE, "--frames", "fr_lift").status == 0
    assert "Type_fr_lift_X_tool fr_lift_X_tool;" in Path("out/transforms.h").read_text()
    given = ("--language", "python", "--frames", "fr_slider", "-o", "module")
    assert kindsl("generate", "arm.kindsl", *given).status == 0
    assert "jacobian_slider" in Path("module/arm.py").read_text()


@pytest.mark.parametrize("language", ["robcogen", "octave", "python"])
def test_a_chosen_frame_without_pairs_is_refused_where_it_has_nothing_else(
    language: str, kindsl: Runner, document: Path
) -> None:
    text = "Robot Arm\nFrames { fr_base, tool }\nTransforms { fr_base <- tool }\n"
    Path("arm.dtdsl").write_text(text)
    given = ("--language", language, "--frames", "tool,fr_slider")
    told = kindsl("generate", "arm.kindsl", "-o", "out", *given)
    message = "--frames: no pair of the transforms document has the frame 'fr_slider'"
    if language != "python":
        assert (told.status, told.err) == (1, f"arm.kindsl: error: {message}\n")
    else:
        assert told.status == 0


@pytest.mark.parametrize("language", ["robcogen", "python"])
def test_frames_can_be_chosen(language: str, kindsl: Runner, document: Path) -> None:
    assert kindsl(*GENERATE, "--language", language, "--frames", "fr_slider").status == 0
    text = "".join(path.read_text() for path in Path("out").glob("*[hy]"))
    found = ("base_X_tool", "base_X_fr_slider") if language == "robcogen" else (
        "jacobian_tool", "jacobian_slider"
    )  # fmt: skip
    assert [name in text for name in found] == [False, True]
    told = kindsl(*GENERATE, "--frames", "fr_slidr")
    assert told.status == 1
    assert "--frames: the robot has no frame 'fr_slidr'; did you mean 'fr_slider'?" in told.err


@pytest.mark.parametrize("language", ["robcogen", "c"])
def test_cmake_carries_the_robots_version(language: str, kindsl: Runner, document: Path) -> None:
    generate = ("generate", "arm.kindsl", "--language", language, "-o", "out")
    assert kindsl(*generate).status == 0
    assert " VERSION 1.0.0 " in Path("out/CMakeLists.txt").read_text()
    Path("kindsl.toml").write_text('version = "2.1"\n[[document]]\npath = "a*"\nversion = "3"\n')
    assert kindsl(*generate).status == 0
    assert " VERSION 3 " in Path("out/CMakeLists.txt").read_text()
    Path("kindsl.toml").write_text('version = "v2"\n')
    told = kindsl(*generate)
    assert told.status == 2
    assert "version 'v2' is not up to four numbers with dots, as '1.2.0'" in told.err


def test_a_missing_template_engine_is_told_with_what_installs_it(
    kindsl: Runner, document: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    templates.cache_clear()
    monkeypatch.setitem(sys.modules, "jinja2", None)
    done = kindsl(*GENERATE)
    assert done.status == 2
    assert "jinja2 is not installed: pip install 'kindsl[robcogen]'" in done.err
    assert kindsl("generate", "arm.kindsl", "--language", "cpp", "-o", "cpp").status == 0
