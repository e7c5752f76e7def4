"""Models of any size for tests and benchmarks, as text."""

import random
from typing import NamedTuple

LAYOUTS = ("usual", "allman", "one_line")


class Style(NamedTuple):
    """How a model is built and written.

    Attributes:
        tree: `chain`, `tree` (two children a link) or `star`.
        layout: One of `LAYOUTS`.
        is_floating: Whether the base floats.
        has_frames: Whether every fourth link has a frame.
        has_expressions: Whether angles are written with PI and parameters.
        has_comments: Whether there are line comments.
    """

    tree: str = "tree"
    layout: str = "usual"
    is_floating: bool = True
    has_frames: bool = True
    has_expressions: bool = True
    has_comments: bool = True


def random_model(links: int, seed: int = 0, style: Style | None = None) -> str:
    """Return a correct document with that many links and joints.

    Args:
        links: Number of moving links, at least 1.
        seed: Equal seeds give equal texts.
        style: Shape and layout; one after `LAYOUTS` may be chosen with `Style(layout=...)`.
    """
    style = style or Style()
    generator = random.Random(seed)
    children: dict[int, list[int]] = {number: [] for number in range(links + 1)}
    for number in range(1, links + 1):
        children[_parent(number, style.tree)].append(number)
    lines = [f"Robot robot{links} {{", ""]
    floating = " floating" if style.is_floating else ""
    lines += [
        f"RobotBase {_name(0)}{floating} {{",
        *_body(0, children[0], generator, style),
        "}",
        "",
    ]
    for number in range(1, links + 1):
        lines += [f"link {_name(number)} {{", f"    id = {number}"]
        lines += [*_body(number, children[number], generator, style), "}", ""]
    for number in range(1, links + 1):
        lines += _joint(number, generator, style)
    lines.append("}")
    return _laid_out(lines, style.layout)


def _parent(number: int, tree: str) -> int:
    if tree == "chain":
        return number - 1
    return (number - 1) // 2 if tree == "tree" else 0


def _name(number: int) -> str:
    return "trunk" if number == 0 else f"segment_{number}"


def _body(number: int, children: list[int], generator: random.Random, style: Style) -> list[str]:
    mass = round(generator.uniform(0.5, 9.0), 3)
    com = [round(generator.uniform(-0.2, 0.2), 3) for _ in range(3)]
    about_com = [round(generator.uniform(0.010, 0.015) * mass, 4) for _ in range(3)]
    squares = [c * c for c in com]
    moments = [about_com[i] + mass * (sum(squares) - squares[i]) for i in range(3)]
    products = [mass * com[0] * com[1], mass * com[0] * com[2], mass * com[1] * com[2]]
    lines = ["    inertia_params {", f"        mass = {mass}"]
    lines.append(f"        CoM = ({com[0]}, {com[1]}, {com[2]})")
    for name, value in zip(
        ("Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz"), moments + products, strict=True
    ):
        lines.append(f"        {name} = {value:.7f}")
    lines += ["    }", "    children {"]
    lines += [f"        {_name(child)} via joint_{child}" for child in children]
    lines.append("    }")
    if style.has_frames and number % 4 == 0:
        lines += ["    frames {", f"        tip_{number} {{"]
        lines.append(f"            translation = ({_length(generator)}, 0.0, 0.25)")
        lines += ["            rotation = (0.0, 0.0, -PI/2.0)", "        }", "    }"]
    return lines


def _joint(number: int, generator: random.Random, style: Style) -> list[str]:
    kind = "p_joint" if number % 7 == 0 else "r_joint"
    angles = ["0.0, 0.0, 0.0", "PI/2.0, 0.0, 0.0", "0.0, -PI/2.0, PI", "0.0, 0.0, offset"]
    rotation = generator.choice(angles) if style.has_expressions else "0.0, 0.5, 0.0"
    lines = [f"{kind} joint_{number} {{", f"    id = {number}"]
    if style.has_comments and number % 5 == 0:
        lines.append("    // seen from the flange")
    lengths = ", ".join(_length(generator) for _ in range(3))
    lines += ["    ref_frame {", f"        translation = ({lengths})"]
    return [*lines, f"        rotation = ({rotation})", "    }", "}", ""]


def _length(generator: random.Random) -> str:
    return repr(round(generator.uniform(-0.5, 0.5), 3))


def _laid_out(lines: list[str], layout: str) -> str:
    if layout == "allman":
        lines = [part for line in lines for part in _allman(line)]
    elif layout == "one_line":
        lines = [" ".join(line.strip() for line in lines if "//" not in line)]
    return "\n".join(lines) + "\n"


def _allman(line: str) -> list[str]:
    if not line.endswith("{"):
        return [line]
    indent = line[: len(line) - len(line.lstrip())]
    return [line[:-1].rstrip(), indent + "{"]
