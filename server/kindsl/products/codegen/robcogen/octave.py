"""RobCoGen's functions in Octave and MATLAB: transforms, Jacobians, inertia, inverse dynamics."""

from collections.abc import Mapping, Sequence

from kindsl.mechanics.dynamics.generation.emitters.straight_line import computed, operation_text
from kindsl.mechanics.dynamics.generation.terms import Operand, Scalar, Term
from kindsl.mechanics.dynamics.generation.vectors import Matrix, transpose
from kindsl.products.codegen.filling import template
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.robcogen.inertia_properties import ten_of
from kindsl.products.codegen.robcogen.jacobians import jacobian_columns
from kindsl.products.codegen.robcogen.robot import GeneratedRobot
from kindsl.products.codegen.robcogen.transforms import KINDS, matrix_of
from kindsl.products.codegen.robcogen.wanted_names import jacobian_pairs, transform_pairs

_INERTIA = template("robcogen/inertiaProperties.m")

_FIXED = """\
function tau = inverseDynamics(ip, xm, qd, qdd, varargin)
% The joint forces of a motion, gravity acting along the base's -z.
%
% Joint positions q may follow, which xm is updated for, and a cell array of the wrenches on the
% links in their own coordinates.
"""

_FLOATING = """\
function [tau, @BASE@_a] = inverseDynamics(ip, xm, @BASE@_v, gravity, qd, qdd, varargin)
% The joint forces of a motion, and the acceleration of the base, which is free.
%
% Velocity and gravity are six numbers in base coordinates, angular part first. Joint positions q
% may follow, which xm is updated for, and a cell array of the wrenches on base and links in their
% own coordinates.
"""

_PASSES = template("robcogen/inverseDynamics.m")

_FIXED_REST = """\
    tau = zeros(n, 1);
    for i = n:-1:1
        tau(i) = f(axes(i), i + 1);
        p = parents(i) + 1;
        f(:, p) = f(:, p) + xm.(across{i})' * f(:, i + 1);
    end
"""

_FLOATING_BASE = """\
    v(:, 1) = @BASE@_v(:);
    Ic = cell(1, n + 1);
    Ic{1} = ip.lf_@BASE@.tensor6D;
    f(:, 1) = -motion_cross(v(:, 1))' * Ic{1} * v(:, 1);
    if ~isempty(fext)
        f(:, 1) = f(:, 1) - fext{1}(:);
    end
"""

_FLOATING_REST = template("robcogen/inverseDynamics_floating.m")

_FIXED_BASE = """\
    a(6, 1) = 9.81;
"""


def octave_files(library: Library) -> dict[str, str]:
    """Return the text of each function's file by its name."""
    robot = GeneratedRobot(library)
    poses = [(pair, *robot.pose_in(pair.base, pair.target)) for pair in transform_pairs(robot)]
    files: dict[str, str] = {}
    for kind in KINDS:
        letter = f"_X{kind.letter.upper()}_"
        matrices = {
            f"{pair.base.name}{letter}{pair.target.name}": matrix_of(kind.letter, E, p)
            for pair, E, p in poses
        }
        files |= _matrix_files(robot, f"{kind.name}Transforms", matrices)
    jacobians = {p.name: transpose(jacobian_columns(robot, p)) for p in jacobian_pairs(robot)}
    files |= _matrix_files(robot, "Jacobians", jacobians)
    files["inertiaProperties.m"] = _inertia(robot)
    files["inverseDynamics.m"] = _inverse_dynamics(robot)
    return {name: _stamped(library, text) for name, text in files.items()}


