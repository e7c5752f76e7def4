"""Values and names written into configuration files, whatever stands there."""

import tomllib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import assume, event, given, settings
from hypothesis import strategies as st
from tests.config.toml_layouts import DOCUMENT, NAMES, Layout, layouts

from kindsl.judgement.config.configuration import Configuration
from kindsl.judgement.config.configuration_reading import configuration_of
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.toml_edits import binding_edit, is_equal, renaming_edits
from kindsl.language.text.edits import apply_edits

FOLDER = Path("/project")
ARM = str(FOLDER / DOCUMENT)
OTHERS = [str(FOLDER / name) for name in ("other.kindsl", "robots/leg.kindsl", "arms/b.kindsl")]
many = settings(max_examples=120, deadline=None)


def read(layout: Layout) -> Configuration:
    """Read a layout; what is no configuration by chance does not count."""
    try:
        found = configuration_of(str(FOLDER / layout.name), layout.text)
    except ConfigurationError:
        assume(False)
        raise
    assume(not found.root or found.root in found.places)
    return found


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "[parameters]\nm = 1.0\n"),
        ('target = ["robcogen"]', 'target = ["robcogen"]\n\n[parameters]\nm = 1.0\n'),
        ("[parameters]", "[parameters]\nm = 1.0\n"),
        (
            "[parameters]\nb = 2.0 # kg\n\n# How bad.\n[severity]\nKD4 = 'hint'\n",
            "[parameters]\nb = 2.0 # kg\nm = 1.0\n\n# How bad.\n[severity]\nKD4 = 'hint'\n",
        ),
        (
            "[parameters]\nb = 2.0\n# c = 3.0\n\n[severity]\n",
            "[parameters]\nb = 2.0\n# c = 3.0\nm = 1.0\n\n[severity]\n",
        ),
        (
            "[parameters]\nb = 2.0\n# How bad.\n[severity]\n",
            "[parameters]\nb = 2.0\nm = 1.0\n# How bad.\n[severity]\n",
        ),
        ("[parameters]\r\nb = 2.0\r\n", "[parameters]\r\nb = 2.0\r\nm = 1.0\r\n"),
        ("parameters = {}\n", "parameters = {m = 1.0}\n"),
        ("parameters = { b = 2.0 } # all\n", "parameters = { b = 2.0, m = 1.0 } # all\n"),
        (
            "parameters.b = 2.0\nignore = []\n",
            "parameters.b = 2.0\nparameters.m = 1.0\nignore = []\n",
        ),
        ("[parameters.b]\nvalue = 1.0\n", "[parameters]\nm = 1.0\n\n[parameters.b]\nvalue = 1.0\n"),
        (
            "ignore = []\n# How.\n[parameters.b]\nvalue = 1.0\n",
            "ignore = []\n\n[parameters]\nm = 1.0\n\n# How.\n[parameters.b]\nvalue = 1.0\n",
        ),
        ("[parameters]\nm   =  2.0  # old\n", "[parameters]\nm   =  1.0  # old\n"),
        (
            "[parameters.m]\nvalue = 2.0 # kg\nmin = 0.5\n",
            "[parameters.m]\nvalue = 1.0 # kg\nmin = 0.5\n",
        ),
        (
            "[parameters]\nb = 1.0\n[[document]]\npath = 'robots/arm.kindsl'\n\n"
            "# The other one.\n[[document]]\npath = 'leg.kindsl'\n",
            "[parameters]\nb = 1.0\n[[document]]\npath = 'robots/arm.kindsl'\n"
            "parameters = {m = 1.0}\n\n# The other one.\n[[document]]\npath = 'leg.kindsl'\n",
        ),
        (
            "[[document]]\npath = 'leg.kindsl'\nparameters.m = 2.0\n",
            "[[document]]\npath = 'leg.kindsl'\nparameters.m = 2.0\n\n[parameters]\nm = 1.0\n",
        ),
    ],
)
def test_a_binding_is_written_as_the_author_would(text: str, expected: str) -> None:
    edit = binding_edit(str(FOLDER / "kindsl.toml"), text, ARM, [("m", 1.0)])
    assert edit is not None
    assert apply_edits(text, [edit]) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "[tool.kindsl]\ntarget = []\n[tool.other.parameters]\nm = 2\n",
            "[tool.kindsl]\ntarget = []\n\n[tool.kindsl.parameters]\nm = 1.0\n\n"
            "[tool.other.parameters]\nm = 2\n",
        ),
        (
            "[tool]\nkindsl.target = []\n",
            "[tool]\nkindsl.target = []\nkindsl.parameters = {m = 1.0}\n",
        ),
        ("[tool]\nkindsl = {}\n", "[tool]\nkindsl = {parameters = {m = 1.0}}\n"),
    ],
)
def test_only_our_table_of_a_pyproject_is_written_to(text: str, expected: str) -> None:
    edit = binding_edit(str(FOLDER / "pyproject.toml"), text, ARM, [("m", 1.0)])
    assert edit is not None
    assert apply_edits(text, [edit]) == expected


