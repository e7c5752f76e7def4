"""Documents in which KD406 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint


def _joint(third: str) -> str:
    return joint("elbow").replace("0.0, 0.0, 0.3", f"<reach=0.5>, 0.0, {third}")


GOOD = (_joint("<reach>"),)
BAD = (Example(_joint("<raech>"), fixed=_joint("<reach>")), _joint("<width>"))
