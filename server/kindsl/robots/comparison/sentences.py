"""A number that differs, in words."""

from typing import TYPE_CHECKING

from kindsl.robots.comparison.quantities import AXIS, INERTIA

if TYPE_CHECKING:
    from kindsl.robots.comparison.number_differences import NumberDifference
    from kindsl.robots.comparison.written import WrittenNumber


def sentence_of(number: "NumberDifference", here: str, there: str) -> str:
    """Return the sentence for a number that differs, without final period.

    Args:
        number: The difference.
        here: Where our value stands: `"here"`, `"in a.kindsl (line 12)"`.
        there: Where the other's stands.
    """
    if number.quantity == AXIS:
        return f"axes of {_subject(number)} {here} and {there} are {number.there:.4g} rad apart"
    missing = without_inertia(number)
    if any(missing):
        mass = f"a mass of {number.there if missing[0] else number.here:.6g} kg"
        left, right = ("no inertia" if is_missing else mass for is_missing in missing)
        return f"{_subject(number)} has {left} {here} and {right} {there}"
    values = f"{number.here:.6g}", f"{number.there:.6g}"
    if values[0] == values[1]:
        values = f"{number.here:.15g}", f"{number.there:.15g}"
    subject = f"{number.quantity} of {_subject(number)}"
    left, right = (f"{value} {number.unit}" for value in values)
    if not _stands(number.places[0], number.here):
        return f"{subject} is {right} {there} and would be {left} to match what is {here}"
    if not _stands(number.places[1], number.there):
        return f"{subject} is {left} {here} and would be {right} to match what is {there}"
    return f"{subject} is {left} {here} and {right} {there}"


def _subject(number: "NumberDifference") -> str:
    other = f" (there '{number.other}')" if number.other not in (number.owner, "") else ""
    return f"{number.kind} '{number.owner}'{other}"


def without_inertia(number: "NumberDifference") -> tuple[bool, bool]:
    """Return whether our link, and whether the other's, has no inertia."""
    is_mass, (here, there) = number.quantity == INERTIA[0], number.places
    return is_mass and not number.here and here is None, (
        is_mass and not number.there and there is None
    )


def _stands(written: "WrittenNumber | None", value: float) -> bool:
    """Return whether the file holds this value verbatim, possibly about another point."""
    return written is None or abs(written.value - value) <= max(written.slack, 1e-12)


def verdict(is_equal: bool, is_seen: bool | None) -> str:
    """Return the verdict in words.

    Args:
        is_equal: Whether the mechanics are equal.
        is_seen: Whether a torque differs, None if unknown.
    """
    if is_equal:
        return "the mechanics are equal"
    if is_seen is False:
        return "the mechanics differ, but no joint torque does"
    return "the mechanics differ"
