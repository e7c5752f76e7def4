"""Documents in which KD403 finds nothing, and in which it finds something."""

from tests.support.examples import joint


def _joint(angle: str) -> str:
    return joint("elbow", rotation=f"{angle}, 0.0, 0.0").replace("0.3", "offset")


GOOD = (_joint("tilt"),)
BAD = (_joint("offset"),)
