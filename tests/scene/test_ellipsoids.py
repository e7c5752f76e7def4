"""Inertia ellipsoids: a solid ellipsoid is drawn as itself, wherever its inertia is given."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from tests.preview.robots import ARM, skeleton_of
from tests.support.spatial import rotation_from_intrinsic_xyz

from kindsl.mechanics.rigid.body import NO_BODY, MassDistribution
from kindsl.mechanics.spatial.inertia import move_inertia
from kindsl.robots.scene.ellipsoids import inertia_ellipsoid
from kindsl.robots.scene.marks import mass_marks

lengths = st.floats(0.02, 2.0)
angles = st.floats(-3.0, 3.0)
places = st.floats(-1.0, 1.0)


def body(mass: float, com: np.ndarray, inertia: np.ndarray) -> MassDistribution:
    (Ix, Ixy, Ixz), (_, Iy, Iyz), (_, _, Iz) = inertia.tolist()
    return MassDistribution(mass, tuple(com.tolist()), (Ix, Iy, Iz, -Ixy, -Ixz, -Iyz))


@given(
    axes=st.tuples(lengths, lengths, lengths),
    turn=st.tuples(angles, angles, angles),
    place=st.tuples(places, places, places),
    mass=st.floats(0.1, 50.0),
)
def test_a_solid_ellipsoid_is_drawn_as_itself(axes, turn, place, mass):
    a, b, c = axes
    own = mass / 5.0 * np.diag([b * b + c * c, a * a + c * c, a * a + b * b])
    R = rotation_from_intrinsic_xyz(np.array(turn))
    com, inertia = move_inertia(np.asarray(mass), np.zeros(3), own, R, np.array(place))
    ellipsoid = inertia_ellipsoid(body(mass, com, inertia))
    drawn = np.array(ellipsoid.semi_axes).T
    wanted = R @ np.diag(np.square(axes)) @ R.T
    np.testing.assert_allclose(drawn @ drawn.T, wanted, atol=1e-6 * max(axes) ** 2 + 1e-7)
    assert np.linalg.det(drawn) > 0.0
    assert ellipsoid.is_consistent


def test_an_impossible_inertia_is_told_and_stays_drawable():
    ellipsoid = inertia_ellipsoid(body(1.0, np.zeros(3), np.diag([0.1, 0.1, 0.5])))
    assert not ellipsoid.is_consistent
    lengths = np.linalg.norm(ellipsoid.semi_axes, axis=1)
    assert lengths.min() >= 0.0099 * lengths.max() > 0.0


def test_no_mass_no_ellipsoid():
    marks = list(mass_marks("link", NO_BODY.com, inertia_ellipsoid(NO_BODY)))
    assert not [message for message in marks if "inertia" in message.path]


def test_ref_frame_turns_and_moves_the_ellipsoid():
    turned = ARM.replace(
        "Iyz = 0.0\n    }\n    children {}",
        "Iyz = 0.0\n        ref_frame = tool\n    }\n    children {}",
    )
    turned = turned.replace(
        "rotation = (0.0, 0.0, 0.0)\n        }\n    }\n}",
        "rotation = (0.0, PI/2.0, 0.0)\n        }\n    }\n}",
    )
    before, after = (skeleton_of(text).masses[2] for text in (ARM, turned))
    plain, moved = (np.reshape(inertia_ellipsoid(b).about_com, (3, 3)) for b in (before, after))
    R = rotation_from_intrinsic_xyz(np.array([0.0, np.pi / 2.0, 0.0]))
    np.testing.assert_allclose(moved, R @ plain @ R.T, atol=1e-12)
    np.testing.assert_allclose(after.com, [0.1, 0.0, 0.3], atol=1e-12)
