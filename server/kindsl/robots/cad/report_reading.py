"""The lines of a report, as any of the programs lays them out, to its numbers."""

import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial

from kindsl.robots.cad.number_style import NumberStyle, number_styles, with_joined_numbers
from kindsl.robots.cad.programs import program_of
from kindsl.robots.cad.quantity import Quantity
from kindsl.robots.cad.report import PAIRS, Entry, Report, ReportError
from kindsl.robots.cad.unit import DENSITY, INERTIA, LENGTH, MASS, VOLUME, Dimension, unit

_MINUS = str.maketrans("−–‐‑\t", "---- ")
_FRAME = re.compile(r"^\s*(?:(?://|#|%|;|>|\*)+\s*)?|^\s*\|?(?::?-+:?\|)+\s*$")
_REMARK = re.compile(
    r"\(\s*(?:relative )?error\b[^()]*\)|\brelative error\s*=\s*\S+%?", re.IGNORECASE
)
_NAME = re.compile(
    r"^\W*(?:mass propert\w+ of|physical propert\w+ (?:for|of)|part\b|assembly\b|body|bodies|name\b"
    r"|component|file|document|configuration|coordinate system|material|physical material"
    r"|requested|accuracy|date|appearance|\*)",
    re.IGNORECASE,
)
_BODY = re.compile(
    r"^\W*(?:mass propert\w+ of(?: the (?:part|assembly))?|physical propert\w+ (?:for|of)"
    r"|(?:body|part|component)(?: name)?\s*[:=])\s*(?P<name>\S.*?)\s*$",
    re.IGNORECASE,
)
_SEVERAL = re.compile(r"\b(?:[2-9]|\d\d+) (?:parts|bodies|components|solids)\b|selected ", re.I)
_SYSTEM = re.compile(
    r"coordinate system\s*[:=]\s*(?P<a>\S.*?)\s*$"
    r"|in the coordinate system of\s+(?P<b>\S.*?)\.?\s*$"
    r"|with respect to\s+(?P<c>\S+)\s+coordinate (?:frame|system)",
    re.IGNORECASE,
)
_CENTER = re.compile(
    r"cent(?:er|re)s? ?of ?(?:mass|gravity)|\bcentroid\b|\b(?:com|cog)\b", re.IGNORECASE
)
_INERTIA = re.compile(r"inertia|mass moments|principal (?:axes|moments)", re.IGNORECASE)
_TAKEN = re.compile(r"^\W*(?:moments? )?(?:are )?(?:taken|calculated|expressed|about|at)\b", re.I)
_ORIGIN = re.compile(
    r"output coordinate system|\borigin\b|\bglobal\b|\bworld\b|with respect to .*coordinate"
    r"|coordinate (?:frame|system)",
    re.IGNORECASE,
)
_OTHER = re.compile(
    r"^\W*(?:radi(?:i|us) of gyration|rotation|angles|bounding|length|width|height|world|surface"
    r"|area|general|material|configuration|cent(?:er|re) of volume)",
    re.IGNORECASE,
)
_MASS = re.compile(
    r"^\W*(?:total |body |part )?(?:mass|weight)\b(?!\s*(?:propert|moment|center))"
    r"(?P<remark>[^=:\d-]*)",
    re.IGNORECASE,
)
_SCALAR = re.compile(
    r"^\W*(?:average |overall )?(?P<name>density|volume)\b(?P<remark>[^=:\d-]*)", re.I
)
_NOTATION = re.compile(r"positive tensor notation|negative integral|positive integral", re.I)
_BRACKETED = re.compile(r"[(\[]([^()\[\]]*)[)\]]")
_ENTRY = re.compile(r"(?<![A-Za-z_])([LIJ])(?:[oOcC])?_?([xyzXYZ])([xyzXYZ])?(?![A-Za-z_0-9])")
_PLACE = re.compile(r"(?<![A-Za-z_])(?:[Cc]_?)?([XYZxyz])(?:[cC]|bar|cg|com)?(?![A-Za-z_0-9])")
_PRINCIPAL = re.compile(r"(?<![A-Za-z_])[PIJ]_?([xyzXYZ123])(?![A-Za-z_0-9])")
_AXIS = re.compile(r"(?<![A-Za-z_])I_?([xyzXYZ123])\s*[=:]\s*[(\[]([^()\[\]]*)[)\]]")
# Blanks of print, where they do not group digits.
_BLANK = re.compile(r"(?<!\d)[\xa0\u2007\u2009\u202f]|[\xa0\u2007\u2009\u202f](?!\d{3})")
# Lines of a report itself, not of what stands before and behind it.
_LABELLED = re.compile(
    r"^\W*(?:\w+ )?(?:mass|weight|density|volume)\b|inertia|cent(?:er|re) of"
    r"|^[\W\de]*\d[.,]\d[\W\de]*$"
    r"|\b(?:[LIJP][oc]?_?[xyz123]{1,2}|[XYZ])[\s=:]+[-+(]?\s*[\d.,]",
    re.IGNORECASE,
)
_INDEX = {"x": 0, "y": 1, "z": 2, "1": 0, "2": 1, "3": 2}
_DEFAULT_SYSTEM = re.compile(r"^\W*default\W*$|^_|^global$|^origin$|csys_def$", re.IGNORECASE)


