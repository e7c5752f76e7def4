"""Documents in which KD302 finds nothing, and in which it finds something."""

from tests.support.examples import inertia, link

GOOD = (link("plate", 1, inertia=inertia("1.8", "0.0", "0.0045", "0.0046", "0.0090")),)
BAD = (
    link("plate", 1, inertia=inertia("1.8", "0.0", "0.0005", "0.0005", "0.0090")),
    link("plate", 1, inertia=inertia("1.8", "0.0", "0.0045", "0.00449", "0.0090")),
)
