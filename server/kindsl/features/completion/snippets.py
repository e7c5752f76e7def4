"""Whole blocks with placeholders, in the formatter's style."""

MOMENT_DEFAULTS = {
    "Ix": "0.01",
    "Iy": "0.01",
    "Iz": "0.01",
    "Ixy": "0.0",
    "Ixz": "0.0",
    "Iyz": "0.0",
}


def link(name: str, number: int) -> str:
    """Return a link with inertia."""
    body = f"id = ${{2:{number}}}\n{inertia(3)}\nchildren {{$0}}"
    return _in_braces(f"link ${{1:{name}}}", body)


def joint(keyword: str, name: str) -> str:
    """Return a joint of the kind that the keyword tells."""
    return _in_braces(f"{keyword} ${{1:{name}}}", _in_braces("ref_frame", pose(2)))


def base(keyword_behind_name: str) -> str:
    """Return a base; `floating` or nothing stands behind its name."""
    head = f"RobotBase ${{1:base}} {keyword_behind_name}".rstrip()
    children = _in_braces("children", "${12:link1} via ${13:joint1}")
    return _in_braces(head, f"{inertia(2)}\n{children}")


def robot() -> str:
    """Return a document with one link and one joint, which nothing is wrong with."""
    children = _in_braces("children", "${3:link1} via ${4:joint1}")
    joint_frame = "translation = (0.0, 0.0, 0.2)\nrotation = (0.0, 0.0, 0.0)"
    blocks = (
        "Robot ${1:Name} {",
        _in_braces("RobotBase ${2:base}", f"{_BASE_INERTIA}\n{children}"),
        _in_braces("link ${3:link1}", f"id = 1\n{_LINK_INERTIA}\nchildren {{$0}}"),
        _in_braces("r_joint ${4:joint1}", _in_braces("ref_frame", joint_frame)) + "\n}\n",
    )
    return "\n\n".join(blocks)


def inertia(first: int = 1) -> str:
    """Return an inertia section, its placeholders counted from `first`."""
    moments = "\n".join(
        f"{name} = ${{{number}:{default}}}"
        for number, (name, default) in enumerate(MOMENT_DEFAULTS.items(), first + 4)
    )
    masses = f"mass = ${{{first}:1.0}}\nCoM = {vector(first + 1)}"
    return _in_braces("inertia_params", f"{masses}\n{moments}")


def pose(first: int = 1) -> str:
    """Return translation and rotation, their placeholders counted from `first`."""
    return f"translation = {vector(first)}\nrotation = {vector(first + 3)}"


def vector(first: int = 1) -> str:
    """Return a vector of three zeros, its placeholders counted from `first`."""
    return f"({', '.join(f'${{{number}:0.0}}' for number in range(first, first + 3))})"


def frame(name: str = "name") -> str:
    """Return an optional frame."""
    return _in_braces(f"${{1:{name}}}", pose(2))


def frames() -> str:
    """Return a section with one optional frame."""
    return _in_braces("frames", frame())


def joint_frame() -> str:
    """Return a joint's frame."""
    return _in_braces("ref_frame", pose())


def children(link: str = "link", joint: str = "joint") -> str:
    """Return a section with one child."""
    return _in_braces("children", f"${{1:{link}}} via ${{2:{joint}}}")


def _in_braces(head: str, body: str) -> str:
    lines = "\n".join(f"    {line}" for line in body.split("\n"))
    return f"{head} {{\n{lines}\n}}"


def _inertia_of(mass: str, com: str, *moments: str) -> str:
    pairs = zip(MOMENT_DEFAULTS, moments, strict=True)
    lines = [f"mass = {mass}", f"CoM = ({com})", *(f"{name} = {text}" for name, text in pairs)]
    return _in_braces("inertia_params", "\n".join(lines))


_BASE_INERTIA = _inertia_of("1.0", "0.0, 0.0, 0.0", *MOMENT_DEFAULTS.values())
_LINK_INERTIA = _inertia_of("1.0", "0.0, 0.0, 0.1", "0.02", "0.02", "0.01", "0.0", "0.0", "0.0")
