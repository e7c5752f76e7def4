"""The output of `kindsl compute` for people: aligned numbers with units."""

from collections.abc import Iterator, Sequence

import numpy as np

from kindsl.language.text.phrases import counted
from kindsl.mechanics.rigid.pose import PLAIN, angles
from kindsl.products.reports.columns import aligned
from kindsl.products.reports.computation import Results
from kindsl.products.reports.robot_text import printable_lines
from kindsl.robots.mechanism.total_mass import total_mass

_POSITION = {"revolute": "rad", "prismatic": "m"}
_FORCE = {"revolute": "N m", "prismatic": "N"}
_ROUNDING = 1e-12
_HALF_DIGIT = 5e-5
_BASE_ROWS = ("base wx", "base wy", "base wz", "base vx", "base vy", "base vz")


def computed_text(results: Results) -> str:
    """Return a section a configuration."""
    return printable_lines("\n".join(_parts(results)))


def _parts(results: Results) -> Iterator[str]:
    head = results.head()
    base = "floating" if head["floating"] else "fixed"
    links = counted(len(head["links"]), "link")
    yield f"{head['robot'] or '(unnamed)'}: {base} base, {links}\n"
    if head["parameters"]:
        yield aligned([(name, _text(value)) for name, value in head["parameters"].items()])
    for k in range(results.n_configurations):
        if results.n_configurations > 1:
            yield f"--- configuration {k + 1} ---\n"
        yield _joints(results, k)
        yield _poses(results, k)
        yield _masses(results, k)
        yield _inertia(results, k)


def _joints(results: Results, k: int) -> str:
    bodies, found, inputs = results.mechanism.bodies, results.quantities, results.inputs
    first = bodies.n_velocities - bodies.n_links
    columns = [inputs["q"][k], inputs["qd"][k]]
    forward = "tau" in inputs
    columns += [inputs["tau"][k], found["qdd"][k]] if forward else [
        inputs["qdd"][k], found["inverse_dynamics"][k]]  # fmt: skip
    columns += [found[name][k][first:] for name in ("gravity_torque", "bias_torque")]
    last = ("tau", "-> qdd") if forward else ("qdd", "-> tau")
    rows: list[Sequence[str]] = [("joint", "q", "", "qd", *last, "gravity", "bias", "")]
    for i, name in enumerate(bodies.joint_names):
        q, *others = (_text(column[i]) for column in columns)
        kind = bodies.joint_kinds[i]
        rows.append((name, q, _POSITION[kind], *others, _FORCE[kind]))
    return aligned(rows, frozenset((1, 3, 4, 5, 6, 7)))


def _poses(results: Results, k: int) -> str:
    rows: list[Sequence[str]] = [
        ("pose in the base", "x / m", "y / m", "z / m", "rx / rad", "ry / rad", "rz / rad")
    ]
    for name, poses in results.poses.items():
        pose = poses[k]
        numbers = (*pose[:3, 3], *angles(pose[:3, :3].tolist(), PLAIN))
        rows.append((name, *(_fixed(value) for value in numbers)))
    return aligned(rows, frozenset(range(1, 7)))


def _masses(results: Results, k: int) -> str:
    found = results.quantities
    com = ", ".join(_text(value) for value in found["com"][k])
    weight = total_mass(results.analysis.model, results.analysis.context.values)
    of = "" if weight.is_whole else " of what is known"
    mass = weight.explained(f"{_text(found['mass'][k])} kg")
    has_com = not np.isnan(found["com"][k]).any()
    text = f"mass {mass}, centre of mass{of} ({com}) m\n" if has_com else f"mass {mass}\n"
    if "base_acceleration" in found:
        acceleration = ", ".join(_text(value) for value in found["base_acceleration"][k])
        text += f"base acceleration ({acceleration}) rad/s^2, m/s^2\n"
    return text


def _inertia(results: Results, k: int) -> str:
    bodies = results.mechanism.bodies
    names = (*(_BASE_ROWS if bodies.is_floating else ()), *bodies.joint_names)
    matrix = results.quantities["joint_space_inertia"][k]
    rows: list[Sequence[str]] = [("joint-space inertia", *(str(i) for i in range(len(names))))]
    rows += [
        (f"{i} {name}", *(_fixed(value) for value in matrix[i])) for i, name in enumerate(names)
    ]
    return aligned(rows, frozenset(range(1, len(names) + 1)))


def _fixed(value: float) -> str:
    return f"{0.0 if abs(value) < _HALF_DIGIT else value:.4f}"


def _text(value: float) -> str:
    """Return a number; what is smaller than a rounding error is zero."""
    return f"{0.0 if abs(value) < _ROUNDING else value:.6g}"
