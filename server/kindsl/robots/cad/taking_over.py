"""The inertia of a report: mass, centre of mass and moments as the language has them."""

from collections.abc import Iterator
from fractions import Fraction

from kindsl.language.text.phrases import alternatives, counted, listed
from kindsl.robots.cad.agreement import Numbers, disagreements, moved
from kindsl.robots.cad.programs import documented_sign, more_digits
from kindsl.robots.cad.properties import MassProperties
from kindsl.robots.cad.quantity import Quantity, Rounded
from kindsl.robots.cad.report import PAIRS, Entry, NoReportError, Report, ReportError
from kindsl.robots.cad.report_reading import has_default_name, readings

# Enough significant digits of the mass, which a kitchen scale gives, and of a moment: two leave it
# open by up to 5 %, more than a part differs from its model.
_ENOUGH_FOR_MASS, _ENOUGH = 2, 3
_LABELS = {0: "x", 1: "y", 2: "z"}
_SIGNS = {1: "as Σ m x y", -1: "as entries of the tensor"}


def mass_properties(text: str) -> MassProperties:
    """Return the mass properties that a report of a CAD program has.

    Args:
        text: The report; its bytes that are no UTF-8, as surrogates, are taken for Latin-1.

    Raises:
        ReportError: There is no report in the text, something in it is missing, or its numbers
            contradict each other.
    """
    errors: list[ReportError] = []
    found: list[MassProperties] = []
    for read in readings(_of_latin_1(text)):
        try:
            found.append(_taken_over(read()))
        except ReportError as error:
            errors.append(error)
    if len({(one.mass, one.com, one.moments) for one in found}) > 1:
        reason = "a comma between three digits may be a decimal mark or separate thousands"
        raise ReportError(found[0].program, reason)
    if not found:
        raise errors[0]
    return found[0]


def _of_latin_1(text: str) -> str:
    """Return a text with bytes that are not UTF-8 read as Latin-1, as old programs write them."""
    return "".join(chr(ord(c) - 0xDC00) if "\udc80" <= c <= "\udcff" else c for c in text)


def _taken_over(report: Report) -> MassProperties:
    _check_single(report)
    numbers = _numbers(report)
    reasons = {sign: list(disagreements(numbers, sign)) for sign in (1, -1)}
    signs = [sign for sign in (1, -1) if not reasons[sign]]
    if not signs:
        raise ReportError(report.program, *_reasons_of_both(reasons))
    has_products = any(numbers_of(numbers)[entry].printed for entry in PAIRS[3:])
    is_proved = len(signs) == 1 or not has_products
    sign = signs[0] if is_proved else documented_sign(report.program)
    first, second = (_moments(numbers, one) for one in (sign or 1, -1))
    x, y, z = (one.text() for one in numbers.center)
    return MassProperties(
        report.program,
        numbers.mass.text(),
        (x, y, z),
        first,
        sign,
        second if sign is None else None,
        next((name for name in report.systems if not has_default_name(name)), ""),
        (*_notes(report, numbers), *_on_signs(report, sign, is_proved)),
    )


def numbers_of(numbers: Numbers) -> dict[Entry, Quantity]:
    """Return the tensor whose products are printed: at the output coordinate system, if it is."""
    found = numbers.about_origin or numbers.about_com
    assert found is not None
    return found


def _check_single(report: Report) -> None:
    masses = {(one.value, one.factor) for one in report.masses}
    tensors = (*report.about_com.values(), *report.about_origin.values())
    is_repeated = any(len({one.printed for one in several}) > 1 for several in tensors)
    is_repeated |= any(len({o.printed for o in several}) > 1 for several in report.center.values())
    if len(masses) > 1 or (is_repeated and len(report.bodies) > 1):
        count = max(len(masses), len(report.bodies))
        names = f": {listed(report.bodies)}" if len(report.bodies) > 1 else ""
        raise ReportError(report.program, f"the report is of {count} bodies{names}")
    if is_repeated:
        raise ReportError(report.program, "the report has different numbers for the same thing")
    named = [name for name in report.systems if not has_default_name(name)]
    if len(report.systems) > 1 and len(set(named)) > 1:
        names = listed(f"'{name}'" for name in report.systems)
        raise ReportError(report.program, f"the report mixes the coordinate systems {names}")


def _numbers(report: Report) -> Numbers:
    if not (report.masses or report.center or report.about_com or report.about_origin):
        known = "SolidWorks, Onshape, Fusion 360, Inventor, Creo or FreeCAD"
        reason = f"this is not a report of mass properties by {known} in English"
        raise NoReportError(report.program, reason)
    lacking = _lacking(report)
    if lacking:
        raise ReportError(report.program, f"the report lacks {listed(lacking)}")
    numbers = Numbers(
        report.masses[0],
        _evened([report.center[index][0] for index in range(3)]),
        _tensor(report, report.about_com),
        _tensor(report, report.about_origin),
        _evened([report.principal[index][0] for index in sorted(report.principal)])
        if len(report.principal) == 3
        else (),
        {index: _evened(axis) for index, axis in report.axes.items()},
    )
    _check_units(report, numbers)
    _check_digits(report, numbers)
    if numbers.mass.value <= 0:
        mass = numbers.mass.text()
        raise ReportError(report.program, f"the mass is {mass} kg, which is not positive")
    return numbers


