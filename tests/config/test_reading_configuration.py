"""kindsl.toml: what it may say, and how it is told what is wrong."""

import json
import tomllib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kindsl.judgement.config.configuration_reading import (
    configuration_of,
    read_configuration,
    read_parameters,
)
from kindsl.judgement.config.discovery import (
    Configurations,
    has_python_table,
    nearest_configuration,
)
from kindsl.judgement.config.errors import ConfigurationError
from kindsl.judgement.config.toml_places import toml_places
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.parameters import Binding
from kindsl.robots.comparison.twins import TwinFile

EVERYTHING = """\
target = ["robcogen"]
ignore = ["kd7"]
[severity]
KD401 = "error"
[parameters]
ee_x = 0.5
[parameters.l2]
value = 0.35
min = 0.2
max = 0.5
[[document]]
path = "models/hyq.kindsl"
parameters = { m_trunk = 55.4, ee_x = 1 }
target = []
"""


def test_everything_is_read() -> None:
    configuration = configuration_of("kindsl.toml", EVERYTHING)
    settings = configuration.settings_for("other.kindsl")
    assert settings.targets == {"robcogen"}
    assert settings.ignore == ("KD7",)
    assert settings.severity == {"KD401": Severity.ERROR}
    assert settings.bindings == {
        "ee_x": Binding(0.5, origin="kindsl.toml"),
        "l2": Binding(0.35, 0.2, 0.5, "kindsl.toml"),
    }


def test_a_documents_own_table_wins() -> None:
    settings = configuration_of("kindsl.toml", EVERYTHING).settings_for("models/hyq.kindsl")
    assert settings.targets == frozenset()
    assert settings.bindings["ee_x"].value == 1.0
    assert settings.bindings["m_trunk"].value == 55.4
    assert settings.bindings["l2"].maximum == 0.5


