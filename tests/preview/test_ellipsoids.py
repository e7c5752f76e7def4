"""Inertia ellipsoids: a solid ellipsoid is drawn as itself, wherever its inertia is given."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from tests.preview.robots import ARM, bodies_of

from kindsl.dynamics.bodies import Bodies
from kindsl.preview.scene.ellipsoids import inertia_ellipsoids
from kindsl.preview.scene.marks import link_marks
from kindsl.spatial.inertia import move_inertia
from kindsl.spatial.transforms import rotation_from_intrinsic_xyz

lengths = st.floats(0.02, 2.0)
angles = st.floats(-3.0, 3.0)
places = st.floats(-1.0, 1.0)


def one_link(mass: float, com: np.ndarray, inertia: np.ndarray) -> Bodies:
    return Bodies(
        base_name="base",
        link_names=("link",),
        joint_names=("joint",),
        joint_kinds=("revolute",),
        parents=(0,),
        p_R_j=np.eye(3)[None],
        p_r_j=np.zeros((1, 3)),
        masses=np.array([0.0, mass]),
        coms=np.array([np.zeros(3), com]),
        inertias=np.array([np.zeros((3, 3)), inertia]),
        is_floating=False,
    )


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
    ellipsoids = inertia_ellipsoids(one_link(mass, com, inertia))
    drawn = ellipsoids.rotations[1] * ellipsoids.semi_axes[1]
    wanted = R @ np.diag(np.square(axes)) @ R.T
    np.testing.assert_allclose(drawn @ drawn.T, wanted, atol=1e-6 * max(axes) ** 2 + 1e-7)
    np.testing.assert_allclose(np.linalg.det(ellipsoids.rotations[1]), 1.0, atol=1e-9)
    assert ellipsoids.is_consistent[1]


def test_an_impossible_inertia_is_told_and_stays_drawable():
    ellipsoids = inertia_ellipsoids(one_link(1.0, np.zeros(3), np.diag([0.1, 0.1, 0.5])))
    assert not ellipsoids.is_consistent[1]
    assert ellipsoids.semi_axes[1].min() >= 0.0099 * ellipsoids.semi_axes[1].max() > 0.0


def test_no_mass_no_ellipsoid():
    bodies = one_link(0.0, np.zeros(3), np.zeros((3, 3)))
    marks = list(link_marks("link", bodies.coms[1], inertia_ellipsoids(bodies), 1))
    assert not [message for message in marks if "inertia" in message["path"]]


def test_ref_frame_turns_and_moves_the_ellipsoid():
    turned = ARM.replace(
        "Iyz = 0.0\n    }\n    children {}",
        "Iyz = 0.0\n        ref_frame = tool\n    }\n    children {}",
    )
    turned = turned.replace(
        "rotation = (0.0, 0.0, 0.0)\n        }\n    }\n}",
        "rotation = (0.0, PI/2.0, 0.0)\n        }\n    }\n}",
    )
    plain, moved = (inertia_ellipsoids(bodies_of(text)) for text in (ARM, turned))
    R = rotation_from_intrinsic_xyz(np.array([0.0, np.pi / 2.0, 0.0]))
    np.testing.assert_allclose(moved.about_com[2], R @ plain.about_com[2] @ R.T, atol=1e-12)
    np.testing.assert_allclose(bodies_of(turned).coms[2], [0.1, 0.0, 0.3], atol=1e-12)
