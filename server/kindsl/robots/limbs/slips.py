"""Numbers of a triple that were typed wrongly, and the fewest that would have to be typed anew."""

from collections.abc import Iterator, Sequence
from itertools import combinations
from math import cos, degrees, pi, remainder

from kindsl.mechanics.rigid.pose import Rotation, Vector3, angles

_FACTORS = (1000.0, 100.0, 10.0, 0.1, 0.01, 0.001, degrees(1.0))
# Differences of an angle from the author's own and from a peer's, radians, and of other numbers, in
# themselves and as a share. With half of all four two of 278 planted slips less are found, with
# twice one more.
_OWN, _PEER = 1e-5, 1e-3
_NEAR, _SHARE = 1e-4, 0.003


def n_retyped(written: Vector3, meant: Vector3, *, are_angles: bool) -> int:
    """Return how many numbers of a triple no sign, order, unit or one quarter turn explains.

    A triple that has only zeros was left as it was, which counts as one.
    """
    if all(map(is_near, sorted(map(abs, written)), sorted(map(abs, meant)))):
        return 0
    odd = [(x, y) for x, y in zip(written, meant, strict=True) if not is_near(x, y)]
    if any(all(is_near(abs(x), f * abs(y), f) for x, y in odd) for f in _FACTORS):
        return 0
    if are_angles and len(odd) == 1 and _are_turned(odd):
        return 0
    return len(odd) if any(written) else 1


def n_slips(written: Vector3, meant: Vector3, *, are_angles: bool) -> int:
    """Return how many slips make a triple of what was meant: a number typed anew counts twice.

    Two numbers swapped are one slip, and so is an angle that is off by quarter turns.
    """
    for i, j in combinations(range(3), 2):
        swapped = list(meant)
        swapped[i], swapped[j] = meant[j], meant[i]
        if not is_near(meant[i], meant[j]) and all(map(is_near, written, swapped)):
            return 1
    odd = [(x, y) for x, y in zip(written, meant, strict=True) if not is_near(x, y)]
    if are_angles and _are_turned(odd):
        return len(odd)
    n_new = n_retyped(written, meant, are_angles=are_angles)
    # A sign beside another unit; what is typed anew, or in another order, is so with its sign.
    sizes = [abs(y) for y in meant]
    n_with_sign = sum(x * y < 0.0 and not any(is_near(abs(x), z) for z in sizes) for x, y in odd)
    return len(odd) + (n_new or n_with_sign)


def angles_near(rotation: Rotation, own: Vector3, peer: Vector3) -> Vector3:
    """Return angles that make a rotation, in as few changes of those written as can be, radians.

    Args:
        rotation: To be made.
        own: The angles as written.
        peer: Those of the peer.
    """

    def n_changed(option: Vector3) -> int:
        return sum(x != y for x, y in zip(option, own, strict=True))

    return min(
        (_worded(option, own, peer) for option in _triples(rotation, own, peer)), key=n_changed
    )


def _triples(rotation: Rotation, own: Vector3, peer: Vector3) -> Iterator[Vector3]:
    """Yield the angles that make a rotation; where only a sum counts, some that may be meant."""
    a, b, c = angles(rotation, _PEER)
    if abs(cos(b)) > _PEER:
        yield a, b, c
        yield a + pi, pi - b, c + pi
        return
    sign = 1.0 if b > 0.0 else -1.0
    for x in (own[0], peer[0], -peer[0], 0.0):
        yield x, b, sign * (a - x)
    for z in (own[2], peer[2], -peer[2], 0.0):
        yield a - sign * z, b, z


def _worded(option: Vector3, own: Vector3, peer: Vector3) -> Vector3:
    """Return the same angles as they are written, if they are, else within half a turn."""
    found = []
    for angle, mine, his in zip(option, own, peer, strict=True):
        words = [(mine, _OWN), *((sign * x, _PEER) for x in (his, *peer) for sign in (1.0, -1.0))]
        wound = (angle + pi) % (2 * pi) - pi
        near = (w for w, within in words if abs((w - angle + pi) % (2 * pi) - pi) <= within)
        found.append(0.0 + next(near, wound))
    return found[0], found[1], found[2]


def _are_turned(odd: Sequence[tuple[float, float]]) -> bool:
    """Return whether angles are quarter turns apart."""
    return all(abs(remainder(x - y, pi / 2)) < _PEER for x, y in odd)


def is_near(here: float, there: float, scale: float = 1.0) -> bool:
    """Return whether two numbers are the same as far as numbers of two limbs are."""
    return abs(here - there) <= _NEAR * scale + _SHARE * abs(there)
