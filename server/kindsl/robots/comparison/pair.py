"""Two robots side by side."""

from typing import NamedTuple

from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.comparison.alignment import Alignment, around
from kindsl.robots.comparison.matching import MatchedJoints
from kindsl.robots.comparison.side import ComparedSide


class Pair(NamedTuple):
    """Two robots, their matching bodies, and the other's conventions beside ours."""

    ours: ComparedSide
    theirs: ComparedSide
    matching: MatchedJoints
    alignment: Alignment

    @property
    def parents(self) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """The parents of the links of both."""
        return self.ours.skeleton.parents, self.theirs.skeleton.parents

    @property
    def joints(self) -> list[tuple[int, int]]:
        """The bodies on matching joints, ours and theirs, in our order."""
        return [(body, its) for body, its in sorted(self.matching.theirs.items()) if body]

    def around(self, body: int) -> tuple[RigidPose, RigidPose]:
        """Return the poses before and after the other's joint frame that make it ours."""
        return around(self.ours.skeleton, self.alignment, body)
