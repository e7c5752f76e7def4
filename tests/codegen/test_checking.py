"""Generated code is compared with its document by what it computes."""

from pathlib import Path

import pytest
from tests.codegen.compiling import needs_compiler
from tests.support.robots import LIFT

from kindsl.judgement.analysis.analysis import analyse
from kindsl.products.codegen.checking import misfit
from kindsl.products.codegen.generating import Source, generate
from kindsl.products.codegen.library import Options
from kindsl.products.codegen.manifest import NAME

OPTIONS = Options("c", ("gravity_torque",), "double", False, "unbound", "arm")


def source(text: str) -> Source:
    return Source("arm.kindsl", analyse(text), {})


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, text in generate(source(LIFT), OPTIONS)[1].items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


@needs_compiler
@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (LIFT, None),
        ("// The same robot.\n" + LIFT, None),
        (LIFT.replace("mass = 2.0", "mass = 2.0001"), "and gives other numbers"),
        (LIFT.replace("upper", "renamed"), None),
        (LIFT.replace("lift", "raised"), None),
    ],
)
def test_code_fits_while_it_gives_the_numbers(
    folder: Path, text: str, expected: str | None, capfd: pytest.CaptureFixture[str]
) -> None:
    why = misfit(source(text), folder)
    assert why == expected or (expected and str(why).endswith(expected))
    assert capfd.readouterr() == ("", "")


def test_without_a_compiler_a_changed_document_does_not_fit(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("kindsl.products.codegen.checking._compiler", lambda: None)
    why = misfit(source(LIFT.replace("upper", "renamed")), folder)
    assert why == f"'arm.kindsl' has changed since '{folder}' was generated"


def test_code_that_was_edited_does_not_fit(folder: Path) -> None:
    (folder / "arm_gravity_torque.c").write_text("", encoding="utf-8")
    why = misfit(source(LIFT), folder)
    assert why == f"'{folder / 'arm_gravity_torque.c'}' was edited or is missing"
    assert (folder / NAME).is_file()
