"""Another file of the same robot, which the configuration names."""

from typing import NamedTuple


class TwinFile(NamedTuple):
    """A file, or folder of generated code, that describes the robot of a document, too.

    Attributes:
        path: Where it is.
        label: As the configuration writes it.
        joints: Pairs of our joints and its, where neither names nor axes show them.
        tolerance: Relative, of what counts as equal besides what the digits leave open.
        version: Another one after each change of the file, where somebody watches it.
    """

    path: str
    label: str
    joints: tuple[tuple[str, str], ...] = ()
    tolerance: float = 0.0
    version: object = None
