"""Documents in which KD527 finds nothing, and in which it finds something."""

from tests.support.examples import sdf_arm

GOOD = (sdf_arm('<pose relative_to="base">0 0 0.1 0 0 0</pose>'),)
BAD = (sdf_arm('<pose relative_to="shoulder">0 0 0.1 0 0 0</pose>'),)
