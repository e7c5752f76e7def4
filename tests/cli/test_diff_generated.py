"""`kindsl diff` of a document and a folder of code that was generated from it, or from another."""

import json
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.cli.test_diff_mechanics import ARM

INTERFACE = Path(__file__).parents[3] / "shared" / "robcogen_interface"
PAIRS = [
    ("testIrb4600/description/testirb4600.kindsl", "testIrb4600/generated", "120.0", "inertia"),
    ("testhyq/description/test_hyq.kindsl", "testhyq/generated", "47.376", "inertia"),
]


@pytest.mark.parametrize("language", ["c", "python", "robcogen"])
def test_generated_code_has_the_numbers_it_was_made_from(
    kindsl: Runner, folder: Path, language: str
) -> None:
    Path("arm.kindsl").write_text(ARM)
    assert kindsl("generate", "arm.kindsl", "--language", language, "-o", "code").status == 0
    assert kindsl("diff", "arm.kindsl", "code").status == 0
    Path("arm.kindsl").write_text(ARM.replace("0.8", "0.9"))
    run = kindsl("diff", "arm.kindsl", "code")
    assert run.status == 1
    assert "mass of link 'lower' is 0.9 kg in arm.kindsl (line 17) and 0.8 kg in code" in run.out


@pytest.mark.parametrize("language", ["c", "python", "robcogen"])
def test_code_that_somebody_edited_is_not_said_to_be_equal(
    kindsl: Runner, folder: Path, language: str
) -> None:
    Path("arm.kindsl").write_text(ARM)
    assert kindsl("generate", "arm.kindsl", "--language", language, "-o", "code").status == 0
    file = next(f for f in sorted(Path("code").iterdir()) if "0.8" in f.read_text("utf-8")
                and f.suffix in (".c", ".h", ".py"))  # fmt: skip
    text = file.read_text("utf-8")
    file.write_bytes(text.replace("\n", "\r\n").encode())
    Path("code", "README.md").write_text("our own")
    assert kindsl("diff", "arm.kindsl", "code").status == 0
    file.write_text(text.replace("0.8", "0.9"))
    run = kindsl("diff", "arm.kindsl", "code")
    assert run.status == 2
    assert run.err.startswith(f"code: error: '{file.name}' was edited after it was generated")


@pytest.mark.parametrize(
    "manifest", ["", "[]", "{}", '{"robot": {}}', '{"robot": 1}', '{"robot": {"links": [{}]}}']
)
def test_a_manifest_that_is_none_is_said(kindsl: Runner, folder: Path, manifest: str) -> None:
    Path("arm.kindsl").write_text(ARM)
    Path("code").mkdir()
    Path("code", "kindsl-generated.json").write_text(manifest)
    run = kindsl("diff", "arm.kindsl", "code")
    assert run.status == 2
    assert run.err.startswith("code: error: 'kindsl-generated.json' ")


@pytest.mark.published
@pytest.mark.skipif(not INTERFACE.is_dir(), reason="no generated C++ of others")
@pytest.mark.parametrize(("document", "generated", "mass", "file"), PAIRS)
def test_robcogens_folder_is_read_as_text(
    kindsl: Runner, folder: Path, document: str, generated: str, mass: str, file: str
) -> None:
    text = (INTERFACE / document).read_text()
    Path("robot.kindsl").write_text(text)
    assert kindsl("diff", "robot.kindsl", INTERFACE / generated).status == 0
    Path("robot.kindsl").write_text(text.replace(mass, "99.5", 1))
    run = kindsl("diff", "robot.kindsl", INTERFACE / generated, "--output-format", "json")
    assert run.status == 1
    (found,) = json.loads(run.out)["differences"]
    assert (found["quantity"], found["old"], found["new"]) == ("mass", 99.5, float(mass))
    assert f"/{file}_properties.impl.h (line " in found["message"]


