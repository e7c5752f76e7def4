"""Another file of the same robot, which the configuration names, and what it says otherwise."""

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from kindsl.comparison.mechanical import MechanicalComparison


class TwinFile(NamedTuple):
    """A file, or folder of generated code, that describes the robot of a document, too.

    Attributes:
        path: Where it is.
        label: As the configuration writes it.
        joints: Pairs of our joints and its, where names and axes do not tell.
        tolerance: Relative, of what counts as equal besides what the digits leave open.
        version: Another one after each change of the file, where somebody watches it.
    """

    path: str
    label: str
    joints: tuple[tuple[str, str], ...] = ()
    tolerance: float = 0.0
    version: object = None


class ComparedTwin(NamedTuple):
    """A twin, and what it says otherwise.

    Attributes:
        twin: The file.
        is_generated: Whether it is a folder of generated code.
        found: The comparison.
    """

    twin: TwinFile
    is_generated: bool
    found: "MechanicalComparison"
