"""`kindsl diff` compares what can be compared, and says what it left out."""

import json
import re
from io import BytesIO, TextIOWrapper
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.comparison.trials import random_document

ARM = """Robot Arm {
RobotBase ground { children { upper via shoulder } }
link upper {
    id = 1
    inertia_params { mass = %s CoM = (0.0, 0.0, 0.1)
        Ix=0.2 Iy=0.2 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children { hand via wrist }
}
link hand {
    id = 2
    inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0)
        Ix=0.1 Iy=0.1 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children {}
}
r_joint shoulder { ref_frame { translation = (0.0, 0.0, %s) rotation = (0.0, 0.0, 0.0) } }
r_joint wrist { ref_frame { translation = (0.0, 0.0, %s) rotation = (0.0, 0.0, 0.0) } }
}
"""

TIP = "tip { translation = (0.20213, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }"


def differ(kindsl: Runner, folder: Path, old: str, new: str) -> tuple[int, dict[str, object], str]:
    (folder / "old.kindsl").write_text(old)
    (folder / "new.kindsl").write_text(new)
    run = kindsl("diff", "old.kindsl", "new.kindsl", "--output-format", "json")
    return run.status, json.loads(run.out) if run.out else {}, run.err


@pytest.mark.parametrize("mass", ["", "2.0 +", "1.0/0.0"])
def test_a_mass_that_cannot_be_read_is_not_compared(
    kindsl: Runner, folder: Path, mass: str
) -> None:
    old, new = ARM % ("2.0", "0.5", "0.3"), ARM % (mass, "0.5", "0.4")
    for pair in ((old, new), (new, old)):
        status, found, err = differ(kindsl, folder, *pair)
        assert status == 1
        assert (found["masses"], found["total_mass"]) == ([], [0.0, 0.0])
        assert [move["name"] for move in found["joint_frames"]] == ["wrist"]
        assert "the total mass and the inertia of 'upper' left out: " in err


def test_a_lost_inertia_is_not_a_mass_of_zero(kindsl: Runner, folder: Path) -> None:
    old = ARM % ("2.0", "0.5", "0.3")
    start = old.rindex("inertia_params")
    new = old[:start] + old[old.index("}", start) + 1 :]
    _, found, err = differ(kindsl, folder, old, new)
    assert (found["masses"], found["total_mass"]) == ([], [0.0, 0.0])
    assert "the total mass and the inertia of 'hand' left out: link 'hand' has no mass" in err


def test_unbound_parameter_leaves_out_what_depends_on_it(kindsl: Runner, folder: Path) -> None:
    old, new = ARM % ("2.0", "reach", "0.3"), ARM % ("3.0", "reach", "0.4")
    status, found, err = differ(kindsl, folder, old, new)
    assert status == 1
    assert [m["link"] for m in found["masses"]] == ["upper"]
    assert [m["name"] for m in found["joint_frames"]] == ["wrist"]
    assert found["zero_poses"] == []
    assert "parameter 'reach' has no value" in err
    assert found["left_out"]


def test_a_new_and_a_deleted_document(kindsl: Runner, folder: Path) -> None:
    (folder / "arm.kindsl").write_text(ARM % ("2.0", "0.2", "0.3"))
    new = kindsl("diff", "/dev/null", "arm.kindsl")
    assert (new.status, new.err) == (1, "")
    assert "link   upper     added" in new.out
    gone = kindsl("diff", "arm.kindsl", "/dev/null", "--output-format", "json")
    assert json.loads(gone.out)["removed_links"] == ["upper", "hand"]
    neither = kindsl("diff", "/dev/null", "/dev/null")
    assert (neither.status, neither.out) == (2, "")
    assert "no document to compare" in neither.err


def test_same_parametric_document_is_the_same(kindsl: Runner, folder: Path) -> None:
    text = ARM % ("payload", "reach", "0.3")
    status, found, _ = differ(kindsl, folder, text, text)
    assert (status, found["changed"]) == (0, False)


def test_duplicate_ids_are_no_hindrance(kindsl: Runner, folder: Path) -> None:
    text = ARM % ("2.0", "0.1", "0.3")
    status, found, err = differ(kindsl, folder, text.replace("id = 2", "id = 1"), text)
    assert (status, found["changed"]) == (0, False)
    assert "old.kindsl has errors: showing the rest" in err


def test_broken_document_is_compared_as_far_as_it_goes(kindsl: Runner, folder: Path) -> None:
    text = ARM % ("2.0", "0.1", "0.3")
    broken = text.replace("mass = 1.0 CoM", "mass = 1.0 CoM CoM").replace("0.3)", "0.35)")
    status, found, err = differ(kindsl, folder, broken, text)
    assert status == 1
    assert [m["name"] for m in found["joint_frames"]] == ["wrist"]
    assert "old.kindsl has errors" in err


def test_no_tree_at_all_is_refused(kindsl: Runner, folder: Path) -> None:
    status, _, err = differ(kindsl, folder, "Robot", ARM % ("2.0", "0.1", "0.3"))
    assert status == 2
    assert err.startswith("old.kindsl")


XML = '<robot name="Arm"><link/></robot>'


