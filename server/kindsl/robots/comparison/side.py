"""One side of a comparison: a robot, how its file writes it, and the lines of its numbers."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from kindsl.language.semantics.parameters import JointProperties
from kindsl.language.semantics.places import Located
from kindsl.robots.comparison.alignment import Alignment
from kindsl.robots.comparison.matching import MatchedJoints
from kindsl.robots.comparison.written import (
    TextPlace,
    WrittenInertia,
    WrittenNumber,
    WrittenPose,
    with_meant_angles,
    written_frame,
)
from kindsl.robots.mechanism.linkage import Linkage

LineOf = Callable[[Located], int]


@dataclass(frozen=True, slots=True)
class ComparedSide:
    """One side of a comparison: a robot, and how its file writes it.

    Attributes:
        label: What sentences call its file.
        skeleton: Its bodies.
        inertias: Parts of each body's mass, n + 1 lists of them; a body may have none.
        joints: The written poses of the n joints.
        heavy_frames: Frames that are links with a mass of their own: where they are is a
            convention.
        frames: The written poses of other frames by name, as far as numbers are written.
        unknown: Bodies and joints that cannot be read: their numbers are not compared.
        properties: Limits of joints and the like, by the joint's name, as far as they are told.
        shown: Its file as shown, where that is not the label.
        line_of: Returns the line of a place in it, where it is a document.
    """

    label: str
    skeleton: Linkage
    inertias: tuple[tuple[WrittenInertia, ...], ...]
    joints: tuple[WrittenPose, ...]
    heavy_frames: frozenset[str] = frozenset()
    frames: Mapping[str, WrittenPose] = field(default_factory=dict)
    unknown: frozenset[str] = frozenset()
    properties: Mapping[str, JointProperties] = field(default_factory=dict)
    shown: str = ""
    line_of: LineOf | None = None

    @property
    def name(self) -> str:
        """Its file, as shown."""
        return self.shown or self.label

    def line(self, number: WrittenNumber | None) -> int | None:
        """Return the line of a number, None where it stands nowhere."""
        if number is None:
            return None
        if isinstance(number.at, TextPlace):
            return number.at.line
        return self.line_of(number.at) if self.line_of else None

    def place(self, number: WrittenNumber | None) -> str:
        """Return where a number stands, in words."""
        line = self.line(number)
        if number is None or line is None:
            return f"in {self.label}"
        file = number.at.file if isinstance(number.at, TextPlace) else ""
        name = f"{self.label.rstrip('/')}/{file}" if file else self.label
        return f"in {name} (line {line})"


class Pair(NamedTuple):
    """Two robots, their matching bodies, and the other's conventions beside ours."""

    ours: ComparedSide
    theirs: ComparedSide
    matching: MatchedJoints
    alignment: Alignment

    @property
    def joints(self) -> list[tuple[int, int]]:
        """The bodies on matching joints, ours and theirs, in our order."""
        return [(body, its) for body, its in sorted(self.matching.theirs.items()) if body]


def exactly_turned(side: ComparedSide) -> ComparedSide:
    """Return a robot whose joints stand at the angles meant: `1.5708` is a quarter turn."""
    meant = tuple(map(with_meant_angles, side.joints))
    exact = side.skeleton.with_placements(joint.pose() for joint in meant)
    return replace(side, skeleton=exact, joints=meant)


def written_joints(skeleton: Linkage) -> tuple[WrittenPose, ...]:
    """Return the forms of joints that are only known as poses."""
    return tuple(written_frame(body.joint, body.placement) for body in skeleton.bodies[1:])
