"""`[[twins]]` in kindsl.toml: other files of the same robot, compared with the document."""

import json
from pathlib import Path

import pytest
from tests.cli.conftest import Runner
from tests.cli.test_diff_mechanics import ARM

TWINS = '[[twins]]\ndocument = "arm.kindsl"\nfile = "{}"\n'


def findings(kdsl_lint: Runner, *options: str) -> list[tuple[str, str, int, str]]:
    run = kdsl_lint(".", "--select", "KD9", "--output-format", "json", *options)
    found = json.loads(run.out)
    return [(f["code"], f["path"], f["start"]["line"], f["message"]) for f in found]


@pytest.fixture(autouse=True)
def robot(kindsl: Runner, folder: Path) -> None:
    """Write a document and the URDF that it becomes."""
    Path("arm.kindsl").write_text(ARM)
    assert kindsl("convert", "-q", "arm.kindsl", "arm.urdf").status == 0
    Path("kindsl.toml").write_text(TWINS.format("arm.urdf"))


def change_urdf(old: str, new: str) -> int:
    """Change a number of the URDF; return its line."""
    text = Path("arm.urdf").read_text()
    assert text.count(old) == 1
    Path("arm.urdf").write_text(text.replace(old, new))
    return text[: text.index(old)].count("\n") + 1


def test_equal_twins_are_silent(kdsl_lint: Runner) -> None:
    assert findings(kdsl_lint) == []


def test_the_number_that_differs_is_marked(kdsl_lint: Runner) -> None:
    line = change_urdf('value="0.8"', 'value="0.85"')
    assert findings(kdsl_lint) == [
        (
            "KD901",
            "arm.kindsl",
            17,
            f"mass of link 'lower' is 0.8 kg here and 0.85 kg in arm.urdf (line {line})",
        )
    ]


def test_each_number_is_told_by_itself(kdsl_lint: Runner) -> None:
    text = Path("arm.kindsl").read_text()
    for old, new in (("mass = 0.8", "mass = 0.9"), ("mass = 1.3", "mass = 1.4"), ("0.35", "0.45")):
        assert text.count(old) == 1
        text = text.replace(old, new)
    Path("arm.kindsl").write_text(text)
    assert len(findings(kdsl_lint)) > 2
    assert "more like it" not in kdsl_lint(".", "--select", "KD9").out


def test_each_unknown_joint_is_told_though_all_have_one_place(kdsl_lint: Runner) -> None:
    joints = ", ".join(f"{name} = '{name}'" for name in ("axle", "boom", "crank"))
    Path("kindsl.toml").write_text(f"{TWINS.format('arm.urdf')}joints = {{ {joints} }}")
    assert len(findings(kdsl_lint)) > 2
    assert "more like it" not in kdsl_lint(".", "--select", "KD9").out


def test_the_fix_takes_the_twins_number_with_its_digits(kdsl_lint: Runner) -> None:
    change_urdf('value="0.8"', 'value="8.50e-1"')
    run = kdsl_lint(".", "--select", "KD9", "--fix", "--unsafe-fixes")
    assert run.status == 0
    assert "mass = 0.85\n" in Path("arm.kindsl").read_text()
    assert findings(kdsl_lint) == []


def test_a_tolerance_and_a_map_of_joints_are_heard(kdsl_lint: Runner) -> None:
    change_urdf('value="0.8"', 'value="0.801"')
    table = TWINS.format("arm.urdf")
    Path("kindsl.toml").write_text(f"{table}tolerance = 0.01\n")
    assert findings(kdsl_lint) == []
    Path("kindsl.toml").write_text(f"{table}joints = {{ shoulder = 'elbow', elbow = 'shoulder' }}")
    ((_, _, _, message),) = findings(kdsl_lint)
    assert message.startswith("0 joints match: 2 joints here, 2 joints in arm.urdf")


def test_a_joint_of_the_map_that_does_not_exist_is_told(kdsl_lint: Runner) -> None:
    Path("kindsl.toml").write_text(f"{TWINS.format('arm.urdf')}joints = {{ elbow = 'elbo' }}")
    ((code, path, _, message),) = findings(kdsl_lint)
    assert (code, path) == ("KD901", "arm.kindsl")
    assert message == "there is no joint 'elbo' in arm.urdf, did you mean 'elbow'?"


