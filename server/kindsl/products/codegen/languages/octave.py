"""RobCoGen's functions in Octave and MATLAB: transforms, Jacobians, inertia, inverse dynamics."""

from collections.abc import Mapping

from kindsl.mechanics.dynamics.generation.emitters.straight_line import Notation, computed
from kindsl.mechanics.dynamics.generation.terms import Scalar, Term
from kindsl.mechanics.dynamics.generation.vectors import Matrix, transpose
from kindsl.products.codegen.language import Language
from kindsl.products.codegen.library import Library
from kindsl.products.codegen.robcogen.dynamics_kernels import ten_of
from kindsl.products.codegen.robcogen.robot import GeneratedRobot
from kindsl.products.codegen.robcogen.transforms import KINDS, jacobian_columns, matrix_of
from kindsl.products.codegen.robcogen.wanted_names import jacobian_pairs, transform_pairs


def octave_files(library: Library) -> dict[str, str]:
    """Return the text of each function's file by its name."""
    robot = GeneratedRobot(library)
    names = robot.frame_names
    poses = [(pair, *robot.pose_in(pair.base, pair.target)) for pair in transform_pairs(robot)]
    files: dict[str, str] = {}
    for kind in KINDS:
        letter = f"_X{kind.letter.upper()}_"
        matrices = {
            letter.join(names[f.name] for f in (pair.base, pair.target)): matrix_of(
                kind.letter, E, p
            )
            for pair, E, p in poses
        }
        files |= _matrix_files(robot, f"{kind.name}Transforms", matrices)
    jacobians = {p.name: transpose(jacobian_columns(robot, p)) for p in jacobian_pairs(robot)}
    files |= _matrix_files(robot, "Jacobians", jacobians)
    files["inertiaProperties.m"] = _inertia(robot)
    files["inverseDynamics.m"] = robot.rendered("inverseDynamics.m")
    return {name: _stamped(library, text) for name, text in files.items()}


def _matrix_files(
    robot: GeneratedRobot, what: str, matrices: Mapping[str, Matrix]
) -> dict[str, str]:
    """Return the functions that make matrices with their constants, and that set what varies."""
    varying = {
        f"out.{name}({i}, {j})": entry
        for name, rows in matrices.items()
        for i, row in enumerate(rows, start=1)
        for j, entry in enumerate(row, start=1)
        if isinstance(entry, Term)
    }
    q = {x.index: f"q({k})" for k, x in enumerate(robot.library.inputs.q, start=1)
         if isinstance(x, Term)}  # fmt: skip
    lines = _lines(robot, varying, q)
    return {
        f"init{what}.m": robot.rendered("init.m", what=what, matrices=matrices),
        f"update{what}.m": robot.rendered("update.m", what=what, lines=lines),
    }


def _inertia(robot: GeneratedRobot) -> str:
    lines = []
    for body in robot.inertial_bodies:
        ten = ten_of(robot, body)
        values = {f"m{body}({k})": value for k, value in enumerate(ten, start=1)}
        lines += _lines(robot, values, {})
        m = list(values)
        lines.append(
            f"ip.lf_{robot.bodies[body]} = properties({m[0]}, [{m[1]}; {m[2]}; {m[3]}], "
            f"[{m[4]}, {m[5]}, {m[6]}; {m[5]}, {m[7]}, {m[8]}; {m[6]}, {m[8]}, {m[9]}]);"
        )
    return robot.rendered("inertiaProperties.m", lines=lines)


def _lines(
    robot: GeneratedRobot, values: Mapping[str, Scalar], inputs: Mapping[int, str]
) -> list[str]:
    """Return the statements that compute values and put each in its place."""
    graph, library = robot.library.robot.graph, robot.library
    known = dict(inputs)
    for name, parameter in library.robot.parameters.items():
        known[parameter.index] = f"params.{library.parameter_names[name]}"

    def text(node: int) -> str:
        return known.get(node) or f"x{node}"

    notation = Notation("({!r})".format)
    lines = [
        f"x{node} = {notation.operation(graph, node, text)};"
        for node in computed(graph, list(values.values()), known)
    ]
    lines += [f"{place} = {notation.word(value, text)};" for place, value in values.items()]
    return lines


def _stamped(library: Library, text: str) -> str:
    """Return a function with the place that it is from behind its head and help."""
    stamp = library.stamp
    return f"{text}% {stamp.origin}\n% {stamp.licence}\n"


LANGUAGE = Language(
    lambda library, _: octave_files(library),
    frozenset(),
    parameters="all",
    makes_transforms=True,
    is_rigid=True,
    quantities=("inverse_dynamics",),
    renamed=lambda library: GeneratedRobot(library).renamed,
)
