"""Values of parameters that a caller gives are checked by name."""

import numpy as np
import pytest

import kindsl
from kindsl.judgement.analysis.settings import Settings
from kindsl.language.semantics.parameters import Binding

ARM = """Robot Arm {
RobotBase ground { children { upper via shoulder } }
link upper { id = 1
    inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.1)
        Ix=0.2 Iy=0.2 Iz=0.1 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children {}
}
r_joint shoulder { ref_frame {
    translation = (0.0, 0.0, upper_length) rotation = (0.0, 0.0, 0.0) } }
}
"""
SETTINGS = Settings(bindings={"upper_length": Binding(0.3, 0.1, 0.5)})


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"uper_length": 0.3}, "no parameter 'uper_length'; did you mean 'upper_length'?"),
        ({"upper_length": "0.3"}, "is str, not a number"),
        ({"upper_length": None}, "is NoneType, not a number"),
        ({"upper_length": True}, "is bool, not a number"),
        ({"upper_length": float("nan")}, "is nan, not finite"),
        ({"upper_length": np.array([0.1, 0.2])}, "is an array, not a number"),
        ({"upper_length": 0.6}, "upper_length = 0.6 is above its maximum 0.5"),
        ({"upper_length": 0.05}, "upper_length = 0.05 is below its minimum 0.1"),
    ],
)
def test_wrong_value_is_refused_by_name(given: dict[str, float], message: str) -> None:
    with pytest.raises(kindsl.ParameterValueError, match=message.replace("?", ".")):
        kindsl.parse(ARM, SETTINGS).mechanism(given)


def test_numbers_of_numpy_are_numbers() -> None:
    arm = kindsl.parse(ARM, SETTINGS).mechanism({"upper_length": np.float32(0.25)})
    assert arm.joint_names == ("shoulder",)
    assert repr(arm) == "<kindsl.Mechanism: fixed base 'ground', 1 joint>"
    assert isinstance(arm, kindsl.Mechanism)


def test_document_tells_what_it_is() -> None:
    document = kindsl.parse(ARM, SETTINGS)
    assert isinstance(document, kindsl.Document)
    assert repr(document) == "<kindsl.Document 'Arm': 1 link, 0 errors>"
