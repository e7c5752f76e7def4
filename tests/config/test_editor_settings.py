"""What the editor may say, however it says it."""

import json
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kindsl.frontends.features.inlay_hints import DEFAULT_HINTS
from kindsl.judgement.analysis.settings import Settings
from kindsl.judgement.config.editor_settings import EditorSettings, editor_settings, merged
from kindsl.judgement.config.schema import EDITOR_KEYS
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.context import TARGETS
from kindsl.language.semantics.parameters import Binding, JointProperties

steady = settings(deadline=None, derandomize=True)

json_values = st.recursive(
    st.none() | st.booleans() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner),
    max_leaves=5,
)
names = st.sampled_from(
    ["target", "ignore", "severity", "parameters", "diagnostics", "diagnostics.delay", "inlayHints"]
)


@pytest.mark.parametrize(
    "raw",
    [
        {"diagnostics": {"delay": 250}},
        {"diagnostics.delay": 250},
        {"kindsl.diagnostics.delay": 250},
        {"kindsl": {"diagnostics": {"delay": 250}}},
        {"settings": {"kindsl": {"diagnostics": {"delay": 250}}}},
    ],
)
def test_a_setting_may_be_nested_or_not(raw: object) -> None:
    assert editor_settings(raw).diagnostics_delay == 0.25


def test_everything_is_understood() -> None:
    found = editor_settings(
        {
            "target": ["robcogen"],
            "ignore": ["KD7"],
            "severity": {"KD401": "error"},
            "parameters": {"a": 1, "b": {"value": 2.0, "min": 1.0, "max": 3.0}},
            "inlayHints": {"units": True},
        }
    )
    assert found.problems == ()
    assert found.rules == Settings(
        targets=frozenset({"robcogen"}),
        ignore=("KD7",),
        severity={"KD401": Severity.ERROR},
        bindings={
            "a": Binding(1.0, origin="editor settings"),
            "b": Binding(2.0, 1.0, 3.0, "editor settings"),
        },
    )
    assert found.inlay_hints == {"units": True}


def test_what_is_right_beside_a_mistake_is_kept() -> None:
    found = editor_settings(
        {"ignore": ["KD7", "K"], "parameters": {"a": {"value": 1, "max": "2"}, "b": 2}}
    )
    assert found.problems == (
        "setting 'kindsl.ignore[1]': no rule has a code that begins with 'K'",
        "setting 'kindsl.parameters.a.max' must be a number, not a string",
    )
    assert found.rules.ignore == ("KD7",)
    assert {name: binding.value for name, binding in found.rules.bindings.items()} == {
        "a": 1.0, "b": 2.0,
    }  # fmt: skip


MANIFEST = json.loads(
    (Path(__file__).parents[2] / "vscode-extension" / "package.json").read_text()
)["contributes"]["configuration"]["properties"]
# What the extension reads itself: how the server is found, and when it opens its panel.
OF_THE_EXTENSION = ("preview", "interpreter", "importStrategy", "path", "args", "trace")


def test_the_extension_offers_the_settings_of_the_schema() -> None:
    names = [name.removeprefix("kindsl.") for name in MANIFEST]
    offered = [name for name in names if name.split(".")[0] not in OF_THE_EXTENSION]
    hints = ["inlayHints.enabled", *(f"inlayHints.{name}" for name in DEFAULT_HINTS._fields)]
    assert sorted(offered) == sorted((*EDITOR_KEYS, "diagnostics.delay", *hints))
    assert MANIFEST["kindsl.target"]["items"]["enum"] == list(TARGETS)
    levels = MANIFEST["kindsl.severity"]["additionalProperties"]["enum"]
    assert levels == [severity.value for severity in Severity]


def test_the_defaults_of_the_extension_are_those_of_the_schema() -> None:
    found = editor_settings({name: setting["default"] for name, setting in MANIFEST.items()})
    defaults = {"enabled": True, **DEFAULT_HINTS._asdict()}
    assert found == EditorSettings(inlay_hints=defaults)


def test_hints_are_switched_together_or_each() -> None:
    assert editor_settings({"inlayHints": True}).inlay_hints == {"enabled": True}


@steady
@given(st.dictionaries(names, json_values) | json_values)
def test_nonsense_is_told_and_left_out(raw: object) -> None:
    found = editor_settings(raw)
    assert all(problem.startswith("setting 'kindsl.") for problem in found.problems)
    assert 0.0 <= found.diagnostics_delay <= 60.0


def test_the_project_wins() -> None:
    project = Settings(
        severity={"KD1": Severity.HINT}, bindings={"a": Binding(1.0)}, ignore=("KD7",)
    )
    editor = Settings(
        targets=frozenset({"robcogen"}),
        severity={"KD1": Severity.ERROR, "KD2": Severity.ERROR},
        bindings={"a": Binding(2.0), "b": Binding(3.0)},
        ignore=("KD5",),
    )
    both = merged(project, editor)
    assert both.targets == {"robcogen"}
    assert both.severity == {"KD1": Severity.HINT, "KD2": Severity.ERROR}
    assert both.bindings == {"a": Binding(1.0), "b": Binding(3.0)}
    assert set(both.ignore) == {"KD7", "KD5"}


def test_what_the_editor_cannot_say_is_the_projects() -> None:
    """Its previews stop at the limits of joints, as those of the command line do."""
    project = Settings(joints={"elbow": JointProperties(-1.0, 2.0)}, select=("KD7",))
    assert merged(project, Settings()) == project
