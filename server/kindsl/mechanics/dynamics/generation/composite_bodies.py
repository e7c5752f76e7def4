"""Composite bodies and the joint-space inertia, for tracing."""

from kindsl.mechanics.dynamics.generation.mass_moments import MassMoments
from kindsl.mechanics.dynamics.generation.tree import Tree, Wrench, joint_motions
from kindsl.mechanics.dynamics.generation.vectors import Matrix, Vector


def composites(tree: Tree, q: Vector) -> list[MassMoments]:
    """Return each body with all that it carries, as if rigid."""
    joints, composite = joint_motions(tree, q), list(tree.masses)
    for i in tree.links_leaves_first():
        composite[tree.parents[i]] += joints[i].mass_in_parent(composite[i])
    return composite


def joint_reaction(kind: str, body: MassMoments) -> Wrench:
    """Return the wrench of a body that its joint accelerates by one."""
    (xx, _, xz), (_, yy, yz), _ = body.second
    x, y, _ = body.first
    if kind == "revolute":
        return Wrench([0.0 - xz, 0.0 - yz, xx + yy], [0.0 - y, x, 0.0])
    return Wrench([y, 0.0 - x, 0.0], [0.0, 0.0, body.mass])


def joint_space_inertia(tree: Tree, q: Vector) -> Matrix:
    """Return `M`, the base's six rows first if it floats; entries below the diagonal mirrored."""
    joints, composite = joint_motions(tree, q), composites(tree, q)
    first = 6 if tree.is_floating else 0
    size = first + len(tree.links())
    M: Matrix = [[0.0] * size for _ in range(size)]
    for i in tree.links():
        row = first + i - 1
        reaction = joint_reaction(joints[i].kind, composite[i])
        M[row][row] = joints[i].along(reaction)
        if tree.drives is not None:
            M[row][row] = M[row][row] + tree.drives.armature[i - 1]
        j = i
        while tree.parents[j] != 0:
            reaction, j = joints[j].wrench_in_parent(reaction), tree.parents[j]
            column = first + j - 1
            M[row][column] = joints[j].along(reaction)
            M[column][row] = M[row][column]
        if tree.is_floating:
            moment, force = joints[j].wrench_in_parent(reaction)
            for column, entry in enumerate([*moment, *force]):
                M[row][column] = M[column][row] = entry
    if tree.is_floating:
        for row, entries in enumerate(rigid_body_inertia(composite[0])):
            M[row][:6] = entries
    return M


def base_reactions(tree: Tree, q: Vector) -> list[Wrench]:
    """Return the wrench on the base of each unit acceleration, a floating base's six first.

    Momentum is the same of a unit velocity.
    """
    joints, composite = joint_motions(tree, q), composites(tree, q)
    whole = rigid_body_inertia(composite[0]) if tree.is_floating else []
    found = [Wrench(column[:3], column[3:]) for column in whole]
    for i in tree.links():
        reaction, j = joint_reaction(joints[i].kind, composite[i]), i
        while j != 0:
            reaction, j = joints[j].wrench_in_parent(reaction), tree.parents[j]
        found.append(reaction)
    return found


def rigid_body_inertia(body: MassMoments) -> Matrix:
    """Return the 6x6 inertia of a body, angular part first."""
    inertia, (x, y, z), m = body.inertia(), body.first, body.mass
    return [
        [*inertia[0], 0.0, 0.0 - z, y],
        [*inertia[1], z, 0.0, 0.0 - x],
        [*inertia[2], 0.0 - y, x, 0.0],
        [0.0, z, 0.0 - y, m, 0.0, 0.0],
        [0.0 - z, 0.0, x, 0.0, m, 0.0],
        [y, 0.0 - x, 0.0, 0.0, 0.0, m],
    ]
