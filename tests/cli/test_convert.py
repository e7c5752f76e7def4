"""`kindsl convert` on the command line: formats by suffix or by name; nothing half written."""

import subprocess
import sys
from pathlib import Path

import pytest
from tests.support.robots import ARM, LIFT

from kindsl.frontends.cli.main import main

EXAMPLE = Path(__file__).parents[2] / "examples" / "quadruped.kindsl"
FORCED = {"compute": (), "convert": (), "generate": ("--force",)}


@pytest.mark.parametrize("suffix", [".urdf", ".xml", ".mjcf", ".sdf"])
def test_suffix_tells_the_format(suffix: str, tmp_path: Path) -> None:
    there, back = tmp_path / f"a{suffix}", tmp_path / "a.kindsl"
    assert main(["convert", "--isolated", str(EXAMPLE), str(there)]) == 0
    assert main(["convert", "--floating-base", str(there), str(back)]) == 0
    assert main(["diff", "--isolated", str(EXAMPLE), str(back)]) == 0


def test_options_tell_what_the_suffix_does_not(tmp_path: Path, capsys) -> None:
    there = tmp_path / "a.txt"
    assert main(["convert", "--isolated", "--to", "sdf", str(EXAMPLE), str(there)]) == 0
    assert main(["convert", "--from", "sdf", "--to", "mjcf", "-q", str(there), "-"]) == 0
    assert "<freejoint" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["a.kindsl", "b.step"],
            "b.step: error: the suffix '.step' does not determine the format: use",
        ),
        (["a", "b.kindsl"], "a: error: a name without a suffix does not determine the format: use"),
        (["a.sdf", "b.sdf"], "input and output are both SDF"),
        (["a.kindsl", "b.xacro"], "b.xacro: error: xacro cannot be written"),
        (["a.sdf", "b.kindsl"], "a.sdf: error: no such file or folder"),
    ],
)
def test_what_is_not_possible_is_one_sentence(arguments, message, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["convert", *arguments]) == 2
    told = capsys.readouterr().err
    assert message in told and told.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == [".git"]


def test_all_parameters_without_a_value_are_named_with_the_remedy(tmp_path: Path, capsys) -> None:
    source, target = tmp_path / "a.kindsl", tmp_path / "a.urdf"
    source.write_text(ARM.replace("(0.5, 0.0, 0.0)", "(upper, 0.0, 0.0)"))
    assert main(["convert", "--isolated", str(source), str(target)]) == 1
    told = capsys.readouterr().err
    assert "--param reach=VALUE --param upper=VALUE" in told
    assert not target.exists()


def test_what_mujoco_cannot_move_is_written_and_told(tmp_path: Path, capsys) -> None:
    light = tmp_path / "light.kindsl"
    light.write_text(EXAMPLE.read_text().replace("mass =", "mass = -1.0 //"))
    assert main(["convert", "--isolated", str(light), str(tmp_path / "a.xml")]) == 0
    assert "mass of 'trunk' is negative: MuJoCo refuses the file" in capsys.readouterr().err
    assert 'mass="-1"' in (tmp_path / "a.xml").read_text()


def test_missing_library_names_its_extra(tmp_path, capsys, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    target = tmp_path / "a.xml"
    assert main(["convert", "--isolated", str(EXAMPLE), str(target)]) == 2
    assert "mujoco is not installed: pip install 'kindsl[mjcf]'" in capsys.readouterr().err
    assert not target.exists()


@pytest.mark.parametrize("suffix", [".urdf", ".sdf"])
def test_nothing_need_be_installed_for_formats_of_plain_numbers(suffix: str, tmp_path) -> None:
    """Nothing is in a browser."""
    there, back = tmp_path / f"a{suffix}", tmp_path / "a.kindsl"
    code = "import sys; sys.modules.update(dict.fromkeys(('numpy', 'lxml', 'yourdfpy')));"
    code += "from kindsl.frontends.cli.main import main; sys.exit(main(sys.argv[1:]))"
    convert = [sys.executable, "-c", code, "convert", "--isolated", "-q"]
    subprocess.run([*convert, str(EXAMPLE), str(there)], check=True)
    subprocess.run([*convert, "--floating-base", str(there), str(back)], check=True)
    assert main(["diff", "--isolated", str(EXAMPLE), str(back)]) == 0


@pytest.mark.parametrize(
    ("command", "more"),
    [
        ("compute", ()),
        ("convert", ("arm.urdf",)),
        ("generate", ("--language", "python", "--quantities", "poses", "-o", "out")),
    ],
)
def test_a_command_tells_what_is_read_in_two_ways(
    command: str, more: tuple[str, ...], tmp_path: Path, capsys, monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    turned = LIFT.replace("rotation = (0.0, 0.0, 0.0)", "rotation = (pi, 2.0 - PI, 0.0)", 1)
    assert "2.0 - PI" in turned
    Path("arm.kindsl").write_text(turned)
    notes = (
        "note: 'pi' is taken for the number pi; robcogen takes it for a parameter 'pi':"
        " set 'target' in kindsl.toml\n",
        "note: '2.0 - PI' is taken for the product of 2.0 and -PI\n",
        "arm.kindsl: note: has an error, see kindsl lint\n",
    )
    assert main([command, "--isolated", "arm.kindsl", *more]) == 0
    told = capsys.readouterr().err
    assert [note for note in notes if note not in told] == []
    Path("arm.kindsl").write_text(LIFT)
    assert main([command, "--isolated", "arm.kindsl", *more, *FORCED[command]]) == 0
    assert "taken for" not in capsys.readouterr().err