@pytest.mark.parametrize(
    ("pattern", "path", "is_meant"),
    [
        ("models/hyq.kindsl", "models/hyq.kindsl", True),
        ("./models/hyq.kindsl", "models/hyq.kindsl", True),
        ("models/hyq.kindsl", "other/models/hyq.kindsl", False),
        ("hyq.kindsl", "models/old/hyq.kindsl", True),
        ("models/*.kindsl", "models/hyq.kindsl", True),
        ("models/*.kindsl", "models/old/hyq.kindsl", False),
        ("models/**/*.kindsl", "models/old/hyq.kindsl", True),
        ("hyq*", "hyq_v2.kindsl", True),
    ],
)
def test_patterns(pattern: str, path: str, is_meant: bool) -> None:
    text = f'[[document]]\npath = "{pattern}"\nparameters = {{ x = 1.0 }}\n'
    settings = configuration_of("kindsl.toml", text).settings_for(path)
    assert bool(settings.bindings) is is_meant


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("tarjet = []\n", ":1:1: error: unknown key 'tarjet', did you mean 'target'?"),
        ("\nignore = 3\n", ":2:1: error: 'ignore' must be a list of strings, not a number"),
        ('ignore = ["KD1", "X9"]\n', ":1:18: error: no rule has a code that begins with 'X9'"),
        (
            'target = ["robcogn"]\n',
            ":1:1: error: unknown target 'robcogn', did you mean 'robcogen'?",
        ),
        (
            '[severity]\nKD401 = "eror"\n',
            ":2:1: error: unknown severity 'eror' of 'KD401', did you mean 'error'?",
        ),
        ("[severity]\nKD401 = 1\n", ":2:1: error: 'severity.KD401' must be a string, not a number"),
        ('[severity]\nXY = "error"\n', ":2:1: error: no rule has a code that begins with 'XY'"),
        ("parameters = 1\n", ":1:1: error: 'parameters' must be a table, not a number"),
        ('[parameters]\nx = "1"\n', ":2:1: error: 'parameters.x' must be a number, or a table"),
        ("[parameters]\nx = true\n", ":2:1: error: 'parameters.x' must be a number, or a table"),
        ("[joints.x]\nmin = inf\nmax = 1\n", ":2:1: error: 'joints.x.min' must be finite"),
        (f"[parameters]\nx = 1{'0' * 400}\n", ":2:1: error: 'parameters.x' must be finite"),
        ("[parameters]\nx = inf\n", ":2:1: error: 'parameters.x' must be finite"),
        ("[parameters.x]\nmin = 1\n", ":1:13: error: 'parameters.x' has no 'value'"),
        (
            "[parameters.x]\nvalue = 1\nmax = []\n",
            ":3:1: error: 'parameters.x.max' must be a number",
        ),
        (
            "[parameters.x]\nvalue = 1\nmix = 1\n",
            ":3:1: error: unknown key 'mix' in 'parameters.x'",
        ),
        (
            "[parameters.x]\nvalue = 1\nmin = 2\nmax = 1\n",
            ":3:1: error: 'parameters.x.min' is greater than 'max'",
        ),
        ("[joints]\nx = 1\n", ":2:1: error: 'joints.x' must be a table with 'min', 'max'"),
        ("[joints.x]\nmin = 2\nmax = 1\n", ":2:1: error: 'joints.x.min' is greater than 'max'"),
        ("[joints.x]\nmax = nan\n", ":2:1: error: 'joints.x.max' must be finite"),
        ("[joints.x]\nlow = 1\n", ":2:1: error: unknown key 'low' in 'joints.x'"),
        ("[joints]\nx.damping = -1\n", ":2:3: error: 'joints.x.damping' is negative"),
        ("[poses]\nhome = 1\n", ":2:1: error: 'poses.home' must be a table, not a number"),
        ("[poses]\nhome.x = 'a'\n", ":2:6: error: 'poses.home.x' must be a number, not a string"),
        ("document = [1]\n", ":1:13: error: 'document[0]' must be a table, not a number"),
        ("[document]\n", ":1:2: error: 'document' must be written as [[document]], not a table"),
        ("[[document]]\nignore = []\n", ":1:3: error: 'document[0]' has no 'path'"),
        ("[[document]]\npath = 1\n", ":2:1: error: 'document[0].path' must be a string"),
        (
            '[[document]]\npath = "[z-a]"\n',
            ":2:1: error: 'document[0].path' is a pattern that cannot match any document",
        ),
        (
            '[[document]]\npath = "a\\\\"\n',
            ":2:1: error: 'document[0].path' is a pattern that cannot match any document",
        ),
        (
            '[[document]]\npath = "!arm.kindsl"\n',
            ":2:1: error: 'document[0].path' is a pattern that cannot match any document",
        ),
        (
            '[[document]]\npath = "a"\n[[document]]\npath = "b"\nparam = {}\n',
            ":5:1: error: unknown key 'param' in 'document[1]', did you mean 'parameters'?",
        ),
        (
            '[[document]]\npath = "a"\nparameters = { x = 1.0, y = "2" }\n',
            ":3:25: error: 'document[0].parameters.y' must be a number",
        ),
        ('[[twins]]\nfile = "a.urdf"\n', ":1:3: error: 'twins[0]' has no 'document'"),
        ('[[twins]]\ndocument = "a.kindsl"\n', ":1:3: error: 'twins[0]' has no 'file'"),
        (
            '[[twins]]\ndocument = "a"\nfile = "b"\ntolerance = -1e-9\n',
            ":4:1: error: 'twins[0].tolerance' is negative",
        ),
        (
            '[[twins]]\ndocument = "a"\nfile = "b"\njoints = { x = 1 }\n',
            ":4:12: error: 'twins[0].joints.x' must be a string",
        ),
        ("version = 3\n", ":1:1: error: 'version' must be a string, not a number"),
        ('version = "1.x"\n', ":1:1: error: version '1.x' is not up to four numbers with dots"),
        ("baseline = 3\n", ":1:1: error: 'baseline' must be a string, not a number"),
        ('baseline = " "\n', ":1:1: error: 'baseline' is empty"),
        ("target = [\n", ":2:1: error: not valid TOML: "),
        ("x = = 1\n", ":1:5: error: not valid TOML: invalid value"),
        ("1975-01-01 = 3\nx", ":2:2: error: not valid TOML: "),
        (f"[parameters]\nx = 1{'0' * 5000}\n", ":2:5: error: a number has more digits than"),
    ],
)
def test_what_is_wrong_is_told_with_its_place(text: str, told: str) -> None:
    with pytest.raises(ConfigurationError) as caught:
        configuration_of("sub/kindsl.toml", text)
    assert str(caught.value).startswith("sub/kindsl.toml" + told)
    (problem,) = caught.value.problems
    assert "(at " not in problem.message
    place = problem.place
    assert len(text.split("\n")[place.line - 1]) >= place.column - 1
    lines = text.split("\n")[: place.line - 1]
    assert place.start == sum(len(line) + 1 for line in lines) + place.column - 1


