"""The program that wrote a report."""

import re

UNKNOWN = "a CAD program"

_PROGRAMS = (
    ("FreeCAD", r"freecad|\bMatrix ?\(\(|\bVector ?\(|MatrixOfInertia|\bJo[xyz]\b"),
    ("Onshape", r"onshape"),
    ("Inventor", r"inventor|physical properties for|negative integral|relative error"
                 r"|with respect to global|mass moments"),
    ("Creo", r"\bcreo\b|\bpro/engineer|coordinate frame|mass properties of the (?:part|assembly)"),
    ("Fusion 360", r"fusion|at center of mass\s*[(\[]|at origin\b|world x, ?y, ?z"),
    ("SolidWorks", r"solidworks|output coordinate system|mass properties of|overridden"
                   r"|\bPx\s*=|principal axes of inertia"),
    ("Onshape", r"\bL[xyz]{2}\b|mass properties"),
)  # fmt: skip


def program_of(text: str) -> str:
    """Return the name of the program that wrote a report."""
    for name, pattern in _PROGRAMS:
        if re.search(pattern, text, re.IGNORECASE):
            return name
    return UNKNOWN
