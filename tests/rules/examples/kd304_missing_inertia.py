"""Documents in which KD304 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot

_FLOATING = robot(link("leg", 1), base="leg via hip", joints="hip").replace(
    "ground {", "ground floating {"
)

GOOD = (link("upper", 1),)
BAD = (
    link("upper", 1, inertia=""),
    _FLOATING,
    link("upper", 1, inertia="") + link("lower", 2, inertia=""),
)
