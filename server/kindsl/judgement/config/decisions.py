"""The decisions of one table of a configuration, or of a command line."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.parameters import Binding, JointProperties

if TYPE_CHECKING:
    from kindsl.robots.comparison.twins import TwinFile


class Decisions(NamedTuple):
    """One table of decisions, named as in `Settings`; None or empty for keys that it lacks."""

    targets: frozenset[str] | None = None
    select: tuple[str, ...] | None = None
    ignore: tuple[str, ...] | None = None
    severity: Mapping[str, Severity] = {}
    bindings: Mapping[str, Binding] = {}
    joints: Mapping[str, JointProperties] = {}
    version: str | None = None
    poses: Mapping[str, Mapping[str, float]] = {}


class TwinTable(NamedTuple):
    """A table of `[[twins]]`.

    Attributes:
        pattern: The documents it is for, in the manner of `.gitignore`.
    """

    pattern: str
    twin: "TwinFile"
    place: tuple[int, int]


def overridden(settings: Settings, table: Decisions) -> Settings:
    """Return settings overridden by a table's decisions."""
    return settings._replace(
        targets=settings.targets if table.targets is None else table.targets,
        select=settings.select if table.select is None else table.select,
        ignore=settings.ignore if table.ignore is None else table.ignore,
        severity={**settings.severity, **table.severity},
        bindings={**settings.bindings, **_within(settings.bindings, table.bindings)},
        joints={**settings.joints, **table.joints},
        version=table.version or settings.version,
        poses={**settings.poses, **table.poses},
    )


def _within(known: Mapping[str, Binding], new: Mapping[str, Binding]) -> dict[str, Binding]:
    """Return new bindings; one without a range keeps the range that is known."""
    ranged = {name: known[name] for name, value in new.items() if name in known}
    return {
        name: binding._replace(minimum=ranged[name].minimum, maximum=ranged[name].maximum)
        if name in ranged and binding.minimum is None and binding.maximum is None
        else binding
        for name, binding in new.items()
    }
