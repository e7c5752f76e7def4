"""The kinds of joints, apart from what holds trees of them: the linter needs no more."""

from typing import Literal

JointKind = Literal["revolute", "prismatic"]
