"""A pose that the configuration names, for the joints of a robot."""

from collections.abc import Collection, Mapping

from kindsl.judgement.analysis.settings import Settings
from kindsl.language.text.nearest import hint, nearest_word
from kindsl.language.text.phrases import listed


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
