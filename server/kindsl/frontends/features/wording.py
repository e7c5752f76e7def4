"""Numbers with units, and the phrases that several features share."""

from collections.abc import Iterable, Iterator
from math import degrees
from typing import NamedTuple, assert_never

from kindsl.judgement.rules.base import Severity
from kindsl.language.syntax.tables import ValueKind
from kindsl.mechanics.rigid.body import MassDistribution, principal_moments_about_com
from kindsl.mechanics.rigid.pose import PLAIN, RigidPose, angles

METRES = "m"
RADIANS = "rad"
KILOGRAMS = "kg"
INERTIA = "kg·m²"
_MARKS = {Severity.ERROR: "✗ ", Severity.WARNING: "⚠ "}


def pose_text(pose: RigidPose) -> str:
    """Return a pose: origin in metres, intrinsic x, y, z angles in degrees."""
    turned = vector(degrees(angle) for angle in angles(pose.rotation, PLAIN))
    return f"origin {vector(pose.translation)} m, turned {turned}° about x, y, z"


class Hover(NamedTuple):
    """A text in Markdown about a stretch of the document."""

    start: int
    end: int
    markdown: str


def code(name: str) -> str:
    """Return a name as Markdown shows it, in words where it is missing."""
    return f"`{name}`" if name else "(no name)"


def paragraph(title: str, lines: Iterable[str]) -> str:
    """Return a title and a list below it."""
    items = "\n".join(f"- {line}" for line in lines)
    return f"{title}\n\n{items}"


def number(value: float, digits: int = 4) -> str:
    """Return a number with so many significant digits."""
    # Zero is added to take the sign off -0.0.
    return f"{value + 0.0:.{digits}g}"


def vector(values: Iterable[float]) -> str:
    """Return numbers in parentheses, 0 for those that are only rounding errors of the largest."""
    components = tuple(values)
    largest = max(map(abs, components))
    dust = 1e-12 * max(largest, 1e-3)
    return f"({', '.join(number(0.0 if abs(v) < dust else v) for v in components)})"


def inertia_lines(body: MassDistribution) -> Iterator[str]:
    """Yield where a link's CoM is, and its principal moments about it."""
    yield f"CoM {vector(body.com)} m in the link frame"
    yield f"principal moments about the CoM {moments_text(body)}"


def moments_text(body: MassDistribution) -> str:
    """Return the principal moments about the CoM with their unit."""
    return f"{', '.join(map(number, principal_moments_about_com(body)))} {INERTIA}"


def finding_line(severity: Severity, message: str, code: str) -> str:
    """Return a finding with a mark that shows how severe it is."""
    return f"{_MARKS.get(severity, '')}{message} ({code})"


def angle(value: float) -> str:
    """Return an angle given in radians, in degrees."""
    return f"{number(degrees(value))}°"


def quantity(value: float, kind: ValueKind, unit: str = "") -> str:
    """Return a value in SI units with its unit, which a dynamics value brings along.

    An angle is shown in radians and degrees.
    """
    match kind:
        case ValueKind.ANGLE:
            return f"{number(value)} rad = {angle(value)}"
        case ValueKind.LENGTH:
            return f"{number(value)} {METRES}"
        case ValueKind.DYNAMICS:
            return f"{number(value)} {unit}".rstrip()
        case _:
            assert_never(kind)
