"""Decisions put over decisions."""

from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.config.decisions import Decisions, overridden
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.parameters import Binding, JointProperties


def test_what_a_table_decides_wins_and_the_rest_stays() -> None:
    joints = {"a": JointProperties(-1.0, 1.0)}
    poses = {"stand": {"a": 1.0}}
    hint, error = {"KD1": Severity.HINT}, {"KD1": Severity.ERROR}
    first = Decisions(
        frozenset({"robcogen"}), ("KD1",), ("KD2",), hint, {"m": Binding(1.0)}, joints, "1", poses
    )
    settings = Settings(*first[:3], severity=hint, bindings=first.bindings, joints=joints,
                        version="1", poses=poses)  # fmt: skip
    assert overridden(Settings(), first) == settings
    assert overridden(settings, Decisions()) == settings
    second = first._replace(
        targets=frozenset(), select=(), ignore=(), severity=error, bindings={"m": Binding(2.0)},
        version="2",
    )  # fmt: skip
    assert overridden(settings, second) == settings._replace(
        targets=frozenset(), select=(), ignore=(), severity=error, bindings={"m": Binding(2.0)},
        version="2",
    )  # fmt: skip


def test_a_value_without_range_keeps_the_range() -> None:
    ranged = Settings(bindings={"l": Binding(0.3, 0.2, 0.5, "kindsl.toml")})
    plain = Decisions(bindings={"l": Binding(0.9, origin="--param")})
    assert overridden(ranged, plain).bindings == {"l": Binding(0.9, 0.2, 0.5, "--param")}
    other = Decisions(bindings={"l": Binding(0.9, 0.0, 1.0), "m": Binding(1.0)})
    assert overridden(ranged, other).bindings == {"l": Binding(0.9, 0.0, 1.0), "m": Binding(1.0)}


def test_limits_of_joints_are_put_over_others_by_name() -> None:
    first = overridden(Settings(), Decisions(joints={"a": JointProperties(-1.0, 1.0)}))
    both = overridden(first, Decisions(joints={"b": JointProperties(None, 2.0)}))
    assert both.joints == {"a": JointProperties(-1.0, 1.0), "b": JointProperties(None, 2.0)}


def test_poses_are_put_over_others_by_name() -> None:
    first = overridden(Settings(), Decisions(poses={"stand": {"a": 1.0}, "sit": {"a": 2.0}}))
    both = overridden(first, Decisions(poses={"stand": {"b": 3.0}}))
    assert both.poses == {"stand": {"b": 3.0}, "sit": {"a": 2.0}}