@given(st.text(max_size=8))
def test_what_is_told_is_one_line(name: str) -> None:
    quoted = json.dumps(name)
    with pytest.raises(ConfigurationError) as caught:
        configuration_of("kindsl.toml", f"target = [{quoted}]\nignore = [1, {quoted}]\n")
    assert all(problem.message.isprintable() for problem in caught.value.problems)


def test_a_twin_is_read_from_its_table() -> None:
    text = '[[twins]]\ndocument = "*.kindsl"\nfile = "../a.urdf"\n'
    text += 'tolerance = 0.5\njoints = { a = "b" }\n'
    (twin,) = configuration_of("sub/kindsl.toml", text).twins
    assert twin.pattern == "*.kindsl"
    assert twin.twin == TwinFile("a.urdf", "../a.urdf", (("a", "b"),), 0.5)
    assert text[slice(*twin.place)] == "file"
    configuration = configuration_of("sub/kindsl.toml", text)
    for document, twins in (("sub/arm.kindsl", (twin.twin,)), ("sub/arm.txt", ())):
        assert tuple(configuration.settings_for(document).twins) == twins


def test_all_mistakes_are_told_in_order() -> None:
    with pytest.raises(ConfigurationError) as caught:
        configuration_of("kindsl.toml", "a = 1\nignore = 2\n[severity]\nKD1 = 3\n")
    assert [(p.place.line, p.key) for p in caught.value.problems] == [
        (1, "a"), (2, "ignore"), (4, "severity.KD1"),
    ]  # fmt: skip


def test_table_of_pyproject(tmp_path: Path) -> None:
    (tmp_path / "pyproject.toml").write_text('[tool.kindsl]\ntarget = "robcogen2"\nx = 1\n')
    with pytest.raises(ConfigurationError) as caught:
        read_configuration(str(tmp_path / "pyproject.toml"))
    assert caught.value.problems[0].place[:2] == (3, 1)


@pytest.mark.parametrize(
    "text", ["[tool]\nkindsl = 3\n", "tool = 3\n", "[[tool]]\nkindsl = {}\n", "[[tool.kindsl]]\n"]
)
def test_our_part_of_a_pyproject_is_a_table(text: str) -> None:
    with pytest.raises(ConfigurationError, match=r"'tool\.kindsl' must be a table, not a"):
        configuration_of("pyproject.toml", text)
    assert configuration_of("pyproject.toml", "[project]\n").documents == ()


def test_nearest_file_above_wins(tmp_path: Path) -> None:
    deep = tmp_path / "a" / "b"
    deep.mkdir(parents=True)
    (tmp_path / "kindsl.toml").touch()
    assert _nearest(deep) == tmp_path / "kindsl.toml"
    (tmp_path / "a" / "pyproject.toml").write_text("[tool.ruff]\n# kindsl\n")
    assert _nearest(deep) == tmp_path / "kindsl.toml"
    (tmp_path / "a" / "pyproject.toml").write_text("[tool.kindsl]\n")
    assert _nearest(deep) == tmp_path / "a" / "pyproject.toml"
    (tmp_path / "a" / "kindsl.toml").touch()
    assert _nearest(deep) == tmp_path / "a" / "kindsl.toml"


def _nearest(folder: Path) -> Path:
    found = nearest_configuration(str(folder))
    assert found is not None
    return Path(found).resolve()


def test_a_wrong_file_is_told_for_each_document(tmp_path: Path) -> None:
    (tmp_path / "kindsl.toml").write_text("oops = 1\n")
    configurations = Configurations()
    for name in ("a.kindsl", "b.kindsl"):
        with pytest.raises(ConfigurationError, match="oops"):
            configurations.above(str(tmp_path / name))


