"""Documents in which KD110 finds nothing, and in which it finds something."""

from tests.support.examples import Example, two_links

GOOD = (two_links(1, 2),)
BAD = (Example(two_links(2, 1), fixed=two_links(1, 2)),)