def readings(text: str) -> Iterator[Callable[[], Report]]:
    """Yield what reads a report; two where a comma may be a decimal mark or group digits.

    Raises:
        ReportError: Some number has a decimal comma and another one a decimal point.
    """
    text = _BLANK.sub(" ", text)
    lines = [_FRAME.sub("", line.translate(_MINUS), count=1) for line in text.splitlines()]
    lines = [with_joined_numbers(_REMARK.sub("", line).replace("|", "  ")) for line in lines]
    labelled = [at for at, line in enumerate(lines) if _LABELLED.search(line)]
    own = lines[labelled[0] : labelled[-1] + 1] if labelled else lines
    styles = number_styles([line for line in own if not _NAME.match(line)])
    if not styles:
        reason = "the report has decimal points and decimal commas"
        raise ReportError(program_of(text), reason)
    for style in styles:
        yield partial(_ReportReader(program_of(text), style).read, lines)


class _ReportReader:
    """Reads line by line; what a heading says holds until the next one."""

    def __init__(self, program: str, style: NumberStyle) -> None:
        self.report = Report(program)
        self.style = style
        self.section = self.about = self.unit_text = self.tensor = ""
        self.rows = 0
        if style.has_commas:
            self.report.notes.append("decimal commas are read as decimal points")
        if style.has_groups:
            self.report.notes.append("marks between groups of three digits are left out")

    def read(self, lines: list[str]) -> Report:
        for line in lines:
            if line.strip():
                self._line(line)
        return self.report

    def _line(self, line: str) -> None:
        report = self.report
        self._remarks(line)
        scalar = _SCALAR.match(line)
        if scalar is not None:
            self._scalar(line, scalar)
        elif (mass := _MASS.match(line)) and not _INERTIA.search(line):
            self._mass(line, mass)
        elif _TAKEN.match(line) and self.section in ("tensor", "principal"):
            self._place(line)
        elif _OTHER.match(line) and not _ENTRY.search(line):
            self.section = ""
        elif _INERTIA.search(line) and not (_BODY.match(line) or _SYSTEM.search(line[:20])):
            self._inertia(line)
        elif (center := _CENTER.search(line)) and not _NAME.match(line):
            self.section = "center"
            self.unit_text = _last_unit(line, LENGTH)
            self._values(line, center.end())
        elif self.section and not _NAME.match(line):
            self._values(line, 0)
        if _SEVERAL.search(line) and _NAME.match(line) and line.strip() not in report.bodies:
            report.bodies.append(line.strip())

    def _remarks(self, line: str) -> None:
        report = self.report
        report.is_overridden |= "overrid" in line.casefold()
        body, system, notation = _BODY.match(line), _SYSTEM.search(line), _NOTATION.search(line)
        if body is not None and body["name"] not in report.bodies:
            report.bodies.append(body["name"])
        if system is not None:
            name = next(filter(None, system.groups())).strip("-' \"")
            if name not in report.systems:
                report.systems.append(name)
        if notation is not None:
            report.notation = notation[0].casefold()

    def _scalar(self, line: str, match: re.Match[str]) -> None:
        name = match["name"].casefold()
        found = self._first(line, match, DENSITY if name == "density" else VOLUME)
        if found is not None:
            setattr(self.report, name, found._replace(name=name))
        self.section = ""

    def _mass(self, line: str, match: re.Match[str]) -> None:
        found = self._first(line, match, MASS)
        if found is not None:
            self.report.masses.append(found._replace(name="mass"))
            self.section = ""

    def _first(self, line: str, match: re.Match[str], dimension: Dimension) -> Quantity | None:
        """Return the first number after a word, with the unit after or before it."""
        for start, end, number in self.style.numbers(line):
            if start >= match.end():
                remark = _last_unit(match["remark"], dimension)
                factor = _factor(line[end:], dimension) or _factor(remark, dimension)
                return number._replace(factor=factor or Fraction(0))
        return None

    def _place(self, line: str) -> None:
        if _CENTER.search(line):
            self.about = "com"
        elif _ORIGIN.search(line):
            self.about = "origin"

    def _inertia(self, line: str) -> None:
        entry = _ENTRY.search(line)
        end = entry.start() if entry else len(line)
        heading = line[:end] if _INERTIA.search(line[:end]) else ""
        if heading:
            is_principal = "principal" in heading.casefold()
            is_new = not re.fullmatch(r"\W*inertia (?:tensor|matrix)\W*", heading.strip(), re.I)
            if is_new:
                self.section = "principal" if is_principal else "tensor"
                self.about = self.tensor = ""
                self.unit_text = _last_unit(heading, INERTIA)
                self._place(heading)
            self.rows = 0
        begin = end if entry else _end_of_heading(line)
        self._values(line, begin)

    def _values(self, line: str, begin: int) -> None:
        if self.section == "center":
            self._coordinates(line, begin)
        elif self.section == "tensor":
            self._entries(line, begin)
        elif self.section == "principal":
            self._principal(line, begin)

    def _coordinates(self, line: str, begin: int) -> None:
        labelled = list(self._labelled(line, begin, _PLACE, LENGTH))
        found = [(label[0], _INDEX[label[1].casefold()], number) for label, number in labelled]
        bare = [] if labelled else self._bare(line, begin, LENGTH)
        if len(bare) == 3:
            found = [("XYZ"[index], index, number) for index, number in enumerate(bare)]
        for name, index, number in found:
            self.report.center.setdefault(index, []).append(number._replace(name=name))
        counts = [len(numbers) for numbers in self.report.center.values()]
        if len(counts) == 3 and min(counts) == max(counts):
            self.section = ""

    def _entries(self, line: str, begin: int) -> None:
        labelled = list(self._labelled(line, begin, _ENTRY, INERTIA))
        for label, number in labelled:
            row = _INDEX[label[2].casefold()]
            column = _INDEX[(label[3] or label[2]).casefold()]
            self._add(label[1].upper(), (row, column), number._replace(name=label[0]))
        if not labelled and self._is_tensor_whole():
            self.section = ""
        elif not labelled:
            self._matrix_rows(self._bare(line, begin, INERTIA))

    def _is_tensor_whole(self) -> bool:
        """Return whether a further row, as of a signature or page number, is none of the tensor."""
        tensor = self.report.about_com if self.tensor == "com" else self.report.about_origin
        is_whole = all(pair in tensor or pair[::-1] in tensor for pair in PAIRS)
        return bool(self.tensor) and (self.rows >= 3 or (self.rows == 0 and is_whole))

    def _matrix_rows(self, numbers: list[Quantity]) -> None:
        """Take rows of three numbers, or of four whose last is of a matrix of poses."""
        width = {9: 3, 3: 3, 16: 4, 12: 4, 4: 4}.get(len(numbers))
        if width is None or (width == 4 and self.rows < 3 and numbers[3].printed):
            if len(numbers) > 1:
                reason = f"a row of the matrix of inertia has {len(numbers)} numbers"
                raise ReportError(self.report.program, reason)
            return
        for first in range(0, len(numbers), width):
            if self.rows < 3:
                for column, number in enumerate(numbers[first : first + 3]):
                    name = "I" + "xyz"[self.rows] + "xyz"[column]
                    self._add("I", (self.rows, column), number._replace(name=name))
            self.rows += 1

    def _add(self, letter: str, entry: Entry, number: Quantity) -> None:
        about = self.about or ("com" if letter == "L" else "")
        if not about and self.report.program in ("Onshape", "FreeCAD"):
            about = "com"
        if not about and self.report.about_com:
            about = "origin"
        if not about:
            reason = "the report does not say whether moments are about the CoM or the origin"
            raise ReportError(self.report.program, reason)
        self.tensor = about
        found = self.report.about_com if about == "com" else self.report.about_origin
        found.setdefault(entry, []).append(number)

    def _principal(self, line: str, begin: int) -> None:
        for match in _AXIS.finditer(line, begin):
            numbers = [number for _, _, number in self.style.numbers(match[2])]
            if len(numbers) == 3:
                one = [number._replace(factor=Fraction(1)) for number in numbers]
                self.report.axes[_INDEX[match[1].casefold()]] = one
        line = line[:begin] + _AXIS.sub(lambda m: " " * len(m[0]), line[begin:])
        labelled = list(self._labelled(line, begin, _PRINCIPAL, INERTIA))
        for label, number in labelled:
            index = _INDEX[label[1].casefold()]
            self.report.principal.setdefault(index, []).append(number._replace(name=label[0]))
        if not labelled:
            numbers = self._bare(line, begin, INERTIA)
            if len(numbers) == 3 and not self.report.principal:
                for index, number in enumerate(numbers):
                    self.report.principal[index] = [number._replace(name=f"I{index + 1}")]

    def _labelled(
        self, line: str, begin: int, label: re.Pattern[str], dimension: Dimension
    ) -> Iterator[tuple[re.Match[str], Quantity]]:
        """Yield labels with their numbers: `X = 1 Y = 2`, or `X Y 1 2`."""
        labels = [(match.start(), match) for match in label.finditer(line, begin)]
        waiting: list[re.Match[str]] = []
        for start, number in self._placed(line, begin, dimension):
            while labels and labels[0][0] < start:
                waiting.append(labels.pop(0)[1])
            if waiting:
                yield waiting.pop(0), number

    def _bare(self, line: str, begin: int, dimension: Dimension) -> list[Quantity]:
        return [number for _, number in self._placed(line, begin, dimension)]

    def _placed(
        self, line: str, begin: int, dimension: Dimension
    ) -> Iterator[tuple[int, Quantity]]:
        """Yield where each number of a line begins, and the number with its unit."""
        found = [one for one in self.style.numbers(line) if one[0] >= begin]
        ends = [*(start for start, _, _ in found[1:]), len(line)][: len(found)]
        trailing = _factor(line[found[-1][1] :], dimension) if found else None
        for (start, end, number), stop in zip(found, ends, strict=True):
            own = _factor(line[end:stop], dimension)
            factor = own or _factor(self.unit_text, dimension) or trailing
            yield start, number._replace(factor=factor or Fraction(0))


