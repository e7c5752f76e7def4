"""The costs of repairs: each row of the table decides how its slip is told of."""

from collections.abc import Iterator
from typing import NamedTuple

import pytest
from tests.support.mutants import messages

from kindsl.language.syntax.document import parse
from kindsl.language.syntax.recovery.costs import COSTS

ARM = """Robot arm {

RobotBase ground {
    children { upper via shoulder }
}

link upper {
    id = 1
    inertia_params {
        mass = 1.0
        CoM = (0.0, 0.0, 0.1)
        Ix = 0.1
        Iy = 0.2
        Iz = 0.3
        Ixy = 0.0
        Ixz = 0.0
        Iyz = 0.0
    }
    children { lower via elbow }
    frames {
        tip {
            translation = (l1, 0.0, 0.1)
            rotation = (0.0, -PI/2.0, 0.0)
        }
    }
}

link lower {
    id = 2
    children {}
}

r_joint shoulder {
    ref_frame {
        translation = (0.0, 0.0, 0.1)
        rotation = (0.0, 0.0, 0.0)
    }
}

r_joint elbow {
    ref_frame {
        translation = (0.0, 0.0, 0.1)
        rotation = (0.0, 0.0, 0.0)
    }
}

}
"""


class Reason(NamedTuple):
    """The slip that a cost is for.

    Attributes:
        usual: The amount for a case like any other.
        right: Some correct text.
        slip: The same with a mistake.
        message: The message, a different one with the usual amount.
    """

    usual: float
    right: str
    slip: str
    message: str


_HALF_A_LINK = """(l1, 0.0, 0.1)
            rotation = (0.0, -PI/2.0, 0.0)
        }
    }
}
"""
REASONS = {
    "go back by a token": Reason(0.0,
        "r_joint elbow {\n    ref_frame {", "r_joint elbow {\n",
        "expected 'ref_frame' after '{'"),
    "insert a value": Reason(1.0,
        "CoM = (0.0, 0.0, 0.1)", "CoM = (0.0 0.0, , 0.1)",
        "expected ',' after '0.0'"),
    "insert a word": Reason(1.0,
        "Iy = 0.2", "foo = 0.2",
        "expected 'Iy' instead of 'foo'"),
    "insert on, factor": Reason(1.0,
        "children { lower via elbow }", "lower via elbow }",
        "expected 'children' after '}'"),
    "insert a present section, more": Reason(0.0,
        "Ix = 0.1", "= 0.1",
        "expected 'Ix' after ')'"),
    "insert '(' in a value, more": Reason(0.0,
        "rotation = (0.0, -PI/2.0, 0.0)", "rotation = (PI/-PI/2.0)",
        "expected ',' after '2.0'"),
    "close at the end": Reason(1.0,
        _HALF_A_LINK, "(",
        "expected a number after '('"),
    "delete an odd character": Reason(1.0,
        "via shoulder }", "via shoulder ~ }",
        "unexpected '~'"),
    "delete '='": Reason(1.0,
        "Ixy = 0.0", "- = 0.0",
        "expected 'Ixy' instead of '-'"),
    "delete on": Reason(1.0,
        "CoM = (", "CoM = 1.0\n        CoM = (",
        "unexpected '1.0'"),
    "delete what is doubled, more": Reason(0.0,
        "translation = (l1", "translation = ((l1",
        "unexpected '('"),
    "delete the only section, more": Reason(0.0,
        "Ixz = 0.0", "Ixz / 0.0",
        "expected '=' instead of '/'"),
    "replace": Reason(1.0,
        "translation = (l1", "= translation (l1",
        "unexpected '='"),
    "replace an odd character": Reason(1.25,
        "upper via shoulder", "# via shoulder",
        "expected a name instead of '#'"),
    "replace '=' by a value": Reason(1.25,
        "CoM = (0.0", "= CoM (0.0",
        "unexpected '='"),
    "replace by no value, more": Reason(0.0,
        "id = 1\n    inertia_params {", "id =",
        "expected a whole number after '='"),
    "replace by a present section, more": Reason(0.0,
        "translation = (l1", "= translation (l1",
        "unexpected '='"),
    "replace by a lacking section, more": Reason(0.0,
        "children {}", "( {}",
        "expected 'children' instead of '('"),
    "replace by a near word, more": Reason(0.0,
        "r_joint shoulder {\n    ref_frame {\n        translation",
        "r_joint {\n    ref_frame {\n        translaIion",
        "expected a name after 'r_joint'"),
    "read further, slack": Reason(0.0,
        "-PI/2.0, 0.0)", "=-PI/2.0, 0.0)",
        "unexpected '='"),
    "read to the end, slack": Reason(0.65,
        "rotation = (0.0, -PI", "rotation -PI",
        "expected '=' after 'rotation'"),
    "believe a keyword": Reason(0.0,
        "elbow {\n    ref_frame {", "elbow {\n    frames {",
        "expected 'ref_frame' instead of 'frames'"),
    "believe a section": Reason(1.0,
        "link lower {", "r_joint lower {",
        "expected 'link' instead of 'r_joint'"),
    "believe frames": Reason(2.0,
        "elbow {\n    ref_frame {", "elbow {\n    frames {",
        "expected 'ref_frame' instead of 'frames'"),
}  # fmt: skip


def told(text: str) -> Iterator[str]:
    return (message for _, _, message in messages(parse(text)))


def test_the_arm_is_correct() -> None:
    assert [*told(ARM)] == []


def test_each_cost_has_a_reason() -> None:
    assert {*REASONS} == {*COSTS}


@pytest.mark.parametrize("name", REASONS)
def test_each_cost_is_needed_for_its_slip(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    row = REASONS[name]
    text = ARM.replace(row.right, row.slip, 1)
    assert [*told(text)] == [row.message]
    monkeypatch.setitem(COSTS, name, row.usual)
    assert [*told(text)] != [row.message]
