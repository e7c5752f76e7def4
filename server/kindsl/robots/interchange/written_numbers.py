"""The numbers of another format's file: what they are of, and where they stand."""

from collections.abc import Mapping, Sequence
from typing import Any

from kindsl.language.semantics.expressions import half_unit
from kindsl.language.text.encodings import decoded
from kindsl.language.text.lines import LineIndex
from kindsl.robots.comparison.written import TextPlace, WrittenNumber
from kindsl.robots.interchange.robot_island import WORD, RobotIsland
from kindsl.robots.interchange.xml_reading import DECIMAL, XmlElement, XmlError, parsed_xml

# By `"link"`, `"joint"` or `"frame"`, its name, and one of `INERTIA`, `POSE` or `AXIS`; of a link,
# `TURNS` are those of the moments' axes.
FileNumbers = Mapping[tuple[str, str, str], WrittenNumber]


class XmlNumbers:
    """Finds numbers in the text of an XML file.

    Attributes:
        root: Its root element, one without anything in it where the text is not XML.
        found: What was found, see `FileNumbers`.
    """

    def __init__(self, content: bytes | str) -> None:
        text = content if isinstance(content, str) else decoded(content)
        self._whole, self._lines = RobotIsland(text, None), LineIndex(text)
        self.found: dict[tuple[str, str, str], WrittenNumber] = {}
        try:
            self.root: Any = parsed_xml(text)
        except XmlError:
            self.root = XmlElement("")

    def keep(
        self, kind: str, owner: str, names: Sequence[str], numbers: Sequence[WrittenNumber]
    ) -> None:
        """Keep numbers by what they are of, where there is one for each name."""
        if len(numbers) == len(names):
            keys = ((kind, owner, name) for name in names)
            self.found.update(zip(keys, numbers, strict=True))

    def keep_place(
        self, kind: str, owner: str, names: Sequence[str], numbers: Sequence[WrittenNumber]
    ) -> None:
        """Keep one place for all that is said there in another form; its values are not known.

        They are no more exact than the numbers there, whole ones apart.
        """
        if numbers:
            places = [number.at for number in numbers if isinstance(number.at, TextPlace)]
            text = " ".join(number.text for number in numbers)
            at = places[0]._replace(end=places[-1].end)
            half = max((number.half for number in numbers if number.value % 1.0), default=0.0)
            whole = WrittenNumber(text, 0.0, half, at, is_implied=True)
            self.found |= {(kind, owner, name): whole for name in names}

    def of_attribute(self, element: Any, name: str) -> list[WrittenNumber]:
        """Return the numbers in an attribute, none where there is no element or attribute."""
        span = None if element is None else self._whole.attribute(element, name)
        return self._numbers(*span) if span else []

    def of_text(self, element: Any) -> list[WrittenNumber]:
        """Return the numbers that an element holds, none without it, or beside a comment."""
        if element is None or not element.text:
            return []
        found = self._numbers(self._whole.tag(element)[1], element.end)
        return found if [number.text for number in found] == element.text.split() else []

    def _numbers(self, start: int, end: int) -> list[WrittenNumber]:
        text, line = self._whole.text, self._lines.position
        spans = (word.span() for word in WORD.finditer(text, start, end))
        return [written_number(text[a:b], TextPlace(line(a)[0] + 1, a, b)) for a, b in spans]


def written_number(text: str, place: TextPlace) -> WrittenNumber:
    """Return a decimal number with its place."""
    if not DECIMAL.fullmatch(text):
        return WrittenNumber(text, float("nan"), 0.0, place)
    return WrittenNumber(text, float(text), half_unit(text), place)