@pytest.mark.parametrize(
    ("content", "line"), [(b"x = 1\xff", 1), (b"\xff\xfex\x00", 1), (b"x = 1\n\n# \xff\n", 3)]
)
def test_not_utf_8_is_told_with_its_line(tmp_path: Path, content: bytes, line: int) -> None:
    (tmp_path / "kindsl.toml").write_bytes(content)
    with pytest.raises(ConfigurationError, match="is not valid UTF-8") as caught:
        read_configuration(str(tmp_path / "kindsl.toml"))
    assert caught.value.problems[0].place == (line, 1, 0, 0)


@pytest.mark.parametrize("text", ["x = 1\n", "[parameters]\nx = 1\n", "[x]\nvalue = 1\nmin = 0\n"])
def test_files_of_parameters(tmp_path: Path, text: str) -> None:
    (tmp_path / "values.toml").write_text(text)
    assert read_parameters(str(tmp_path / "values.toml"))["x"].value == 1.0


KEY = st.sampled_from(["a", "b-c", "1", '"q.r"', "'s t'", '"\\u00e9"'])
VALUE = st.recursive(
    st.sampled_from(
        ["1", "-1.5e3", "true", "'lit # [x]'", '"b \\" ] ="', "1979-05-27T07:32:00Z",
         '"""m\n = "x" \n"""', "'''\n[a]\n'''", "0x1F", "[]", "{}"]
    ),
    lambda inner: st.lists(inner, min_size=1, max_size=3).map(
        lambda v: "[ # c\n" + ",\n".join(v) + ",]"
    ) | st.dictionaries(KEY, inner.filter(lambda v: "\n" not in v), max_size=3).map(
        lambda d: "{ " + ", ".join(f"{k} = {v}" for k, v in d.items()) + " }"
    ),
    max_leaves=5,
)  # fmt: skip


@st.composite
def toml_texts(draw: st.DrawFn) -> str:
    lines = []
    for number in range(draw(st.integers(0, 3))):
        header = draw(
            st.sampled_from(["", f"[t{number}]# c", f"[t{number}.x]", "[[l]]# c", "[[l.m]]"])
        )
        lines.append(header)
        for key, value in draw(st.dictionaries(KEY, VALUE, max_size=3)).items():
            lines.append(f"{key} = {value} # c")
    return draw(st.sampled_from(["\n", "\r\n"])).join(lines)


@given(toml_texts())
def test_each_key_has_a_place_where_it_stands(text: str) -> None:
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return
    places = toml_places(text)
    for path in _paths(table, ()):
        start, end = places[path]
        if isinstance(path[-1], str):
            written = text[start:end]
            assert tomllib.loads(f"{written} = 1") == {path[-1]: 1}


def _paths(value: Any, path: tuple[str | int, ...]) -> list[tuple[str | int, ...]]:
    if isinstance(value, dict):
        items: list[tuple[str | int, Any]] = list(value.items())
    elif isinstance(value, list):
        items = list(enumerate(value))
    else:
        return []
    below = [found for key, inner in items for found in _paths(inner, (*path, key))]
    return [*((*path, key) for key, _ in items), *below]


@pytest.mark.parametrize(("content", "is_ours"), [
    (b"[tool.kindsl]\nx = \xff", True), (b"[tool.kindsl]\nx = = 1", True),
    (b"# kindsl\nx = \xff", False), (b"# kindsl\nx = = 1", False),
])  # fmt: skip
def test_a_broken_pyproject_is_ours_if_it_has_our_table(
    tmp_path: Path, content: bytes, is_ours: bool
) -> None:
    (tmp_path / "pyproject.toml").write_bytes(content)
    assert has_python_table(str(tmp_path / "pyproject.toml")) is is_ours


def test_a_pyproject_that_cannot_be_read_is_not_ours(tmp_path: Path) -> None:
    assert not has_python_table(str(tmp_path))


def test_one_letter_is_no_code() -> None:
    with pytest.raises(ConfigurationError, match="no rule has a code that begins with 'K'"):
        configuration_of("kindsl.toml", 'ignore = ["K"]\n')
    assert configuration_of("kindsl.toml", 'ignore = ["KD"]\n').common.ignore == ("KD",)


def test_what_cannot_be_read_is_told_at_the_start(tmp_path: Path) -> None:
    with pytest.raises(ConfigurationError) as caught:
        read_configuration(str(tmp_path / "kindsl.toml"))
    (problem,) = caught.value.problems
    assert problem.place == (1, 1, 0, 0)
