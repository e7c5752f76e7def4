"""Text in columns."""

from collections.abc import Sequence

# Of the values of parameters, by their kind.
PARAMETER_UNITS = {"length": "m", "angle": "rad", "dynamics": ""}


def aligned(rows: Sequence[Sequence[str]], right: frozenset[int] = frozenset()) -> str:
    """Return rows of equal length as lines with columns of equal width."""
    if not rows:
        return ""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = (
        "  ".join(
            cell.rjust(width) if i in right else cell.ljust(width)
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    )
    return "".join(f"{line}\n" for line in lines)


def number(value: float | None, unit: str = "") -> str:
    """Return a number for people, a dash if there is none."""
    if value is None:
        return "-"
    return f"{value:.6g} {unit}".rstrip()
