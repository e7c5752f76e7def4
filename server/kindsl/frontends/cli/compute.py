"""Computes poses, inertia and forces of a robot in one or many configurations.

A LIST is numbers separated by commas, one a joint in the order of the links' ids; or NAME=NUMBER
pairs with the names of joints, the others zero. Angles are in radians, lengths in metres.

examples:
  kindsl compute arm.kindsl --q 0.1,-0.5,0.3
  kindsl compute arm.kindsl --q elbow=0.5 --qd elbow=1.0 --output-format text
  kindsl compute arm.kindsl --q-file motion.json --output-format npz -o motion.npz
  kindsl compute arm.kindsl --forward --tau elbow=2.0
"""

import argparse
import json
import math
import sys
from typing import TYPE_CHECKING

from kindsl.frontends.cli.console import is_terminal
from kindsl.frontends.cli.documents.document_reading import (
    CommandError,
    model_errors,
    note_errors,
    note_readings,
    read_named,
    refusals,
    require_syntax,
)
from kindsl.frontends.cli.documents.sources import STDIN
from kindsl.frontends.cli.documents.writing import write_output
from kindsl.frontends.cli.options import add_robot_arguments
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.settings import PoseError, Settings, pose_named
from kindsl.language.text.regular import content_of
from kindsl.products.reports.motions import (
    KEYS,
    ConfigurationSpace,
    Motion,
    MotionError,
    motion,
    motions_from,
)

if TYPE_CHECKING:
    from kindsl.robots.mechanism.build import Mechanism

SUMMARY = "compute poses, inertia and forces"
FORMATS = ("json", "text", "npz")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add = parser.add_argument
    add("--q", metavar="LIST", help="joint positions (default: zero)")
    add("--pose", metavar="NAME", help="joint positions of a pose in kindsl.toml: [poses.NAME]")
    add("--qd", metavar="LIST", help="joint velocities")
    add("--qdd", metavar="LIST", help="joint accelerations")
    add(
        "--base-velocity",
        metavar="LIST",
        help="velocity of a floating base: three angular, three linear",
    )
    add("--q-file", metavar="JSON", help="an object with q, qd, ..., or an array of them")
    usual, told = (0.0, 0.0, -9.81), "m/s² in the base's frame (default: 0,0,-9.81)"
    add("--gravity", metavar="X,Y,Z", type=_gravity, default=usual, help=told)
    add("--forward", action="store_true", help="compute accelerations from forces")
    add("--tau", metavar="LIST", help="with --forward: joint forces")
    add("--output-format", choices=FORMATS, help="default: text on a terminal, json elsewhere")
    add("-o", "--output", metavar="FILE", help="write to this file instead of stdout")
    add_robot_arguments(parser)


def run(args: argparse.Namespace) -> int:
    """Compute and show.

    Returns:
        0; 1 if the document gives no mechanism; 2 for wrong usage or what cannot be read.
    """
    analysis = read_named(args)
    require_syntax(args.file, analysis)
    with model_errors(args.file, analysis):
        mechanism = analysis.mechanism()
    note_readings(args.file, analysis)
    note_errors(args.file, analysis)
    robot = ConfigurationSpace(mechanism.bodies.joint_names, mechanism.bodies.is_floating)
    with refusals("kindsl compute", MotionError):
        motions = _motions_of(args, robot, analysis.settings)
    write_output(args.output or STDIN, _computed(args, analysis, mechanism, motions))
    return 0


def _computed(
    args: argparse.Namespace, analysis: Analysis, mechanism: "Mechanism", motions: list[Motion]
) -> str | bytes:
    from kindsl.products.reports.computation import compute

    with refusals(args.file, ValueError, status=1):
        results = compute(analysis, mechanism, motions, args.gravity, is_forward=args.forward)
    is_read_at_once = args.output is None and is_terminal(sys.stdout)
    output_format = args.output_format or ("text" if is_read_at_once else "json")
    if output_format == "json":
        return json.dumps(results.as_json()) + "\n"
    if output_format == "npz":
        if is_read_at_once:
            raise CommandError.about("kindsl compute", "npz is for a file: --output FILE")
        return results.as_npz()
    from kindsl.products.reports.computed_text import computed_text

    return computed_text(results)


def _gravity(text: str) -> tuple[float, float, float]:
    try:
        numbers = [float(part) for part in text.strip("[]() ").split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != 3 or not all(map(math.isfinite, numbers)):
        raise argparse.ArgumentTypeError(f"'{text}' is not three numbers X,Y,Z")
    return numbers[0], numbers[1], numbers[2]


def _motions_of(
    args: argparse.Namespace, robot: ConfigurationSpace, settings: Settings
) -> list[Motion]:
    options = {key: f"--{key.replace('_', '-')}" for key in KEYS}
    given = {key: getattr(args, key) for key in KEYS if getattr(args, key) is not None}
    if args.tau is not None and not args.forward:
        raise MotionError("--tau needs --forward")
    if args.forward and args.qdd is not None:
        raise MotionError("--qdd cannot be used with --forward")
    if args.pose is not None:
        if args.q is not None or args.q_file is not None:
            raise MotionError("--pose cannot be combined with --q or --q-file")
        try:
            given["q"] = dict(pose_named(settings, args.pose, robot.joints))
        except PoseError as error:
            raise MotionError(str(error)) from None
    if args.q_file is None:
        values = {
            key: text if isinstance(text, dict) else _listed(options[key], text)
            for key, text in given.items()
        }
        return [motion(values, robot, options)]
    if given:
        raise MotionError(f"{options[next(iter(given))]} cannot be combined with --q-file")
    return motions_from(_content_of(args.q_file), robot, args.q_file)


def _content_of(path: str) -> object:
    try:
        if path == STDIN:
            return json.load(sys.stdin)
        return json.loads(content_of(path).decode("utf-8-sig"))
    except OSError as error:
        raise MotionError(f"{path}: cannot be read: {error.strerror}") from None
    except json.JSONDecodeError as error:
        place = f"{path}:{error.lineno}:{error.colno}"
        raise MotionError(f"{place}: not valid JSON: {error.msg}") from None
    except (UnicodeDecodeError, RecursionError):
        raise MotionError(f"{path}: is not JSON in UTF-8") from None


def _listed(name: str, text: str) -> list[float] | dict[str, float]:
    """Return `1,2` as a list and `a=1,b=2` as a dictionary."""
    parts = [part.strip() for part in text.strip("[]() ").split(",") if part.strip()]
    if any("=" in part for part in parts):
        pairs = [part.partition("=") for part in parts]
        return {key.strip(): _number(name, value) for key, _, value in pairs}
    return [_number(name, part) for part in parts]


def _number(name: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise MotionError(f"{name} holds '{text}', which is not a number") from None
