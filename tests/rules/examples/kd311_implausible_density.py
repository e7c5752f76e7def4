"""Documents in which KD311 finds nothing, and in which it finds something."""

from tests.support.examples import inertia, link

GOOD = (link("motor", 1, inertia=inertia("0.5", "0.0", "0.00015", "0.00015", "0.00009")),)
BAD = (
    link("motor", 1, inertia=inertia("0.5", "0.0", "0.03", "0.03", "0.018")),
    link("motor", 1, inertia=inertia("20.0", "0.0", "0.00150", "0.00150", "0.00090")),
)
