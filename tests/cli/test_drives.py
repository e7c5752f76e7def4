"""Rotors and friction that a configuration tells are in mechanics and in generated code."""

from pathlib import Path

import pytest
from tests.cli.conftest import Runner

from kindsl import load

SLIDER = """\
Robot Slider {
    RobotBase ground { children { cart via rail } }
    link cart {
        id = 1
        inertia_params {
            mass = 2.0 CoM = (0.0, 0.0, 0.0)
            Ix = 1.0 Iy = 1.0 Iz = 1.0 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0
        }
        children {}
    }
    p_joint rail { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
"""
DRIVEN = "[joints.rail]\narmature = 3.0\ndamping = 0.5\nfriction = 0.25\n"


def test_the_configuration_tells_them(kindsl_file: Path) -> None:
    """Of a cart of 2 kg with a rotor of 3 kg; friction acts against motion only."""
    cart = load(kindsl_file).mechanism()
    assert cart.joint_space_inertia([0.0]).tolist() == [[5.0]]
    assert cart.inverse_dynamics([0.0], [2.0], [1.0], None, (0.0, 0.0, 0.0)).tolist() == [6.25]
    assert cart.inverse_dynamics([0.0], [-2.0], [0.0], None, (0.0, 0.0, 0.0)).tolist() == [-1.25]
    assert cart.forward_dynamics([0.0], [0.0], [5.0], None, (0.0, 0.0, 0.0)).tolist() == [1.0]
    assert cart.kinetic_energy([0.0], [2.0]) == 10.0
    assert cart.coriolis_matrix([0.0], [2.0]).tolist() == [[0.0]]


@pytest.fixture
def kindsl_file(tmp_path: Path) -> Path:
    (tmp_path / "kindsl.toml").write_text(DRIVEN)
    document = tmp_path / "slider.kindsl"
    document.write_text(SLIDER)
    return document


@pytest.mark.parametrize("language", ["c", "cpp", "python", "casadi", "robcogen", "octave"])
def test_generated_code_has_them_unless_it_is_robcogens(
    kindsl: Runner, kindsl_file: Path, language: str
) -> None:
    """And code no longer fits its document where they have changed since."""
    out = kindsl_file.parent / "out"
    made = ("generate", str(kindsl_file), "--language", language, "-o", str(out))
    assert kindsl(*made).status == 0
    text = "".join(path.read_text() for path in sorted(out.rglob("*")) if path.is_file())
    is_rigid = language in ("robcogen", "octave")
    assert ("0.25" in text) != is_rigid
    assert kindsl("generate", str(kindsl_file), "--check", str(out)).status == 0
    (kindsl_file.parent / "kindsl.toml").write_text(DRIVEN.replace("0.25", "0.75"))
    assert kindsl("generate", str(kindsl_file), "--check", str(out)).status == (not is_rigid)
