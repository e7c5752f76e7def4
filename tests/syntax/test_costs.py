"""The costs of repairs: each row of the table decides how its slip is told of."""

from collections.abc import Iterator

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


def told(text: str) -> Iterator[str]:
    return (message for _, _, message in messages(parse(text)))


def test_the_arm_is_correct() -> None:
    assert [*told(ARM)] == []


@pytest.mark.parametrize("name", COSTS)
def test_each_cost_is_needed_for_its_slip(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    row = COSTS[name]
    text = ARM.replace(row.right, row.slip, 1)
    assert [*told(text)] == [row.message]
    monkeypatch.setitem(COSTS, name, row._replace(amount=row.usual))
    assert [*told(text)] != [row.message]