def robcogen_folder(at: Path, transform: str, inertia: str) -> None:
    """Write a folder as RobCoGen does, of a robot with one joint."""
    at.mkdir()
    (at / "link_data_map.h").write_text('out << "   base = " << x << "   arm = " << y;\n')
    (at / "joint_data_map.h").write_text('out << "   j1 = " << x;\n')
    (at / "inertia_properties.impl.h").write_text(inertia)
    (at / "transforms.impl.h").write_text(
        "iit::one::HomogeneousTransforms::Type_fr_base_X_fr_arm::Type_fr_base_X_fr_arm()\n{\n"
        "    (*this)(2,2) = 1;\n    (*this)(0,3) = 0.5;\n}\n"
        "const iit::one::HomogeneousTransforms::Type_fr_base_X_fr_arm& "
        "iit::one::HomogeneousTransforms::Type_fr_base_X_fr_arm::update(const JState& q) {\n"
        f"{transform}    return *this;\n}}\n"
    )


TURNING = """    s_q = std::sin( q(J1));
    c_q = std::cos( q(J1));
    (*this)(0,0) = c_q;
    (*this)(0,1) = - s_q;
    (*this)(1,0) = s_q;
    (*this)(1,1) = c_q;
"""
INERTIA = """    com_arm = iit::rbd::Vector3d(0.1, 0.0,- 0.02);
    tensor_arm.fill(
        1.5,
        com_arm,
        rbd::Utils::buildInertiaTensor(0.01, 2.0E-2, 0.03, 0.0, -0.003, 0.0) );
"""
ONE = """Robot one {
RobotBase base { children { arm via j1 } }
link arm {
    id = 1
    inertia_params { mass = 1.5 CoM = (0.1, 0.0, -0.02)
        Ix = 0.01 Iy = 0.02 Iz = 0.03 Ixy = 0.0 Ixz = -0.003 Iyz = 0.0 }
    children {}
}
r_joint j1 { ref_frame { translation = (0.5, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
"""


def test_an_older_folder_is_read_too(kindsl: Runner, folder: Path) -> None:
    Path("one.kindsl").write_text(ONE)
    robcogen_folder(folder / "code", TURNING, INERTIA)
    assert kindsl("diff", "one.kindsl", "code").status == 0
    Path("one.kindsl").write_text(ONE.replace("Ixz = -0.003", "Ixz = 0.003"))
    run = kindsl("diff", "one.kindsl", "code")
    assert "Ixz of link 'arm' is 0.003 kg m² in one.kindsl (line 6)" in run.out
    assert "-0.003 kg m² in code/inertia_properties.impl.h (line 5)" in run.out


@pytest.mark.parametrize("sum", ["0.75 - 0.5*0.5", "- 0.5 + 2.0*0.5", "1.0/2.0", "0.5 + q(J1)"])
def test_an_entry_is_arithmetic_on_numbers(kindsl: Runner, folder: Path, sum: str) -> None:
    Path("one.kindsl").write_text(ONE.replace("r_joint", "p_joint") if "q(" in sum else ONE)
    turning = "" if "q(" in sum else TURNING
    robcogen_folder(folder / "code", f"{turning}    (*this)(0,3) = {sum};\n", INERTIA)
    run = kindsl("diff", "one.kindsl", "code")
    assert run.status == 0, run.out


@pytest.mark.parametrize(
    ("transform", "inertia", "message"),
    [
        (TURNING, INERTIA.replace("1.5", "params->getMass()"), "depends on parameters"),
        (TURNING, INERTIA.replace("com_arm = ", "com_leg = "), "depends on parameters"),
        (TURNING.replace("- s_q", "__import__('os')"), INERTIA, "has no transform between"),
        (TURNING.replace("- s_q", "1/0"), INERTIA, "has no transform between"),
        (TURNING.replace("- s_q", "1e300*1e300"), INERTIA, "has no transform between"),
        (TURNING + "    (*this)(4,0) = 1;\n", INERTIA, "has no transform between"),
        (TURNING + "    (*this)(0,4) = 1;\n", INERTIA, "has no transform between"),
        ("", INERTIA, "has no transform between 'arm' and a parent"),
    ],
)
def test_what_is_not_numbers_alone_is_said(
    kindsl: Runner, folder: Path, transform: str, inertia: str, message: str
) -> None:
    Path("one.kindsl").write_text(ONE)
    robcogen_folder(folder / "code", transform, inertia)
    run = kindsl("diff", "one.kindsl", "code")
    assert run.status == 2
    assert message in run.err
