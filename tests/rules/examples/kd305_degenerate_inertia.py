"""Documents in which KD305 finds nothing, and in which it finds something."""

from tests.support.examples import inertia, link

GOOD = (link("bar", 1, inertia=inertia("1.0", "0.5", "0.34", "0.34", "0.01")),)
BAD = (
    link("mass", 1, inertia=inertia("1.0", "0.5", "0.25", "0.25", "0.0")),
    link("rod", 1, inertia=inertia("1.0", "0.5", "0.34", "0.34", "0.0")),
    link("plate", 1, inertia=inertia("1.0", "0.5", "0.26", "0.26", "0.02")),
)
