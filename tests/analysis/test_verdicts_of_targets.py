"""Where the generators differ from what the documents look like."""

from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings

LINK = """link %s {
    id = %d
    inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0)
        Ix=0.01 Iy=0.01 Iz=0.01 Ixy=0.0 Ixz=0.0 Iyz=0.0 %s }
    children { %s }
    frames { tip { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
"""
POSE = "ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) }"
ARM = (
    "Robot Arm {\nRobotBase ground { inertia_params { mass = 0.0 CoM = (0.0, 0.0, 0.0)\n"
    "Ix=0.0 Iy=0.0 Iz=0.0 Ixy=0.0 Ixz=0.0 Iyz=0.0 } children { upper via shoulder } }\n"
    + LINK % ("upper", 1, "%s", "lower via elbow")
    + LINK % ("lower", 2, "", "")
    + f"r_joint shoulder {{ {POSE} }}\nr_joint elbow {{ {POSE} }}\n}}\n"
)


def errors(text: str, target: str) -> list[str]:
    found = analyse(text, Settings(targets=frozenset([target]))).findings
    return [f.message for f in found if f.severity == "error"]


def test_robcogen2_refuses_a_reference_to_a_frame_that_two_links_declare() -> None:
    assert errors(ARM % "", "robcogen2") == []
    (told,) = errors(ARM % "ref_frame = tip", "robcogen2")
    assert "2 frames have the name 'tip'" in told
    assert errors(ARM % "ref_frame = tip", "robcogen") == []


def test_robcogen_reads_over_latin_1_in_a_comment() -> None:
    text = (ARM % "").replace("Robot Arm {", "Robot Arm { // K\udcf6rper")
    assert errors(text, "robcogen") == []
    assert len(errors(text, "robcogen2")) == 1
    assert errors((ARM % "").replace("tip", "t\udcf6p", 1), "robcogen") != []