NAN = float("nan")


@pytest.mark.parametrize(
    ("one", "other", "is_same"),
    [
        (1, 1, True), (1, 2, False), (1, 1.0, False), (1, True, False), (NAN, float("nan"), True),
        (NAN, 1.0, False), ([1, 2], [1, 2], True), ([1, 2], [1], False), ([1], [2], False),
        ({"a": [NAN]}, {"a": [NAN]}, True), ({"a": 1}, {"b": 1}, False),
        ({"a": 1}, {"a": 2}, False),
        ({}, [], False),
    ],
)  # fmt: skip
def test_values_are_the_same_if_toml_cannot_tell_them_apart(
    one: object, other: object, is_same: bool
) -> None:
    assert is_equal(one, other) is is_same
    assert is_equal(other, one) is is_same


def test_several_values_are_one_edit() -> None:
    text = "[parameters]\na = 1.0\n[[document]]\npath = 'arm.kindsl'\nparameters = {b = 2.0}\n"
    edit = binding_edit(str(FOLDER / "kindsl.toml"), text, ARM, [("a", 3.0), ("m", 4.0)])
    assert edit is not None
    assert apply_edits(text, [edit]) == (
        "[parameters]\na = 3.0\n[[document]]\npath = 'arm.kindsl'\n"
        "parameters = {b = 2.0, m = 4.0}\n"
    )


@pytest.mark.parametrize(
    ("name", "text"),
    [("kindsl.toml", "a = "), ("kindsl.toml", "wrong = 1\n"), ("pyproject.toml", "[project]\n")],
)
def test_nothing_is_written_to_what_is_no_configuration(name: str, text: str) -> None:
    assert binding_edit(str(FOLDER / name), text, ARM, [("m", 1.0)]) is None


@many
@given(layouts(), st.sampled_from([*NAMES, "new", "größe"]), st.sampled_from([0.5, 1e-7, 1e20]))
def test_a_binding_is_seen_and_nothing_else_changes(
    layout: Layout, name: str, value: float
) -> None:
    before = read(layout)
    known = before.settings_for(ARM).bindings
    edit = binding_edit(before.path, before.text, ARM, [(name, value)])
    assert edit is not None, layout.text
    after = configuration_of(before.path, apply_edits(before.text, [edit]))
    event("bound before" if name in known else "new")

    found = after.settings_for(ARM)
    assert found.bindings[name].value == value
    if name in known:
        ends = known[name].minimum, known[name].maximum
        assert (found.bindings[name].minimum, found.bindings[name].maximum) == ends
    else:
        assert edit.start == edit.end
        assert edit.text.count("\n") == edit.text.count("\r\n") or "\r" not in layout.text
    assert without(found.bindings, name) == without(known, name)
    assert found._replace(bindings={}) == before.settings_for(ARM)._replace(bindings={})
    old, new = tomllib.loads(before.text), tomllib.loads(after.text)
    assert len(differences(old, new)) == 1
    if name not in known and DOCUMENT in [table.pattern for table in before.documents]:
        event("its own table")
        for other in OTHERS:
            assert after.settings_for(other) == before.settings_for(other)


@many
@given(layouts(), st.sampled_from(["fresh", "größe", *NAMES]), st.data())
def test_a_renamed_binding_keeps_its_value(layout: Layout, new: str, data: st.DataObject) -> None:
    before = read(layout)
    own = len(before.root)
    places = [
        keys
        for keys in before.places
        if keys[-2:-1] == ("parameters",) and len(keys) - own in (2, 4)
    ]
    assume(places)
    keys = data.draw(st.sampled_from(sorted(places, key=repr)))
    name = keys[-1]
    edits = renaming_edits(before.text, keys, new)
    old = tomllib.loads(before.text)
    if new in at(old, keys[:-1]):
        assert edits is None
        return
    assert edits
    renamed = tomllib.loads(apply_edits(before.text, edits))
    table = at(renamed, keys[:-1])
    table[name] = table.pop(new)
    assert differences(old, renamed) == []
    again = renaming_edits(apply_edits(before.text, edits), (*keys[:-1], new), name)
    assert again is not None
    text = apply_edits(apply_edits(before.text, edits), again)
    assert text.replace('"', "").replace("'", "") == before.text.replace('"', "").replace("'", "")


def at(table: Any, keys: Any) -> Any:
    for key in keys:
        table = table[key]
    return table


def without(bindings: Any, name: str) -> dict[str, Any]:
    return {key: value for key, value in bindings.items() if key != name}


def differences(one: object, other: object) -> list[tuple[object, object]]:
    """Return what is at the same place of two values of TOML, but differs."""
    if isinstance(one, dict) and isinstance(other, dict):
        missing = object()
        pairs = [(one.get(k, missing), other.get(k, missing)) for k in {**one, **other}]
        return [found for pair in pairs for found in differences(*pair)]
    if isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        return [found for pair in zip(one, other, strict=True) for found in differences(*pair)]
    is_same = type(one) is type(other) and (one == other or (one != one and other != other))
    return [] if is_same else [(one, other)]
