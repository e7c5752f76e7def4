"""Places of the masses and moments of an SDF's links."""

from kindsl.comparison.written import INERTIA, WrittenNumber
from kindsl.interchange.written_numbers import FileNumbers, XmlNumbers, keyed

_MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")


def numbers_of_sdf(content: bytes | str) -> FileNumbers:
    """Return the numbers of the inertias along their links' axes, none of what is not XML."""
    xml = XmlNumbers(content)
    found: dict[tuple[str, str, str], WrittenNumber] = {}
    for link in xml.root.iter("link") if xml.root is not None else ():
        name, inertial = link.get("name") or "", link.find("inertial")
        if inertial is None:
            continue
        found |= keyed("link", name, ("mass",), xml.of_text(inertial.find("mass")))
        found |= keyed("link", name, INERTIA[1:4], xml.of_text(inertial.find("pose"))[:3])
        for key, tag in zip(INERTIA[4:], _MOMENTS, strict=True):
            found |= keyed("link", name, (key,), xml.of_text(inertial.find(f"inertia/{tag}")))
    return FileNumbers(found, {})
