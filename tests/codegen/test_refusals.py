"""What is not generated, not read and not replaced is said in one sentence."""

import json
from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.codegen.documents import DOCUMENTS
from tests.codegen.robots import PLAIN, STAMP, bodies_of_seed
from tests.support.robots import LIFT

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding, JointProperties
from kindsl.products.codegen.checking import _compiler, misfit
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.library import GenerationError, Options
from kindsl.products.codegen.manifest import (
    NAME,
    Manifest,
    read_manifest,
    refuse_foreign,
    write_files,
)
from kindsl.products.codegen.resistance import refuse_unresisted
from kindsl.products.codegen.robcogen.robot import GeneratedRobot
from kindsl.robots.interchange.generated_folder import digest
from kindsl.robots.mechanism.errors import ModelError

POSES = Options("c", ("poses",), "double", False, "unbound", "arm")
FRAMES = "Robot Arm\nFrames { fr_upper, tool }\n"
MASSLESS = LIFT.replace("mass = 2.0", "mass = 0.0").replace("mass = 1.0", "mass = 0.0")

# Farther along the first joint than any robot is.
FAR = LIFT.replace("0.0, 0.0, 0.5", "0.0, -1.7e+308, 0.5")

# One by its mass is more than the largest number.
LIGHT = LIFT.replace("mass = 2.0", "mass = 0.0").replace("mass = 1.0", "mass = 1.0e-310")


def source(text: str = LIFT, transforms: str | None = None, **settings: object) -> Source:
    return Source("arm.kindsl", kindsl.parse(text, Settings(**settings)), {}, transforms)


@pytest.mark.parametrize(
    ("given", "options", "message"),
    [
        (source(), {"quantities": ("inverse_dynamics_actuated",)},
         "none of the quantities exists for a fixed base"),
        (source(), {"quantities": ("jacobians",), "frames": ()},
         "none of the quantities exists for the frames in --frames"),
        (source(MASSLESS), {"quantities": ("poses", "center_of_mass")},
         "'center_of_mass' is not defined: the total mass is zero; "
         "use --quantities to choose others, such as poses,jacobians"),
        (source(MASSLESS), {"language": "robcogen", "parameters": "all"},
         "'forward_dynamics' is not defined: nothing resists motion of joint 'lift'"),
        (source(LIGHT), {"language": "python", "quantities": ("center_of_mass",)},
         "'center_of_mass': values of the document are too large or too small"),
        (source(LIFT.replace("mass = 1.0", "mass = 1.0e+39")),
         {"quantities": ("joint_space_inertia",), "real": "float"},
         "1e+39 is too large for 'float': use --real double"),
        (source(DOCUMENTS["reach"]), {"parameters": "reach, zzz, reech"},
         "--parameters: there is no parameter 'reech'; did you mean 'reach'?"),
        (source(), {"frames": ("upper", "fr_uper", "zzz")},
         "--frames: the robot has no frame 'fr_uper'; did you mean 'fr_upper'?"),
        (source(transforms=f"{FRAMES}Transforms {{\n  base=fr_upper, target=tol }}\n"), {},
         "transforms document, 4:25: the robot has no frame 'tol'; did you mean 'tool'?"),
        (source(transforms=f"{FRAMES}Transforms {{ base fr_upper }}\n"), {},
         "transforms document, 3:19: expected '=' instead of 'fr_upper'"),
        (source(LIFT.replace("slider", "höhe")), {"language": "octave", "parameters": "all"},
         "'fr_höhe' is not a valid name in RobCoGen's code: use letters a to z, digits and '_'"),
    ],
)  # fmt: skip
def test_one_sentence_tells_why_there_is_no_code(
    given: Source, options: dict[str, object], message: str
) -> None:
    with pytest.raises(GenerationError) as told:
        generate(given, replace(POSES, **options))
    assert str(told.value) == message


def test_a_number_that_no_robot_has_is_named() -> None:
    with pytest.raises(ModelError, match="pose of joint 'shoulder' holds a value that is beyond"):
        generate(source(FAR), POSES)


def test_a_rotor_resists_where_the_code_has_rotors() -> None:
    rotors = {name: JointProperties(armature=0.5) for name in ("shoulder", "lift")}
    driven, options = source(MASSLESS, joints=rotors), replace(POSES, quantities=PLAIN[3:8])
    assert "inverse_dynamics" in options.quantities
    assert "forward_dynamics" in generate(driven, options)[0].functions
    with pytest.raises(GenerationError, match="nothing resists motion of joint"):
        generate(driven, replace(options, language="robcogen", parameters="all"))


def test_octave_needs_no_inertia_of_a_fixed_base() -> None:
    options = replace(POSES, language="octave", quantities=PLAIN, parameters="all")
    assert "inverseDynamics.m" in generate(source(MASSLESS), options)[1]


