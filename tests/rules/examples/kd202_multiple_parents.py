"""Documents in which KD202 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot


def _linkage(right: str) -> str:
    links = (link("left", 1, "coupler via pin_left"), link("right", 2, right), link("coupler", 3))
    joints = "to_left to_right pin_left" + right.partition(" via")[2]
    return robot(*links, base="left via to_left right via to_right", joints=joints)


GOOD = (_linkage(""),)
BAD = (_linkage("coupler via pin_right"),)
