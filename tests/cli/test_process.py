"""The commands as processes: status, streams, no traceback."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from tests.cli.samples import GOOD, INTEGER, UNBOUND

LINT = (sys.executable, "-c", "from kindsl.frontends.cli.lint import main; main()")
KINDSL = (sys.executable, "-m", "kindsl")


def run(*command: str, **options: object) -> "subprocess.CompletedProcess[str]":
    environment = {k: v for k, v in os.environ.items() if k != "KINDSL_TRACEBACK"}
    return subprocess.run(
        command, capture_output=True, text=True, check=False, env=environment, **options
    )  # type: ignore[call-overload, no-any-return]


@pytest.mark.parametrize(("text", "status"), [(GOOD, 0), (INTEGER, 1)])
def test_status_of_the_process(folder: Path, text: str, status: int) -> None:
    (folder / "a.kindsl").write_text(text)
    assert run(*LINT, "a.kindsl").returncode == status
    assert run(*KINDSL, "lint", "a.kindsl").returncode == status
    assert run(sys.executable, "-m", "kindsl.frontends.cli.lint", "a.kindsl").returncode == status
    assert run(*LINT, "missing.kindsl").returncode == 2
    assert run(*LINT, "--nonsense").returncode == 2


def test_output_is_whole(folder: Path) -> None:
    for number in range(60):
        (folder / f"m{number}.kindsl").write_text(INTEGER)
    told = run(*LINT, "--output-format", "json", "--jobs", "2")
    assert told.stdout.count('"KD005"') == 60
    assert told.stdout.endswith("]\n")


def test_jobs_give_the_same_in_the_same_order(folder: Path) -> None:
    for number in range(40):
        text = INTEGER if number % 3 else UNBOUND
        (folder / f"m{number:02}.kindsl").write_text(text)
    one, two = (run(*LINT, "--output-format", "json", "--jobs", n) for n in "12")
    assert one.stdout == two.stdout
    assert one.returncode == two.returncode == 1
    assert len(json.loads(one.stdout)) == 40


def test_reader_that_goes_away_is_no_defect(folder: Path) -> None:
    for number in range(300):
        (folder / f"m{number}.kindsl").write_text(INTEGER)
    command = (
        f"{sys.executable} -c 'from kindsl.frontends.cli.lint import main; main()' -q | head -1"
    )
    told = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert told.stdout.startswith("m0.kindsl:21:32:")
    assert told.stderr == ""


def test_stdout_that_knows_no_unicode(folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD.replace("Robot arm", "Robot arm é"))
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    told = subprocess.run(
        [*LINT, "a.kindsl"], capture_output=True, text=True, env=environment, check=False
    )
    assert told.returncode == 1
    assert "\\xe9" in told.stdout
    assert "Traceback" not in told.stderr


def test_interrupted_watch_ends_quietly(folder: Path) -> None:
    (folder / "a.kindsl").write_text(INTEGER)
    with subprocess.Popen(
        [*LINT, "--watch"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stderr is not None
        told = ""
        while "watching" not in told:
            told = process.stderr.readline()
        process.send_signal(signal.SIGINT)
        try:
            output, errors = process.communicate(timeout=60)
        finally:
            process.kill()
    assert output.startswith("a.kindsl:21:32:")
    assert errors == ""
    assert process.returncode == 1


def test_defect_outside_of_a_document_shows_no_traceback(folder: Path) -> None:
    code = "import kindsl.frontends.cli.lint as lint\nlint.run = lambda args: 1 / 0\nlint.main()"
    told = run(sys.executable, "-c", code)
    assert told.returncode == 2
    assert told.stderr == "kindsl: error: internal error: ZeroDivisionError: division by zero\n"


def test_importing_the_package_is_light() -> None:
    code = (
        "import sys, typing; old = set(sys.modules); import kindsl; print(set(sys.modules) - old)"
    )
    assert run(sys.executable, "-c", code).stdout == "{'kindsl'}\n"


def test_linting_imports_nothing_slow(folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD)
    code = (
        "import sys\nfrom kindsl.frontends.cli.lint import main\nmain(['a.kindsl'])\n"
        "slow = {'numpy', 'lark', 'pygls', 'json', 'dataclasses', 'logging', 'tomllib', 'pathspec',"
        " 'importlib.metadata', 'asyncio', 'multiprocessing', 'difflib', 'tempfile', 'inspect',"
        " 'subprocess', 'xml', 'shutil', 'tomlkit', 'kindsl.language.syntax.mending',"
        " 'kindsl.judgement.rules.inertia.repairs'}\n"
        "print(sorted(slow & set(sys.modules)))"
    )
    assert run(sys.executable, "-I", "-S", "-c", _with_path(code)).stdout == "[]\n"


def _with_path(code: str) -> str:
    import kindsl

    return f"import sys; sys.path.insert(0, {str(Path(kindsl.__file__).parents[1])!r})\n{code}"


FULL = Path("/dev/full")
needs_full = pytest.mark.skipif(not FULL.exists(), reason="Linux has /dev/full")


@needs_full
@pytest.mark.parametrize(
    "command",
    [
        (*LINT, "a.kindsl"),
        (*LINT, "--version"),
        (*LINT, "--list-rules"),
        (*KINDSL, "format", "-"),
        (*KINDSL, "info", "a.kindsl"),
        (*KINDSL, "info", "--help"),
        (*KINDSL, "compute", "a.kindsl", "--q", "0", "--output-format", "npz"),
        (*KINDSL, "card", "a.kindsl", "-o", "/dev/full"),
    ],
)
def test_output_that_cannot_be_written_is_a_failure(folder: Path, command: tuple[str, ...]) -> None:
    (folder / "a.kindsl").write_text(INTEGER if command[0:3] == LINT else GOOD)
    with FULL.open("w") as full, (folder / "a.kindsl").open() as source:
        told = subprocess.run(
            command, stdin=source, stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    assert told.returncode == 2
    assert told.stderr.endswith("error: cannot be written: No space left on device\n")
    assert "Traceback" not in told.stderr and "internal" not in told.stderr


@pytest.mark.skipif(os.name != "posix", reason="closes streams in a shell")
def test_closed_streams_are_no_defect(folder: Path) -> None:
    (folder / "a.kindsl").write_text(GOOD)
    info = f"{sys.executable} -m kindsl info a.kindsl"
    told = run("sh", "-c", f"{info} >&-")
    assert (told.returncode, told.stderr) == (
        2,
        "stdout: error: cannot be written: Bad file descriptor\n",
    )
    told = run("sh", "-c", f"{info} 2>&-")
    assert told.returncode == 0 and told.stdout.startswith("arm")
