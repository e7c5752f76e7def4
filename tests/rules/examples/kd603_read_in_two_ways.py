"""Documents in which KD603 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint

from kindsl.judgement.rules.context import ROBCOGEN, ROBCOGEN2


def _joint(height: str, target: str = "", fixed: str | None = None) -> Example:
    shoulder = joint("shoulder").replace("0.3", height)
    targets = (target,) if target else ()
    example = Example(shoulder, targets, (("reach", 0.3), ("e0", 0.1)))
    return example._replace(fixed=joint("shoulder").replace("0.3", fixed)) if fixed else example


GOOD = (_joint("0.3"), _joint("2.0e-3", ROBCOGEN2))
BAD = (
    _joint("0.3e0", fixed="0.3"),
    _joint("0.3e0", ROBCOGEN2, "0.3"),
    _joint("0.3e0", ROBCOGEN, "0.3"),
    _joint("2.0 - reach"),
)
