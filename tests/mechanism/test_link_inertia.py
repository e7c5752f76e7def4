"""Inertias in link frames: of a frame that parameters place, at each of their values anew."""

import pytest

from kindsl.judgement.analysis.analysis import analyse
from kindsl.language.semantics.unknown import Unknown
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.robots.mechanism.link_inertia import link_inertia

ARM = """Robot R {
RobotBase base { children { arm via shoulder } }
link arm {
    id = 1
    inertia_params {
        mass = 2.0 CoM = (0.1, 0.0, 0.0) Ix=0.5 Iy=0.5 Iz=0.5 Ixy=0.0 Ixz=0.0 Iyz=0.0
        ref_frame = fr_com
    }
    children {}
    frames { fr_com { translation = (reach, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
r_joint shoulder { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}
"""


def test_an_inertia_moves_with_its_frame() -> None:
    (arm,) = analyse(ARM).model.links
    values: dict[str, float] = {}
    assert isinstance(link_inertia(arm, values), Unknown)
    for reach in (0.2, 0.3, 0.2):
        values["reach"] = reach
        found = link_inertia(arm, values)
        assert isinstance(found, MassDistribution)
        assert found.com == pytest.approx((0.1 + reach, 0.0, 0.0))
