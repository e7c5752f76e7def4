"""What URDF and SDF call the same."""

from collections.abc import Iterator
from typing import Any, Literal

from kindsl.language.text.phrases import counted

LinkJoint = Literal["", "fixed", "revolute", "prismatic"]
# The kinds of joints that there are here.
JOINT_KINDS: dict[str, LinkJoint] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
    "fixed": "fixed",
}
# The moments of `Symmetric`.
TENSOR = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")


def drawings_dropped(parent: Any) -> Iterator[str]:
    """Yield the note on the shapes of an element's links, which a document does not have."""
    drawn = {link for tag in ("visual", "collision") for link in parent.iterfind(f"link[{tag}]")}
    if number := len(drawn):
        yield f"visuals and collisions of {counted(number, 'link')} dropped"
