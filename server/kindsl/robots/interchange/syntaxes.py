"""The syntax of a robot's file: told by its name, else by the first words of its text."""

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kindsl.language.syntax.document import SyntaxDocument
    from kindsl.robots.interchange.format import Format

OWN_SUFFIX = ".kindsl"
# Of the other formats that rules judge where they stand.
JUDGED_SUFFIXES = (".urdf", ".sdf")
# Expanded by Python that it holds: judged only where somebody names it.
XACRO_SUFFIX = ".xacro"
_DOCTYPE = r"!DOCTYPE[^\[>]*(?:\[[^\]]*\]\s*)?"
# What begins with comments is read once: each ends where it does first.
_BEFORE_ROOT = rf"\ufeff?\s*(?:<(?>\?.*?\?>|!--.*?-->|{_DOCTYPE}>)\s*)*"
_ROOT = rf"{_BEFORE_ROOT}<(robot|sdf|mujoco(?:include)?)[\s/>]"
_FORMATS = {"robot": "urdf", "sdf": "sdf", "mujoco": "mjcf", "mujocoinclude": "mjcf"}


def other_format(name: str, text: str) -> "Format | None":
    """Return the format of a robot's file, None for a document of the Kinematics-DSL.

    A `.xml` file may hold any of them: its root element decides, as for a name without a suffix.
    """
    suffix = name[name.rfind(".") :].lower() if "." in name else ""
    if suffix == OWN_SUFFIX:
        return None
    root = _root(text)
    if root is None and not suffix:
        return None
    from kindsl.robots.interchange.registry import format_named, format_of_suffix

    found = format_of_suffix(suffix)
    is_told = found is not None and suffix != ".xml"
    return found if is_told or root is None else format_named(_FORMATS[root[1]])


def is_xml_name(name: str) -> bool:
    """Return whether a file is another format's by its name, and nothing of our language."""
    return name.lower().endswith(JUDGED_SUFFIXES)


def syntax_of(name: str, text: str) -> "SyntaxDocument":
    """Return the syntax of a robot's file that is judged where it stands; never raises."""
    root = _root(text)
    kind = "" if root is None or name.endswith(OWN_SUFFIX) else root[1]
    lower = name.lower()
    if lower.endswith(".urdf") or (kind == "robot" and not lower.endswith(".sdf")):
        from kindsl.robots.interchange.urdf.document import urdf_document

        return urdf_document(text)
    if lower.endswith(".sdf") or kind == "sdf":
        from kindsl.robots.interchange.sdf.document import sdf_document

        return sdf_document(text)
    if lower.endswith(".mjcf") or kind.startswith("mujoco"):
        from kindsl.robots.interchange.mjcf.document import mjcf_document

        return mjcf_document(text)
    if lower.endswith(".xml"):
        from kindsl.robots.interchange.xml_document import no_robot, xml_document

        return xml_document(text, of_elements=no_robot)
    from kindsl.language.syntax.document import parse

    return parse(text)


def _root(text: str) -> re.Match[str] | None:
    """Return the beginning of an XML file; other texts need no expression, slow to compile."""
    is_xml = text.removeprefix("\ufeff").lstrip().startswith("<")
    return re.match(_ROOT, text, re.DOTALL) if is_xml else None


def unjudged(text: str) -> "SyntaxDocument":
    """Return a text of which no rule says anything."""
    from kindsl.language.syntax.tree import Island
    from kindsl.robots.interchange.xml_document import XmlDocument

    return XmlDocument([Island(text, (), (), (), (), ())])
