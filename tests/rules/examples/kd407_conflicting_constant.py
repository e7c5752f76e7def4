"""Documents in which KD407 finds nothing, and in which it finds something."""

from tests.support.examples import joint


def _joint(second: str) -> str:
    return joint("elbow").replace("0.0, 0.0, 0.3", f"<reach=0.5>, 0.0, {second}")


GOOD = (_joint("<reach>"), _joint("<reach=0.50>"))
BAD = (_joint("<reach=0.4>"),)
