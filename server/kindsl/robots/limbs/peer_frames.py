"""Link frames of a part of a robot and of its peer, as the joint frames place them."""

from collections.abc import Iterator
from itertools import product as combinations

from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.expressions import Values
from kindsl.language.semantics.kinematic_tree import KinematicTree
from kindsl.mechanics.rigid.pose import Rotation, turned
from kindsl.robots.limbs.comparison import LimbComparison, Tolerance
from kindsl.robots.limbs.limb import Body, Match, body_of, way_up
from kindsl.robots.limbs.mounts import Mount, diagonal, moved

_NEAR = Tolerance(1e-9, 0.02, 0.02)


def peer_frames(tree: KinematicTree, one: Link, other: Link, values: Values) -> list[Rotation]:
    """Return the C that may take coordinates in a peer's link frame to those in a part's.

    A reflection or a turn in the frame of the body that carries both takes the part's joints to
    those of its peer. Along one axis that is not reversed the peer may be moved besides: hind legs
    are often copies of the fore legs. What moves nothing comes first, then what changes least.

    Args:
        tree: The robot.
        one: A part.
        other: Its peer.
        values: Of the parameters.

    Returns:
        Signed permutations; none where the parts do not lie so, or one carries the other.
    """
    here, there = way_up(tree, one), way_up(tree, other)
    carriers = [edge.predecessor for edge in there]
    n_here = next((n for n, e in enumerate(here, 1) if e.predecessor in carriers), 0)
    n_there = carriers.index(here[n_here - 1].predecessor) + 1 if n_here else -1
    bodies = [(body_of(a, values), body_of(b, values)) for a, b in zip(here, there, strict=False)]
    rows = [Match(i - 1, a, b) for i, (a, b) in enumerate(bodies[:n_here][::-1]) if a and b]
    if n_here != n_there or len(rows) < n_here:
        return []
    ways = list(_mounts(rows[0].one, rows[0].other))
    found = LimbComparison(rows, "", ways, _NEAR).readings() if ways else ()
    return [r.conventions[n_here - 1] for r in found if r.slip is None]


def _mounts(one: Body, other: Body) -> Iterator[Mount]:
    """Yield what may take a head to its peer: what moves nothing first, then what changes least."""
    here, there = one.translation, other.translation
    signs = sorted(combinations((1.0, -1.0), repeat=3), key=sum, reverse=True)
    turns = [diagonal(*each) for each in signs] if not _NEAR.is_same(there, here) else []
    yield from (Mount(turn, turned(turn, here), 0.0) for turn in turns)
    for turn, axis in combinations(turns, range(3)):
        if turn[axis][axis] > 0.0:
            yield Mount(turn, moved(turned(turn, here), there, axis), 0.0)