def test_a_twin_of_no_document_is_told(kdsl_lint: Runner) -> None:
    Path("kindsl.toml").write_text(TWINS.format("arm.urdf").replace("arm.kindsl", "am.kindsl"))
    told = kdsl_lint(".", "--select", "KD404").out
    assert told.startswith("kindsl.toml:2:1: warning[KD404] there is no document 'am.kindsl': its")


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("gone.urdf", None, "No such file or directory"),
        ("gone", None, "No such file or directory"),
        ("broken.urdf", "<robot", "not a readable URDF: not well-formed XML at line 1"),
        ("arm.xacro", "<robot/>", "xacro is not expanded here"),
        ("arm.txt", "", "the suffix '.txt' does not determine the format"),
        (".", None, "no generated code in this folder"),
    ],
)
def test_what_cannot_be_read_is_reported_at_its_path(
    kdsl_lint: Runner, name: str, content: str | None, message: str
) -> None:
    if content is not None:
        Path(name).write_text(content)
    Path("kindsl.toml").write_text(TWINS.format(name))
    ((code, path, line, told),) = findings(kdsl_lint)
    assert (code, path, line) == ("KD902", "kindsl.toml", 3)
    assert told.startswith(f"twin '{name}' cannot be read: {message}")
    assert findings(kdsl_lint, "--ignore", "KD902") == []


def test_generated_code_is_one_finding(kindsl: Runner, kdsl_lint: Runner) -> None:
    assert kindsl("generate", "arm.kindsl", "--language", "c", "-o", "code").status == 0
    Path("kindsl.toml").write_text(TWINS.format("code"))
    assert findings(kdsl_lint) == []
    Path("arm.kindsl").write_text(ARM.replace("0.8", "0.9").replace("0.35", "0.45"))
    ((code, _, line, message),) = findings(kdsl_lint)
    assert (code, line) == ("KD903", 27)
    assert message == (
        "'code' was generated from other numbers: x of joint 'elbow' is 0.45 m here "
        "and 0.35 m in code, and 1 more"
    )


def test_another_robot_is_one_finding(kdsl_lint: Runner) -> None:
    text = Path("arm.urdf").read_text()
    chain = "".join(
        f'<link name="x{i}"/><joint name="y{i}" type="continuous"><parent link="'
        f'{f"x{i - 1}" if i else "lower"}"/><child link="x{i}"/></joint>'
        for i in range(6)
    )
    Path("arm.urdf").write_text(text.replace("</robot>", f"{chain}</robot>"))
    ((code, _, line, message),) = findings(kdsl_lint)
    assert (code, line) == ("KD901", 2)
    assert message.startswith("2 joints match: 2 joints here, 8 joints in arm.urdf")


def test_a_broken_document_is_not_compared(kdsl_lint: Runner) -> None:
    change_urdf('value="0.8"', 'value="0.85"')
    Path("arm.kindsl").write_text(ARM.replace("mass = 1.3", "mass = "))
    assert [code for code, *_ in findings(kdsl_lint) if code.startswith("KD9")] == []


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ('[[twins]]\nfile = "a.urdf"\n', "'twins[0]' has no 'document'"),
        ('[[twins]]\ndocument = "a.kindsl"\n', "'twins[0]' has no 'file'"),
        (TWINS.format("a.urdf") + "joint = 1\n", "unknown key 'joint'"),
        (TWINS.format("a.urdf") + "tolerance = -1\n", "'twins[0].tolerance' is negative"),
        (TWINS.format("a.urdf") + "joints = { a = 1 }\n", "must be a string, not a number"),
    ],
)
def test_a_wrong_table_is_an_error(kdsl_lint: Runner, table: str, message: str) -> None:
    Path("kindsl.toml").write_text(table)
    run = kdsl_lint(".")
    assert run.status == 2
    assert message in run.err


def test_a_linter_with_twins_loads_no_numpy(tmp_path: Path) -> None:
    import subprocess
    import sys

    program = (
        "import sys\nfrom kindsl.frontends.cli.lint import main\n"
        "main(['arm.kindsl', '--quiet'])\nassert 'numpy' not in sys.modules\n"
    )
    change_urdf('value="0.8"', 'value="0.85"')
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, check=False)
    assert done.returncode == 0
