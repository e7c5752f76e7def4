"""Documents in which KD405 finds nothing, and in which it finds something."""

from tests.support.examples import inertia, link

GOOD = (
    link("hand", 1, inertia=inertia("payload", "0.1", "payload/20.0", "0.05", "0.05")),
    link("hand", 1, inertia=inertia("2.0", "0.1", "0.05", "0.05", "0.05")),
)
BAD = (
    link("hand", 1, inertia=inertia("payload", "0.1", "0.05", "0.05", "0.05")),
    link("hand", 1, inertia=inertia("2.0", "reach", "0.05", "0.05", "0.05")),
    link("hand", 1, inertia=inertia("2.0", "0.1", "ix", "0.05", "0.05")),
)
