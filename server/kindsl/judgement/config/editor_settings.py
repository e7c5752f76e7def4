"""The editor's settings, the section `kindsl`, checked once where they come in."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.config.decisions import overridden
from kindsl.judgement.config.schema import (
    EDITOR_KEYS,
    Given,
    Mistake,
    boolean,
    decisions,
    dotted,
    number,
)

ORIGIN = "editor settings"

_LONGEST_DELAY = 60_000


class EditorSettings(NamedTuple):
    """The user's settings in the editor.

    Attributes:
        rules: Targets, silenced rules, severities, values of parameters.
        diagnostics_delay: Seconds between the last keystroke and the check.
        inlay_hints: Which kinds of inlay hints are wanted; a kind that is not named is.
        problems: A sentence for each setting that is wrong and therefore left out.
    """

    rules: Settings = Settings()
    diagnostics_delay: float = 0.1
    inlay_hints: Mapping[str, bool] = {}
    problems: tuple[str, ...] = ()


def editor_settings(raw: object) -> EditorSettings:
    """Read the section `kindsl`, or an object around it; never raises.

    Args:
        raw: As sent: nested (`{"diagnostics": {"delay": 50}}`) or flat
            (`{"diagnostics.delay": 50}`).
    """
    section = Given(_section(raw), (), [])
    shared = {key: value for key, value in section.value.items() if key in EDITOR_KEYS}
    rules = overridden(Settings(), decisions(section._replace(value=shared), ORIGIN))
    delay = _seconds(section.at("diagnostics").at("delay"))
    hints = _switches(section.at("inlayHints"))
    problems = tuple(map(_problem, section.mistakes))
    return EditorSettings(rules, delay, hints, problems)


def merged(project: Settings, editor: Settings) -> Settings:
    """Return both; where they disagree the project wins, so that all who work on it agree."""
    return project._replace(
        targets=project.targets or editor.targets,
        select=project.select or editor.select,
        ignore=tuple(dict.fromkeys((*project.ignore, *editor.ignore))),
        severity={**editor.severity, **project.severity},
        bindings={**editor.bindings, **project.bindings},
    )


def _section(raw: object) -> dict[str, Any]:
    for around in ("settings", "kindsl"):
        if isinstance(raw, dict) and isinstance(raw.get(around), dict):
            raw = raw[around]
    section: dict[str, Any] = {}
    for name, value in raw.items() if isinstance(raw, dict) else ():
        group, _, key = name.removeprefix("kindsl.").partition(".")
        if not key:
            section[group] = value
        elif isinstance(section.setdefault(group, {}), dict):
            section[group] = {**section[group], key: value}
    return section


def _seconds(given: Given) -> float:
    milliseconds = None if given.value is None else number(given)
    if milliseconds is not None and 0 <= milliseconds <= _LONGEST_DELAY:
        return milliseconds / 1000.0
    if milliseconds is not None:
        given.unfit(f"is not between 0 and {_LONGEST_DELAY} milliseconds")
    return EditorSettings().diagnostics_delay


def _switches(given: Given) -> dict[str, bool]:
    if isinstance(given.value, bool):
        return {"enabled": given.value}
    switches = {str(each.keys[-1]): boolean(each) for each in given.entries()}
    return {name: is_on for name, is_on in switches.items() if is_on is not None}


def _problem(mistake: Mistake) -> str:
    name = f"setting 'kindsl.{dotted(mistake.keys)}'"
    return f"{name} {mistake.predicate}" if mistake.predicate else f"{name}: {mistake.sentence}"
