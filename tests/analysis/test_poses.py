"""Poses that a configuration names."""

import pytest

from kindsl.judgement.analysis.settings import PoseError, Settings, pose_named

SETTINGS = Settings(poses={"stand": {"hip": 0.5}, "odd": {"hip": 0.5, "tail": 1.0}})


def test_a_pose_is_found_by_its_name() -> None:
    assert pose_named(SETTINGS, "stand", ["hip", "knee"]) == {"hip": 0.5}


@pytest.mark.parametrize(
    ("settings", "name", "told"),
    [
        (SETTINGS, "stnd", "kindsl.toml names no pose 'stnd', did you mean 'stand'?"),
        (SETTINGS, "x", "kindsl.toml names no pose 'x' (known: stand, odd)"),
        (Settings(), "x", "kindsl.toml names no pose 'x'"),
        (SETTINGS, "odd", "pose 'odd' names 'tail', which the robot does not have"),
    ],
)
def test_a_pose_that_does_not_fit_is_refused(settings: Settings, name: str, told: str) -> None:
    with pytest.raises(PoseError) as caught:
        pose_named(settings, name, ["hip", "knee"])
    assert str(caught.value) == told
