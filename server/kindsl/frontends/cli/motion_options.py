"""The configurations for `kindsl compute`, from options or from a JSON file."""

import argparse
import json
import sys

from kindsl.frontends.cli.documents.sources import STDIN
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


def motions_of(
    args: argparse.Namespace, robot: ConfigurationSpace, settings: Settings
) -> list[Motion]:
    """Return the configurations that the options give.

    Raises:
        MotionError: One does not fit the robot, or the file cannot be read.
    """
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