def _end_of_heading(line: str) -> int:
    match = re.search(r"[:=]\s*(?=[-+\d.(\[])|Matrix|\(\(|\[\[", line)
    return match.start() if match else 0


def _factor(text: str, dimension: Dimension) -> Fraction | None:
    """Return the factor of the unit at the start of a text."""
    words = re.split(r"[,;=:]|\b[LIJPXYZ][oc]?[xyz123]{0,2}\b", text, maxsplit=1)[0]
    words = words.strip(" ()[].\xa0")
    while words:
        found = unit(words)
        if found is not None and found.dimension == dimension:
            return found.factor
        words = words.rpartition(" ")[0].rstrip(" ()[].*·")
    return None


def _last_unit(heading: str, dimension: Dimension) -> str:
    """Return the unit in a heading, in brackets or at its end, or ""."""
    texts = [match[1] for match in _BRACKETED.finditer(heading)][::-1]
    tail = re.split(r"[:,=]| in ", heading.rstrip(" :"))[-1]
    for text in (*texts, tail):
        found = unit(text.strip())
        if found is not None and found.dimension == dimension:
            return text
    return ""


def has_default_name(system: str) -> bool:
    """Return whether a coordinate system is the one that every model has."""
    return _DEFAULT_SYSTEM.search(system) is not None
