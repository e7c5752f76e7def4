"""The content of a report, before anything is concluded from it."""

from dataclasses import dataclass, field

from kindsl.robots.cad.quantity import Quantity

Entry = tuple[int, int]
PAIRS: tuple[Entry, ...] = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


class ReportError(ValueError):
    """A report that cannot be taken over; the sentence says why, with the numbers.

    Attributes:
        reasons: A sentence each.
    """

    def __init__(self, program: str, *reasons: str) -> None:
        super().__init__("; ".join(reasons))
        self.program = program
        self.reasons = reasons


class NoReportError(ReportError):
    """A text that is no report of mass properties."""


@dataclass(slots=True)
class Report:
    """Numbers as they are printed.

    Attributes:
        masses: Each mass in it; one is usual.
        center: Centre of mass by axis.
        about_com: Entries of the tensor about the centre of mass, each as often as it is printed.
        about_origin: Entries of the one about the output coordinate system's origin.
        principal: Principal moments.
        axes: Principal axes by the index of their moment.
        density: If it is printed.
        volume: If it is printed.
        systems: All that are named, as printed.
        bodies: Names of the bodies whose properties these are.
        notation: The report's own words on the sign of products.
        is_overridden: Whether a person overrode numbers.
    """

    program: str
    masses: list[Quantity] = field(default_factory=list)
    center: dict[int, list[Quantity]] = field(default_factory=dict)
    about_com: dict[Entry, list[Quantity]] = field(default_factory=dict)
    about_origin: dict[Entry, list[Quantity]] = field(default_factory=dict)
    principal: dict[int, list[Quantity]] = field(default_factory=dict)
    axes: dict[int, list[Quantity]] = field(default_factory=dict)
    density: Quantity | None = None
    volume: Quantity | None = None
    systems: list[str] = field(default_factory=list)
    bodies: list[str] = field(default_factory=list)
    notation: str = ""
    is_overridden: bool = False
    notes: list[str] = field(default_factory=list)
