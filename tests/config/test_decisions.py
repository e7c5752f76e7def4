"""Decisions put over decisions."""

from kindsl.analysis.settings import Settings
from kindsl.config.decisions import Decisions, overridden
from kindsl.semantics.parameters import Binding, JointProperties


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
