"""A user's decisions about the rules: selection, severities, targets, values."""

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING, NamedTuple

from kindsl.judgement.rules.base import Rule, Severity
from kindsl.language.semantics.parameters import Binding, JointProperties
from kindsl.language.text.nearest import hint, nearest_word
from kindsl.language.text.phrases import listed

if TYPE_CHECKING:
    from kindsl.robots.comparison.twins import TwinFile

_FIRST_DIGITS_OF_SYNTAX = "KD0"
# The targets of the rules about what a generator does not support.
_REFUSALS = {"KD601": "robcogen", "KD602": "robcogen2"}


class Settings(NamedTuple):
    """Decisions for one document.

    Attributes:
        targets: The generators that must accept it.
        select: Codes or prefixes to run; empty for the default ones.
        ignore: Codes or prefixes to leave out.
        severity: Severity by code or prefix, the longest match wins.
        joints: Limits of joints.
        poses: Positions of joints by the names of poses, radians or metres.
        known: How often the baseline knows each finding of the document, by its identity.
        twins: Other files of the same robot.
    """

    targets: frozenset[str] = frozenset()
    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    severity: Mapping[str, Severity] = {}
    bindings: Mapping[str, Binding] = {}
    joints: Mapping[str, JointProperties] = {}
    poses: Mapping[str, Mapping[str, float]] = {}
    known: Mapping[str, int] = {}
    version: str = "1.0.0"
    twins: "tuple[TwinFile, ...]" = ()

    def rebound(self, values: Mapping[str, float]) -> "Settings":
        """Return these settings with parameters bound to other values, in their former ranges."""
        known = self.bindings
        new = {name: known.get(name, Binding(v))._replace(value=v) for name, v in values.items()}
        return self._replace(bindings={**known, **new})


class PoseError(ValueError):
    """There is no such pose, or it is not of this robot; the message says so."""


def pose_named(settings: Settings, name: str, joints: Collection[str]) -> Mapping[str, float]:
    """Return the positions of a pose, radians and metres; joints that it does not name are zero.

    Raises:
        PoseError: No pose has this name, or it names a joint that the robot does not have.
    """
    if name not in settings.poses:
        known = f" (known: {', '.join(settings.poses)})" if settings.poses else ""
        near = hint(nearest_word(name, settings.poses), after=",") or known
        raise PoseError(f"kindsl.toml names no pose '{name}'{near}")
    pose = settings.poses[name]
    strange = [f"'{joint}'" for joint in pose if joint not in joints]
    if strange:
        raise PoseError(f"pose '{name}' names {listed(strange)}, which the robot does not have")
    return pose


def is_enabled(rule: Rule, settings: Settings) -> bool:
    """Return whether a rule is to report; the syntax rules always are."""
    if rule.code.startswith(_FIRST_DIGITS_OF_SYNTAX):
        return True
    selected = _longest_match(rule.code, settings.select) if settings.select else ""
    ignored = _longest_match(rule.code, settings.ignore) if settings.ignore else ""
    if settings.select and not selected:
        return False
    if ignored and len(ignored) >= len(selected):
        return False
    return rule.is_default or bool(selected) or _REFUSALS.get(rule.code) in settings.targets


def severity_of(rule: Rule, own: Severity | None, settings: Settings) -> Severity:
    """Return the severity to report: configured, else the finding's own, else the rule's."""
    match = _longest_match(rule.code, tuple(settings.severity))
    return settings.severity[match] if match else own or rule.severity


def _longest_match(code: str, prefixes: tuple[str, ...]) -> str:
    return max((p for p in prefixes if code.startswith(p.upper())), key=len, default="")
