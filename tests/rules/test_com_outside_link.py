"""KD309 says what a link's length, its CoM and its radius of gyration say, in any direction."""

import numpy as np
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kindsl.analysis.analysis import analyse
from kindsl.rigid.body import MassDistribution, moments_of, shifted

DOCUMENT = """Robot R {{
RobotBase base {{ children {{ upper via shoulder }} }}
link upper {{ id = 1
    inertia_params {{ mass = 2.0 CoM = {com} {moments} }}
    children {{ hand via wrist }} }}
link hand {{ id = 2 children {{ }} }}
r_joint shoulder {{ ref_frame {{ translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }} }}
r_joint wrist {{ ref_frame {{ translation = {end} rotation = (0.0, 0.0, 0.0) }} }}
}}
"""
MASS = 2.0
NAMES = ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz")

directions = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: np.hypot(*v[:2]) > 0.1)
lengths = st.floats(-1.5, 0.0).map(lambda power: 10.0**power)
places = st.floats(-3.0, 0.5).map(lambda power: 10.0**power)
ratios = st.floats(-2.0, 2.0).map(lambda power: 10.0**power)


def document(end: np.ndarray, com: np.ndarray, radius: float) -> str:
    s = MASS * radius**2 / 3.0
    about_com = MassDistribution(MASS, tuple(com), moments_of((s, s, s, 0.0, 0.0, 0.0)))
    moments = zip(NAMES, shifted(about_com).moments, strict=True)
    return DOCUMENT.format(
        com=_triple(com), end=_triple(end), moments=" ".join(f"{n} = {v:.15f}" for n, v in moments)
    )


def _triple(vector: np.ndarray) -> str:
    return "({:.12f}, {:.12f}, {:.12f})".format(*vector)


def distance_to_link(com: np.ndarray, end: np.ndarray) -> float:
    shares = np.linspace(0.0, 1.0, 2001)
    return float(np.linalg.norm(com - shares[:, None] * end, axis=1).min())


@settings(max_examples=70, deadline=None, derandomize=True)
@given(directions, lengths, directions, places, ratios)
def test_the_mass_is_reported_where_the_link_is_not(
    along: tuple[float, ...], length: float, aside: tuple[float, ...], away: float, ratio: float
) -> None:
    end = length * np.array(along) / np.linalg.norm(along)
    com = away * np.array(aside) / np.linalg.norm(aside)
    distance, radius = distance_to_link(com, end), ratio * (length + away)
    far, wide = 3.0 * (length + radius), 10.0 * (length + away)
    assume(abs(distance / far - 1.0) > 0.01 and abs(radius / wide - 1.0) > 0.01)
    found = analyse(document(end, com, radius)).findings
    told = [finding.message for finding in found if finding.code == "KD309"]
    if distance > far:
        assert len(told) == 1 and told[0].startswith("CoM of 'upper' lies ")
    elif radius > wide:
        assert len(told) == 1 and told[0].startswith("radius of gyration of 'upper' is ")
    else:
        assert told == []
