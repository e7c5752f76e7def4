"""Which bodies are doubtful, and why: uniform boxes of known density, here and there."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.judgement.diagnosis.body_verdicts import BodyDoubt, body_verdicts
from kindsl.mechanics.rigid.body import MassDistribution, shifted
from kindsl.mechanics.rigid.pose import Vector3

END = (0.0, 0.0, 0.4)


def box(sides: Vector3, com: Vector3, density: float = 1000.0) -> MassDistribution:
    """Return a uniform box along the link's axes."""
    a, b, c = sides
    mass = density * a * b * c
    ix, iy, iz = (mass * (p * p + q * q) / 12.0 for p, q in ((b, c), (a, c), (a, b)))
    return shifted(MassDistribution(mass, com, (ix, iy, iz, 0.0, 0.0, 0.0)))


def kinds(body: MassDistribution, *ends: Vector3, frames: tuple[Vector3, ...] = ()) -> list[str]:
    return [verdict.kind.value for verdict in body_verdicts("arm", body, ends or (END,), frames)]


ALONG, ACROSS = (0.05, 0.05, 0.4), (0.4, 0.05, 0.05)


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (box(ALONG, (0.0, 0.0, 0.2)), []),
        (box(ALONG, (0.0, 0.0, 0.2), 8.0), ["too light"]),
        (box(ALONG, (0.0, 0.0, 0.2), 40_000.0), ["too dense"]),
        (box(ALONG, (0.0, 0.9, 0.2)), ["apart"]),
        (box((4.0, 9.0, 4.0), (0.0, 0.0, 0.2), 100.0), ["too long"]),
        (box((4.0, 9.0, 4.0), (0.0, 0.0, 0.2), 8.0), ["too light"]),
        (box(ACROSS, (0.0, 0.0, 0.2)), ["across"]),
        (box(ACROSS, (0.1, 0.0, 0.05)), ["across"]),
        (box(ACROSS, (0.0, 0.0, 0.05)), []),
        (box(ALONG, (0.1, 0.0, 0.05)), []),
        (box(ALONG, (0.0, 0.0, -0.2)), ["behind"]),
        (box(ALONG, (0.0, 0.0, 0.6)), ["behind"]),
        (box(ALONG, (0.0, 0.0, 0.43)), []),
        (box((0.05, 0.05, 0.1), (0.0, 0.0, -0.2)), []),
        (box((0.3, 0.3, 0.4), (0.0, 0.0, -0.2)), []),
        (MassDistribution(0.0, (0.0, 0.0, 9.0), (0.0,) * 6), []),
        (MassDistribution(1.0, (0.0, 0.0, 0.2), (0.001, 0.001, 0.1, 0.0, 0.0, 0.0)), []),
    ],
)
def test_each_doubt(body: MassDistribution, expected: list[str]) -> None:
    assert kinds(body) == expected


def test_where_a_link_goes_to_several_places_no_way_is_across() -> None:
    body = box(ACROSS, (0.0, 0.0, 0.2))
    assert kinds(body, END, (0.3, 0.0, 0.0)) == []
    assert kinds(body, END, frames=((0.3, 0.0, 0.0),)) == ["across"]


def test_a_verdict_says_what_it_rests_on() -> None:
    (across,) = body_verdicts("arm", box(ACROSS, (0.1, 0.0, 0.05)), (END,))
    assert across == (
        BodyDoubt.ACROSS,
        pytest.approx(0.4),
        "KD313",
        "inertia of 'arm' describes a rod 0.4 m long across the link, which is 0.4 m long; "
        "its CoM lies 0.1 m beside it",
    )
    (behind,) = body_verdicts("arm", box(ALONG, (0.0, 0.0, -0.2)), (END,))
    assert behind.number == pytest.approx(-0.2)
    assert behind.sentence == (
        "CoM of 'arm' lies 0.2 m behind its joint, though the next one is 0.4 m ahead"
    )
    (beyond,) = body_verdicts("arm", box(ALONG, (0.0, 0.0, 0.6)), (END,))
    assert beyond.sentence == "CoM of 'arm' lies 0.2 m beyond its next joint"


@settings(max_examples=50, deadline=None, derandomize=True)
@given(
    st.sampled_from((ALONG, ACROSS, (0.1, 0.2, 0.3))),
    st.tuples(*[st.floats(-0.9, 0.9)] * 3),
    st.floats(0.0, 5.0).map(lambda power: 10.0**power),
)
def test_a_verdict_is_the_same_whatever_the_axes_are_called(
    sides: Vector3, com: Vector3, density: float
) -> None:
    def turned(v: Vector3) -> Vector3:
        return v[2], v[0], v[1]

    here = kinds(box(sides, com, density))
    assert kinds(box(turned(sides), turned(com), density), turned(END)) == here
