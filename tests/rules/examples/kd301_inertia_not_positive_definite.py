"""Documents in which KD301 finds nothing, and in which it finds something."""

from tests.support.examples import inertia, link

GOOD = (link("upper", 1, inertia=inertia("2.0", "0.3", "0.2", "0.2", "0.002")),)
BAD = (
    link("upper", 1, inertia=inertia("2.0", "0.3", "0.02", "0.02", "0.002")),
    link("upper", 1, inertia=inertia("2.0", "0.1", "0.012", "0.012", "0.002")),
)