def _matrix_files(
    robot: GeneratedRobot, what: str, matrices: Mapping[str, Matrix]
) -> dict[str, str]:
    """Return the functions that make matrices with their constants, and that set what varies."""
    fixed, varying = [], {}
    for name, rows in matrices.items():
        fixed.append(f"    tr.{name} = zeros({len(rows)}, {len(rows[0])});")
        for i, row in enumerate(rows, start=1):
            for j, entry in enumerate(row, start=1):
                if isinstance(entry, Term):
                    varying[f"out.{name}({i}, {j})"] = entry
                elif entry:
                    fixed.append(f"    tr.{name}({i}, {j}) = {entry!r};")
    q = {x.index: f"q({k})" for k, x in enumerate(robot.library.inputs.q, start=1)
         if isinstance(x, Term)}  # fmt: skip
    lines = _lines(robot, varying, q)
    start = "    tr = struct();\n" if not fixed else ""
    made = f"function tr = init{what}(varargin)\n{start}{_joined(fixed)}end\n"
    updated = (
        f"function out = update{what}(tr, q, params)\n{_defaults(robot, 3)}    out = tr;\n"
        f"{_joined(lines)}end\n"
    )
    return {f"init{what}.m": made, f"update{what}.m": updated}


def _inertia(robot: GeneratedRobot) -> str:
    lines = []
    for body in robot.inertial_bodies:
        ten = ten_of(robot, body)
        values = {f"m{body}({k})": value for k, value in enumerate(ten, start=1)}
        lines += _lines(robot, values, {})
        m = list(values)
        lines.append(
            f"    ip.lf_{robot.bodies[body]} = properties({m[0]}, [{m[1]}; {m[2]}; {m[3]}], "
            f"[{m[4]}, {m[5]}, {m[6]}; {m[5]}, {m[7]}, {m[8]}; {m[6]}, {m[8]}, {m[9]}]);"
        )
    return robot.filled(_INERTIA, DEFAULTS=_defaults(robot, 1), LINES=_joined(lines))


def _inverse_dynamics(robot: GeneratedRobot) -> str:
    tree, links = robot.tree, robot.tree.links()
    quoted = (f"'{robot.across(i).replace('_X_', '_XM_')}'" for i in links)
    parts = (_FLOATING, _FLOATING_BASE, _FLOATING_REST) if robot.is_floating else (
        _FIXED, _FIXED_BASE, _FIXED_REST
    )  # fmt: skip
    head, base, rest = (robot.filled(part) for part in parts)
    return head + robot.filled(
        _PASSES,
        NAMES=", ".join(f"'lf_{robot.bodies[i]}'" for i in links),
        ACROSS=", ".join(quoted),
        PARENTS=", ".join(str(tree.parents[i]) for i in links),
        AXES=", ".join("3" if tree.kinds[i] == "revolute" else "6" for i in links),
        BASE_MOTION=base,
        FEXT="1" if robot.is_floating else "0",
        REST=rest,
    )


def _lines(
    robot: GeneratedRobot, values: Mapping[str, Scalar], inputs: Mapping[int, str]
) -> list[str]:
    """Return the statements that compute values and put each in its place."""
    graph, library = robot.library.robot.graph, robot.library
    known = dict(inputs)
    for name, parameter in library.robot.parameters.items():
        known[parameter.index] = f"params.{library.parameter_names[name]}"

    def word(operand: Operand) -> str:
        if isinstance(operand, int):
            return known.get(operand) or f"x{operand}"
        return f"({operand!r})"

    lines = []
    for node in computed(graph, list(values.values()), known):
        operation, *operands = graph.nodes[node]
        text = operation_text(operation, [word(operand) for operand in operands])
        lines.append(f"    x{node} = {text};")
    for place, value in values.items():
        lines.append(f"    {place} = {word(value.index if isinstance(value, Term) else value)};")
    return lines


def _defaults(robot: GeneratedRobot, position: int) -> str:
    """Return the statements that set parameters which are not given."""
    library = robot.library
    if not library.parameter_names:
        return ""
    values = (repr(v) if v is not None else "NaN" for v in library.defaults.values())
    fields = "".join(
        f"        params.{safe} = {value};\n"
        for safe, value in zip(library.parameter_names.values(), values, strict=True)
    )
    return f"    if nargin < {position}\n{fields}    end\n"


def _joined(lines: Sequence[str]) -> str:
    return "".join(f"{line}\n" for line in lines)


def _stamped(library: Library, text: str) -> str:
    """Return a function with the place that it is from behind its head and help."""
    stamp = library.stamp
    return f"{text}% Generated by {stamp.generator} from {stamp.document}; do not edit.\n"