@pytest.mark.parametrize("is_new", [False, True])
@pytest.mark.parametrize(
    ("name", "text", "what"),
    [
        ("arm.kindsl", f"\ufeff \n{XML}", ": error: is XML, not a Kinematics-DSL document"),
        ("arm", XML, ":1:19: error: [KD001] <link> has no attribute 'name'"),
        ("-", XML, ":1:19: error: [KD001] <link> has no attribute 'name'"),
    ],
)
def test_another_format_is_not_read_as_ours(
    kindsl: Runner, folder: Path, monkeypatch: pytest.MonkeyPatch,
    name: str, text: str, what: str, is_new: bool,
) -> None:  # fmt: skip
    (folder / "own.kindsl").write_text(ARM % ("2.0", "0.5", "0.3"))
    (folder / name).write_text(text)
    monkeypatch.setattr("sys.stdin", TextIOWrapper(BytesIO(text.encode())))
    shown = "<stdin>" if name == "-" else name
    told = kindsl("diff", *(("own.kindsl", name) if is_new else (name, "own.kindsl")))
    assert (told.status, told.out) == (2, "")
    assert told.err.startswith(f"{shown}{what}")
    assert told.err.count("\n") == 1


def test_a_folder_without_generated_code_is_no_description(kindsl: Runner, folder: Path) -> None:
    (folder / "own.kindsl").write_text(ARM % ("2.0", "0.5", "0.3"))
    (folder / "code").mkdir()
    told = kindsl("diff", "own.kindsl", "code")
    assert (told.status, told.err) == (2, "code: error: no generated code in this folder\n")


def test_a_centre_of_mass_that_stays_in_the_base_has_not_moved(
    kindsl: Runner, folder: Path
) -> None:
    """Where a frame lies in its link is a convention; here the hand's is turned about z."""
    old = ARM % ("2.0", "0.5", "0.3")
    start = old.index("link hand")
    hand = old[start:].replace("CoM = (0.0, 0.0, 0.0)", "CoM = (0.1, 0.2, 0.0)", 1)
    hand = hand.replace("Ix=0.1 Iy=0.1 Iz=0.1 Ixy=0.0", "Ix=0.44 Iy=0.21 Iz=0.45 Ixy=0.02")
    old = old[:start] + hand
    turned = old.replace("(0.1, 0.2, 0.0)", "(0.2, -0.1, 0.0)")
    turned = turned.replace("Ix=0.44 Iy=0.21 Iz=0.45 Ixy=0.02", "Ix=0.21 Iy=0.44 Iz=0.45 Ixy=-0.02")
    head, _, tail = turned.rpartition("rotation = (0.0, 0.0, 0.0)")
    turned = f"{head}rotation = (0.0, 0.0, PI/2.0){tail}"
    status, found, _ = differ(kindsl, folder, old, turned)
    assert (status, found["masses"]) == (1, [])
    assert [move["name"] for move in found["zero_poses"]] == ["hand"]
    _, found, _ = differ(kindsl, folder, old, turned.replace("(0.2, -0.1", "(0.2, -0.2"))
    (change,) = found["masses"]
    assert change["com_distance"] == pytest.approx(0.1)
    _, found, _ = differ(kindsl, folder, old, old.replace("0.0, 0.0, 0.3", "0.1, 0.0, 0.3"))
    assert found["masses"] == []


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        ("mass = 2.0371", "mass = 2.04", "mass of 'upper'"),
        (
            "mass = 2.0371 CoM = (0.0, 0.0, 0.1)",
            "mass = 2.04 CoM = (0.0, 0.0, reach)",
            "mass of 'upper'",
        ),
        ("0.093138", "0.0931", "z of 'shoulder'"),
        ("0.3) rotation = (0.0", "0.3) rotation = (8e-7", "rx of 'wrist'"),
        ("0.3) rotation = (PI/2.0", "0.3) rotation = (1.571", "rx of 'wrist'"),
        ("0.3) rotation = (PI/2.0", "0.3) rotation = (1.5708", "rx of 'wrist'"),
        ("0.3) rotation = (-1.570796", "0.3) rotation = (-1.5708", "rx of 'wrist'"),
        ("tip { translation = (0.20213", "tip { translation = (0.202", "x of 'tip'"),
    ],
)
def test_a_number_with_fewer_digits_is_a_convention(
    kindsl: Runner, folder: Path, old: str, new: str, what: str
) -> None:
    text = ARM % ("2.0371", "0.093138", "0.3")
    text = text.replace("children {}", f"children {{}} frames {{ {TIP} }}")
    text = text if old in text else text.replace("0.3) rotation = (0.0", old)
    for pair in ((text, text.replace(old, new)), (text.replace(old, new), text)):
        status, found, err = differ(kindsl, folder, *pair)
        assert (status, found["changed"]) == (0, False)
        assert f"1 number with other digits: {what}" in err
        assert any("with other digits" in note for note in found["left_out"])


@pytest.mark.parametrize(
    ("old", "new"), [("2.0", "2.02"), ("2.0371", "2.05"), ("2.0", "2.1"), ("0.0", "0.0371")]
)
def test_a_number_that_is_no_rounding_is_a_change(
    kindsl: Runner, folder: Path, old: str, new: str
) -> None:
    status, found, err = differ(
        kindsl, folder, ARM % (old, "0.093138", "0.3"), ARM % (new, "0.0931", "0.3")
    )
    assert status == 1
    assert [change["link"] for change in found["masses"]] == ["upper"]
    assert (found["joint_frames"], found["zero_poses"]) == ([], [])
    assert "1 number with other digits: z of 'shoulder'" in err


@pytest.mark.parametrize("form", ["#.3g", ".4f"])
@pytest.mark.parametrize("seed", range(4))
def test_a_document_whose_numbers_are_all_rounded_is_the_same_robot(
    kindsl: Runner, folder: Path, seed: int, form: str
) -> None:
    text = random_document(seed).replace("Ixy = ", "Ixy = 0.00003471 // ", 1)
    rounded = re.sub(r"(?<![\w.])\d+\.\d+", lambda m: f"{float(m[0]):{form}}", text)
    for pair in ((text, rounded), (rounded, text)):
        status, found, err = differ(kindsl, folder, *pair)
        assert status == 0, found
        assert "with other digits" in err
