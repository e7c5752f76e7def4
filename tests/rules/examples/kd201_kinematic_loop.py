"""Documents in which KD201 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link, robot


def _arm(last: str, *more: str) -> str:
    links = link("upper", 1, "lower via elbow"), link("lower", 2, last)
    joints = "shoulder elbow" + last.partition(" via")[2]
    return robot(*links, *more, base="upper via shoulder", joints=joints)


def _with_hand(last: str) -> str:
    return _arm(last, link("hand", 3))


GOOD = (_arm(""),)
BAD = (
    _arm("upper via wrist"),
    _arm("lower via wrist"),
    Example(_with_hand("upper via wrist"), fixed=_with_hand("hand via wrist")),
    _arm("upper via wrist", link("hand", 3), link("tool", 4)),
    _arm("upper via wrist", link("hand", 3, "lower via elbow")),
)
