"""Whether two documents describe one mechanism."""

import numpy as np

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.robots.mechanism.bodies import bodies_of
from kindsl.robots.mechanism.reading import reachable_linkage


def mechanics_by_name(analysis: Analysis, values: dict[str, float] | None = None):
    """Return what links, joints and frames come to, by name, whatever their order.

    Args:
        analysis: A document whose base carries something.
        values: Of its unbound parameters.
    """
    known = {**(values or {}), **analysis.context.values}
    bodies = bodies_of(reachable_linkage(analysis.model, known))
    names = (bodies.base_name, *bodies.link_names)
    found = {("base",): (bodies.base_name, bodies.is_floating)}
    for index, name in enumerate(names):
        inertia = (bodies.masses[index], bodies.coms[index], bodies.inertias[index])
        found["inertia", name] = inertia
    for index, name in enumerate(bodies.link_names):
        pose = (bodies.p_R_j[index], bodies.p_r_j[index])
        joint = (bodies.joint_names[index], bodies.joint_kinds[index])
        found["joint", name] = (names[bodies.parents[index]], *joint, *pose)
    for frame in bodies.frames:
        pose = (frame.body_R_frame, frame.body_r_frame)
        found["frame", frame.name] = (names[frame.body], *pose)
    return found


def matrix(pose):
    """Return a rigid pose as a homogeneous matrix, shape (4, 4)."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = pose.rotation, pose.translation
    return T


def assert_same_mechanism(before, after, tolerance=1e-9):
    """Fail unless all that the first has is in the second, numbers within a tolerance."""
    assert before.keys() <= after.keys()
    for key, old in before.items():
        for a, b in zip(old, after[key], strict=True):
            if isinstance(a, str | bool):
                assert a == b, key
            else:
                np.testing.assert_allclose(a, b, rtol=tolerance, atol=tolerance, err_msg=str(key))