@pytest.mark.parametrize(
    ("quantity", "moving"),
    [("forward_dynamics", "joint '.*'"), ("contact_dynamics", "joint '.*'"),
     ("inverse_dynamics", "the base")],
)  # fmt: skip
def test_what_only_rounding_resists_is_refused(
    quantity: str, moving: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    bodies = bodies_of_seed(3)
    for condition in (1e15, np.nextafter(1e15, np.inf)):
        monkeypatch.setattr(
            "kindsl.products.codegen.resistance._condition", lambda M, told=condition: told
        )
        refuse_unresisted(("poses", "joint_space_inertia"), bodies, np.zeros(bodies.n_links))
        with (
            pytest.raises(GenerationError, match=f"'{quantity}' .* {moving}; use")
            if condition > 1e15
            else nullcontext()
        ):
            refuse_unresisted((quantity,), bodies, np.zeros(bodies.n_links))


def test_the_model_of_defaults_has_their_values() -> None:
    for value in (0.0, 2.5):
        given = source(DOCUMENTS["reach"], bindings={"reach": Binding(value)})
        library, _ = generate(given, replace(POSES, parameters="all"))
        assert library.setup_values == [value]
        assert library.is_bound


def test_a_robot_is_large_from_one_joint_more(monkeypatch: pytest.MonkeyPatch) -> None:
    library, _ = generate(source(), POSES)
    for most, is_large in ((1, True), (2, False)):
        monkeypatch.setattr("kindsl.products.codegen.robcogen.robot.MOST_JOINTS_OF_SMALL", most)
        assert GeneratedRobot(library).is_large is is_large


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder of generated code."""
    place = tmp_path / "out"
    write_files(place, generate(source(), POSES, STAMP)[1])
    return place


def test_a_manifest_is_read_as_it_was_written(folder: Path) -> None:
    given = Source("arm.kindsl", kindsl.parse(DOCUMENTS["one"]), {"m": 0.5}, f"{FRAMES}")
    options = replace(POSES, frames=("one",), layout="robcogen", has_runtime=True)
    files = generate(given._replace(transforms=None), options, STAMP)[1]
    write_files(folder, files)
    own = {name: digest(text.encode()) for name, text in files.items() if name != NAME}
    assert read_manifest(folder) == Manifest(STAMP, options, {"m": 0.5}, None, own)
    assert {path.name for path in folder.iterdir()} == set(files)
    assert read_manifest(folder / "nowhere") is None


BROKEN: list[Callable[[dict[str, object]], object]] = [
    lambda record: "[",
    lambda record: [record],
    lambda record: {k: v for k, v in record.items() if k != "files"},
    lambda record: {**record, "bindings": {"m": "many"}},
    lambda record: {**record, "files": None},
    lambda record: {**record, "options": {"language": "c", "speed": 1}},
    lambda record: {**record, "options": {**record["options"], "language": "cobol"}},
]


@pytest.mark.parametrize("broken", BROKEN)
def test_a_manifest_that_is_none(
    folder: Path, broken: Callable[[dict[str, object]], object]
) -> None:
    file = folder / NAME
    record = broken(json.loads(file.read_text()))
    file.write_text(record if isinstance(record, str) else json.dumps(record))
    for ask in (read_manifest, lambda place: refuse_foreign(place, {}),
                lambda place: misfit(source(), place)):  # fmt: skip
        with pytest.raises(GenerationError) as told:
            ask(folder)
        assert str(told.value) == f"'{file}' is not a manifest of generated code"
    write_files(folder, {"new.h": "new"})
    assert (folder / "arm.h").is_file()


def test_only_what_was_generated_and_is_as_it_was_is_replaced_or_removed(folder: Path) -> None:
    (folder / "mine.h").write_text("mine")
    (folder / "arm_poses.c").write_text("edited")
    (folder / "arm_model.c").unlink()
    refuse_foreign(folder, {NAME: "", "arm.h": "", "new.h": ""})
    for name, why in (("mine.h", "was not generated"), ("arm_poses.c", "was edited")):
        with pytest.raises(GenerationError) as told:
            refuse_foreign(folder, {"arm.h": "", name: ""})
        assert str(told.value) == f"'{folder / name}' {why}; --force overwrites it"
    write_files(folder, {"arm.h": "new", NAME: "{}"})
    found = {path.name: path.read_text() for path in folder.iterdir()}
    assert found == {"mine.h": "mine", "arm_poses.c": "edited", "arm.h": "new", NAME: "{}"}


def test_a_new_folder_is_made_and_a_file_is_none(tmp_path: Path) -> None:
    refuse_foreign(tmp_path / "new", {"arm.h": ""})
    write_files(tmp_path / "new" / "one", {"below/arm.h": "new"})
    assert (tmp_path / "new" / "one" / "below" / "arm.h").read_text() == "new"
    (tmp_path / "file").write_text("")
    with pytest.raises(GenerationError, match="file' is not a folder"):
        refuse_foreign(tmp_path / "file", {})


def test_what_is_told_of_code_that_has_no_test_program(folder: Path) -> None:
    options = replace(POSES, language="python")
    write_files(folder, generate(source(), options)[1])
    assert misfit(source(), folder) is None
    changed = source(LIFT.replace("0.5)", "0.6)"))
    assert misfit(changed, folder) == f"'arm.kindsl' has changed since '{folder}' was generated"
    (folder / NAME).write_text(
        (folder / NAME).read_text().replace('"unbound"', '"all"').replace('"poses"', '"energies"')
    )
    why = misfit(source(), folder)
    assert why is not None
    assert why.startswith(f"'{folder}' was generated by kindsl ")
    assert why.endswith(" or for other parameters")


@pytest.mark.parametrize(
    ("configured", "there", "expected"),
    [
        ("gcc -pthread", ["gcc", "cc"], ["gcc"]),
        ("gcc -pthread", ["cc"], ["cc"]),
        ("", ["cc"], ["cc"]),
        (None, ["gcc"], None),
    ],
)
def test_the_compiler_is_that_of_python_or_cc(
    configured: str | None, there: list[str], expected: list[str] | None,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    monkeypatch.setattr("sysconfig.get_config_var", lambda name: configured)
    monkeypatch.setattr("shutil.which", lambda name: name if name in there else None)
    assert _compiler() == expected
