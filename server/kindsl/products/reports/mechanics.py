"""The comparison of two robots of any files, in text, Markdown and JSON."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple

from kindsl.robots.comparison.mechanical import MechanicalComparison, compared_mechanics
from kindsl.robots.comparison.number_differences import NumberDifference
from kindsl.robots.comparison.sentences import sentence_of, verdict, without_inertia
from kindsl.robots.comparison.side import ComparedSide

if TYPE_CHECKING:
    from kindsl.robots.comparison.torques import Torques

# Of a torque that is nothing but rounding, N m or N.
_DUST = 1e-9


class MechanicsReport(NamedTuple):
    """Two robots and their differences.

    Attributes:
        torques: Of both, None if not computed.
        base_parameters: The number of base parameters, and of all inertial parameters.
    """

    old: ComparedSide
    new: ComparedSide
    found: MechanicalComparison
    torques: "Torques | None" = None
    base_parameters: tuple[int, int] = (0, 0)


def report_of(
    old: ComparedSide, new: ComparedSide, joints: Mapping[str, str] | None = None
) -> MechanicsReport:
    """Compare two robots, with dynamics where NumPy is there and all joints match, if any move.

    Joints are names of the new robot's by the old one's, where neither names nor axes show them.
    """
    found = compared_mechanics(old, new, joints)
    matching = found.matching
    is_partial = matching.only_ours or matching.only_theirs or old.unknown or new.unknown
    if is_partial or not old.skeleton.n_links:
        return MechanicsReport(old, new, found)
    try:
        from kindsl.robots.comparison.torques import n_base_parameters, torques
        from kindsl.robots.mechanism.bodies import bodies_of
    except ModuleNotFoundError:
        return MechanicsReport(old, new, found)
    parameters = n_base_parameters(bodies_of(old.skeleton))
    return MechanicsReport(old, new, found, torques(old, new, found), parameters)


def facts(report: MechanicsReport) -> dict[str, object]:
    """Return the report as plain data."""
    old, new, found, dynamics, parameters = report
    return {
        "old": old.name,
        "new": new.name,
        "equal": found.is_equal,
        "verdict": verdict_of(report),
        "differences": [_entry(report, number, effect) for number, effect in _sorted(report)],
        "structure": list(found.structure),
        "conventions": list(found.conventions),
        "joints": {
            old.skeleton.joint_names[a - 1]: new.skeleton.joint_names[b - 1]
            for a, b in sorted(found.matching.theirs.items())
            if a
        },
        "confirmed": None if dynamics is None else dynamics.is_confirmed,
        "base_parameters": None
        if dynamics is None
        else {"identifiable": parameters[0], "total": parameters[1]},
    }


def lines(report: MechanicsReport) -> Iterator[str]:
    """Yield the report as lines of text: the largest effect first, then conventions."""
    yield verdict_of(report)
    yield from (f"  {sentence}" for sentence in report.found.structure)
    for number, effect in _sorted(report):
        yield f"  {_sentence(report, number)}{_effect(effect)}"
    yield from (f"note: {sentence}" for sentence in report.found.conventions)


def markdown(report: MechanicsReport) -> Iterator[str]:
    """Yield the report as pieces of Markdown."""
    yield f"### Mechanics of `{report.old.name}` and `{report.new.name}`\n\n"
    summary = verdict_of(report)
    yield f"{summary[:1].upper()}{summary[1:]}.\n"
    if report.found.structure:
        yield "\n" + "".join(f"- {sentence}\n" for sentence in report.found.structure)
    if report.found.numbers:
        yield f"\n| what | name | number | `{report.old.name}` | `{report.new.name}` | torque |\n"
        yield "|---|---|---|---|---|---|\n"
        for what, name, *cells in number_cells(report):
            yield f"| {' | '.join((what, f'`{name}`', *cells))} |\n"
    if report.found.conventions:
        yield "\nConventions:\n\n"
        yield from (f"- {sentence}\n" for sentence in report.found.conventions)


def number_cells(report: MechanicsReport) -> Iterator[tuple[str, ...]]:
    """Yield kind, name, quantity, both values with their lines, and torque of what differs."""
    for number, effect in _sorted(report):
        lines, missing = _lines(report, number), without_inertia(number)
        values = (f"{value:.6g} {number.unit}" for value in (number.here, number.there))
        cells = ("no inertia" if m else value for m, value in zip(missing, values, strict=True))
        here, there = (cell + _line(line) for cell, line in zip(cells, lines, strict=True))
        yield (
            number.kind,
            number.owner,
            number.quantity,
            here,
            there,
            "" if effect is None else f"{effect:.3g}",
        )


def verdict_of(report: MechanicsReport) -> str:
    """Return what the comparison comes to."""
    dynamics = report.torques
    if report.found.is_equal and (report.old.unknown or report.new.unknown):
        return "the mechanics are equal as far as both can be read"
    found = verdict(report.found.is_equal, None if dynamics is None else dynamics.is_seen)
    if dynamics is None or dynamics.is_confirmed is None:
        return found
    if dynamics.is_confirmed:
        return f"{found}: inertia matrix and bias forces agree in 20 random states"
    return (
        "internal error: the numbers are equal, but inertia matrix or bias forces are not in 20 "
        "random states; please report both files"
    )


def _sorted(report: MechanicsReport) -> list[tuple[NumberDifference, float | None]]:
    numbers = report.found.numbers
    if report.torques is None:
        return [(number, None) for number in numbers]
    effects = report.torques.effects
    order = sorted(range(len(numbers)), key=lambda i: -effects[i])
    return [(numbers[i], effects[i]) for i in order]


def _sentence(report: MechanicsReport, number: NumberDifference) -> str:
    here, there = number.places
    return sentence_of(number, report.old.place(here), report.new.place(there))


def _lines(report: MechanicsReport, number: NumberDifference) -> tuple[int | None, int | None]:
    here, there = number.places
    return report.old.line(here), report.new.line(there)


def _effect(effect: float | None) -> str:
    if effect is None:
        return ""
    return f" [{effect:.3g} N m or N]" if effect > _DUST else " [no joint torque]"


def _entry(
    report: MechanicsReport, number: NumberDifference, effect: float | None
) -> dict[str, object]:
    lines = _lines(report, number)
    return {
        "kind": number.kind,
        "name": number.owner,
        "name_in_new": number.other,
        "quantity": number.quantity,
        "unit": number.unit,
        "old": number.here,
        "new": number.there,
        "old_line": lines[0],
        "new_line": lines[1],
        "torque": effect,
        "message": _sentence(report, number),
    }


def _line(line: int | None) -> str:
    return "" if line is None else f" (line {line})"
