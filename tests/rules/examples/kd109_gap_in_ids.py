"""Documents in which KD109 finds nothing, and in which it finds something."""

from tests.support.examples import Example, two_links

GOOD = (two_links(1, 2),)
BAD = (
    Example(two_links(1, 4), fixed=two_links(1, 2)),
    Example(two_links(7, 8), fixed=two_links(1, 2)),
)