def _lacking(report: Report) -> list[str]:
    lacking = [] if report.masses else ["the mass"]
    axes = [_LABELS[index].upper() for index in range(3) if index not in report.center]
    if axes:
        lacking.append("the centre of mass" if len(axes) == 3 else f"{listed(axes)} of the CoM")
    if not report.about_com and not report.about_origin:
        lacking.append("the moments of inertia")
    for letter, tensor in (("L", report.about_com), ("I", report.about_origin)):
        if tensor:
            letter = next(iter(tensor.values()))[0].name[:1] or letter
            lacking += [
                f"{letter}{_LABELS[row]}{_LABELS[column]}"
                for row, column in PAIRS
                if (row, column) not in tensor and (column, row) not in tensor
            ]
    return lacking


def _tensor(report: Report, printed: dict[Entry, list[Quantity]]) -> dict[Entry, Quantity] | None:
    if not printed:
        return None
    entries = list(printed)
    flat = dict(zip(entries, _evened([printed[entry][0] for entry in entries]), strict=True))
    for row, column in PAIRS[3:]:
        one, other = flat.get((row, column)), flat.get((column, row))
        if one is not None and other is not None and not _is_same(one, other):
            raise ReportError(
                report.program, f"{one.name} is {one.printed}, but {other.name} is {other.printed}"
            )
    return {
        (row, column): flat[row, column] if (row, column) in flat else flat[column, row]
        for row, column in PAIRS
    }


def _is_same(one: Quantity, other: Quantity) -> bool:
    return abs(one.value - other.value) <= 2 * max(one.error, other.error)


def _evened(group: list[Quantity]) -> tuple[Quantity, ...]:
    """Return numbers with bare zeros as precise as the most precise one."""
    finest = min(one.half for one in group)
    return tuple(one if one.printed else one._replace(half=min(one.half, finest)) for one in group)


def _check_units(report: Report, numbers: Numbers) -> None:
    groups = (
        ("mass has", (numbers.mass,)),
        ("centre of mass has", numbers.center),
        ("moments of inertia have", tuple((numbers.about_com or {}).values())),
        ("moments of inertia have", tuple((numbers.about_origin or {}).values())),
        ("principal moments have", numbers.principal),
    )
    reasons = [f"the {what} no unit" for what, group in groups if not all(o.factor for o in group)]
    if reasons:
        raise ReportError(report.program, *dict.fromkeys(reasons))


def _check_digits(report: Report, numbers: Numbers) -> None:
    moments = [numbers_of(numbers)[entry] for entry in PAIRS[:3]]
    for what, group in (("the mass is", [numbers.mass]), ("all moments of inertia are", moments)):
        if not any(number.printed for number in group):
            reason = f"{what} rounded to zero: {more_digits(report.program)}"
            raise ReportError(report.program, reason)


def _reasons_of_both(reasons: dict[int, list[str]]) -> list[str]:
    """Return the reasons shared by both signs, or else the shorter list."""
    both = [reason for reason in reasons[1] if reason in reasons[-1]]
    return both or min(reasons[1], reasons[-1], key=len)


def _moments(numbers: Numbers, sign: int) -> tuple[str, str, str, str, str, str]:
    texts = []
    for entry in PAIRS:
        factor = 1 if entry[0] == entry[1] else sign
        if numbers.about_origin is not None:
            texts.append(numbers.about_origin[entry].text(factor))
        else:
            assert numbers.about_com is not None
            texts.append(_moved(numbers.about_com[entry], moved(numbers, entry, 1).value, factor))
    return texts[0], texts[1], texts[2], texts[3], texts[4], texts[5]


def _moved(entry: Quantity, arm: Fraction, sign: int) -> str:
    """Return an entry with what it has more at the origin, to its own last digit.

    However few digits mass and CoM have: the tensor at the CoM is to be found again.
    """
    if not arm:
        return entry.text(sign)
    return Rounded(sign * entry.value + arm, entry.error).text()


def _notes(report: Report, numbers: Numbers) -> list[str]:
    notes = list(report.notes)
    if report.is_overridden:
        notes.append("numbers of the report were overridden by hand")
    for name in report.systems:
        if not has_default_name(name):
            notes.append(
                f"the numbers are in the coordinate system '{name}', which must be the link's frame"
            )
    if numbers.about_origin is None:
        notes.append("the moments are moved from the CoM to the origin of the coordinate system")
    few = _few_digits(numbers)
    if few:
        notes.append(f"{listed(few)}: {more_digits(report.program)}")
    notes += _density(report, numbers)
    return notes


def _few_digits(numbers: Numbers) -> list[str]:
    moments = min(numbers_of(numbers)[entry].n_digits for entry in PAIRS[:3])
    carried = (
        ("the mass", numbers.mass.n_digits, _ENOUGH_FOR_MASS),
        ("a moment of inertia", moments, _ENOUGH),
    )
    return [
        f"{what} has {counted(digits, 'significant digit')}"
        if digits
        else f"{what} is rounded to zero"
        for what, digits, enough in carried
        if digits < enough
    ]


def _on_signs(report: Report, sign: int | None, is_proved: bool) -> Iterator[str]:
    notation = f" (the report says '{report.notation}')" if report.notation else ""
    if sign is None:
        yield (
            "the sign of the products is unproved: Ixy, Ixz and Iyz are written as reported, "
            f"{alternatives(_SIGNS.values())} they fit the other numbers{notation}"
        )
    elif not is_proved:
        yield (
            f"no number of the report proves the sign of the products: {report.program} documents "
            f"them {_SIGNS[sign]}{notation}"
        )


def _density(report: Report, numbers: Numbers) -> list[str]:
    density, volume = report.density, report.volume
    if density is None or volume is None or not density.factor or not volume.factor:
        return []
    found = density.bounds * volume.bounds
    if report.is_overridden or found.agrees_with(numbers.mass.bounds):
        return []
    mass = float(Fraction(numbers.mass.value))
    return [f"the mass is {mass:.9g} kg, but density times volume is {float(found.value):.9g} kg"]
