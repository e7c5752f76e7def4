"""Places of the masses and moments of an MJCF's bodies, as far as the file itself gives them."""

from kindsl.comparison.written import INERTIA, WrittenNumber
from kindsl.interchange.written_numbers import FileNumbers, XmlNumbers, keyed


def numbers_of_mjcf(content: bytes | str) -> FileNumbers:
    """Return the numbers of the inertias along their bodies' axes, none of what is not XML."""
    xml = XmlNumbers(content)
    found: dict[tuple[str, str, str], WrittenNumber] = {}
    for body in xml.root.iter("body") if xml.root is not None else ():
        name, inertial = body.get("name") or "", body.find("inertial")
        found |= keyed("link", name, ("mass",), xml.of_attribute(inertial, "mass"))
        found |= keyed("link", name, INERTIA[1:4], xml.of_attribute(inertial, "pos"))
        found |= keyed("link", name, INERTIA[4:7], xml.of_attribute(inertial, "diaginertia"))
        found |= keyed("link", name, INERTIA[4:], xml.of_attribute(inertial, "fullinertia"))
    return FileNumbers(found, {})
