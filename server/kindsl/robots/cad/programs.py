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
    ("Onshape", r"\bL[xyz]{2}\b"),
)  # fmt: skip

# Both document products as entries of the tensor, less than zero where Σ m x y is greater: Onshape
# in evaluate.fs of its standard library ("the 3D inertia tensor"), Creo at pfcMassProperty
# ("trace(CoordSysInertia) * identity - CoordSysInertia"). The others document no sign.
_DOCUMENTED_SIGNS = {"Onshape": -1, "Creo": -1}

# Where a program keeps unit and number of decimals of its report.
_UNIT_SETTINGS = {
    "SolidWorks": "Mass Properties > Options > Use custom settings",
    "Onshape": "Workspace units",
    "Fusion 360": "Preferences > Unit and Value Display",
    "Inventor": "Document Settings > Units",
    "Creo": "Model Properties > Units",
    "FreeCAD": "Preferences > General > Units",
}


def program_of(text: str) -> str:
    """Return the name of the program that wrote a report."""
    for name, pattern in _PROGRAMS:
        if re.search(pattern, text, re.IGNORECASE):
            return name
    return UNKNOWN


def documented_sign(program: str) -> int | None:
    """Return the sign of a program's products beside Σ m x y, None where it documents none."""
    return _DOCUMENTED_SIGNS.get(program)


def more_digits(program: str) -> str:
    """Return how to have a program report more digits, in words."""
    setting = _UNIT_SETTINGS.get(program)
    where = f"in {program} ({setting})" if setting else "in the CAD program"
    return f"set smaller units such as g and mm, or more decimals, {where}"
