"""Compiled code is kept, found again, and never taken for what it was not compiled for."""

import os
import platform
import shutil
import stat
import sys
import sysconfig
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.codegen.compiling import needs_compiler

import kindsl
from kindsl.mechanics.dynamics.evaluation import compiling
from kindsl.mechanics.dynamics.evaluation.compiling import (
    CompileError,
    cache_folder,
    compiled_module,
    require_compiler,
)

SOURCE = """
#include <Python.h>
static struct PyModuleDef DEFINITION = {PyModuleDef_HEAD_INIT, "tiny", "A tiny module.", -1};
PyMODINIT_FUNC PyInit_tiny(void) { return PyModule_Create(&DEFINITION); }
"""
EXAMPLE = Path(__file__).parents[2] / "examples" / "industrial_arm.kindsl"
needs_posix = pytest.mark.skipif(os.name != "posix", reason="modes and owners as POSIX has them")
HOME = Path("/home/anna")


@pytest.mark.parametrize(
    ("system", "environment", "expected"),
    [
        ("linux", {}, HOME / ".cache/kindsl/compiled"),
        ("linux", {"XDG_CACHE_HOME": "/var/x"}, Path("/var/x/kindsl/compiled")),
        ("darwin", {}, HOME / "Library/Caches/kindsl/compiled"),
        ("darwin", {"XDG_CACHE_HOME": "/var/x"}, HOME / "Library/Caches/kindsl/compiled"),
        ("win32", {}, HOME / "AppData/Local/kindsl/compiled"),
        ("win32", {"LOCALAPPDATA": "/local"}, Path("/local/kindsl/compiled")),
        ("win32", {"KINDSL_CACHE": "/mine"}, Path("/mine")),
        ("linux", {"KINDSL_CACHE": "/mine", "XDG_CACHE_HOME": "/var/x"}, Path("/mine")),
    ],
)
def test_code_is_kept_where_the_system_keeps_such(
    system: str, environment: dict[str, str], expected: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("KINDSL_CACHE", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setattr(Path, "home", lambda: HOME)
    assert cache_folder() == expected


@pytest.fixture(scope="module")
def tiny(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file with the compiled source."""
    folder = tmp_path_factory.mktemp("tiny") / "not" / "there yet"
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KINDSL_CACHE", str(folder))
        assert compiled_module("tiny", SOURCE).__doc__ == "A tiny module."
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700
    (file,) = folder.iterdir()
    return file


@pytest.fixture
def made(
    tiny: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Callable[[str], list[Path]]:
    """Ask for a source; tell the files that were made so far."""
    files: list[Path] = []

    def compile_(_: str, __: str, path: Path) -> None:
        files.append(Path(shutil.copy(tiny, path)))

    def ask(source: str = SOURCE) -> list[Path]:
        assert compiled_module("tiny", source).__doc__ == "A tiny module."
        return files

    monkeypatch.setenv("KINDSL_CACHE", str(tmp_path))
    monkeypatch.setattr(compiling, "_compile", compile_)
    return ask


@needs_compiler
def test_what_is_there_is_taken(made: Callable[..., list[Path]]) -> None:
    assert len(made()) == len(made()) == 1
    assert len(made(SOURCE + "\n")) == 2


@needs_compiler
def test_another_computer_s_code_is_not_taken(
    made: Callable[..., list[Path]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A folder may be shared; another processor's instructions end the process."""
    told = {"text": "processor : 0\nflags : sse2 avx2\n"}
    monkeypatch.setattr(Path, "read_text", lambda *_, **__: told["text"])
    assert len(made()) == 1
    told["text"] = "processor : 0\nflags : sse2\n"
    assert len(made()) == 2
    told["text"] = "processor : 1\nflags : sse2\n"
    assert len(made()) == 2
    told["text"] = "processor : 1\nFeatures : asimd\n"
    assert len(made()) == 3
    told["text"] = "nothing of the kind"
    assert len(made()) == 4
    monkeypatch.setattr(platform, "machine", lambda: "another")
    assert len({*made()}) == 5


@needs_compiler
def test_without_a_list_of_features_the_processor_tells(
    made: Callable[..., list[Path]], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object, **__: object) -> str:
        raise FileNotFoundError

    monkeypatch.setattr(Path, "read_text", refuse)
    for count, name in enumerate(("one", "another"), start=1):
        monkeypatch.setattr(platform, "processor", lambda name=name: name)
        assert len(made()) == len(made()) == count


@needs_compiler
@pytest.mark.parametrize(("told", "used"), [(".abi.so", ".abi.so"), (None, ".so")])
def test_files_end_as_extensions_do(
    made: Callable[..., list[Path]], told: str | None, used: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sysconfig, "get_config_var", lambda _: told)
    made()
    (file,) = cache_folder().iterdir()
    assert file.name.endswith(used) and file.name.count(".") == used.count(".")


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (OSError(28, "No space left on device"), "cannot be used: No space left on device"),
        (OSError("odd"), "cannot be used: odd"),
        (ImportError("wrong"), "^the compiled code cannot be loaded: wrong$"),
    ],
)
def test_what_goes_wrong_is_told(
    error: Exception, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: Any) -> None:
        raise error

    monkeypatch.setenv("KINDSL_CACHE", str(tmp_path))
    monkeypatch.setattr(compiling, "_compile", fail)
    with pytest.raises(CompileError, match=message):
        compiled_module("tiny", SOURCE)


def test_what_is_no_code_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("KINDSL_CACHE", str(tmp_path))
    monkeypatch.setattr(compiling, "_compile", lambda *given: given[-1].write_bytes(b"text"))
    with pytest.raises(CompileError, match="the compiled code cannot be loaded: "):
        compiled_module("tiny", SOURCE)


@needs_compiler
@needs_posix
@pytest.mark.parametrize("mask", [0o000, 0o022, 0o077])
def test_what_is_kept_is_for_its_owner_alone(
    tiny: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, mask: int
) -> None:
    folder = tmp_path / "new"
    monkeypatch.setenv("KINDSL_CACHE", str(folder))
    monkeypatch.setattr(compiling, "_compile", lambda *given: shutil.copy(tiny, given[-1]))
    former = os.umask(mask)
    try:
        compiled_module("tiny", SOURCE)
    finally:
        os.umask(former)
    (file,) = folder.iterdir()
    assert (stat.S_IMODE(folder.stat().st_mode), stat.S_IMODE(file.stat().st_mode)) == (
        0o700,
        0o600,
    )


def another_content(file: Path) -> None:
    content = file.read_bytes()
    file.unlink()  # What is loaded already stays.
    file.write_bytes(content + b"x")
    file.chmod(0o600)


def another_writer(file: Path) -> None:
    file.chmod(0o620)


def another_owner(file: Path) -> None:
    os.chown(file, 1234, -1)


def a_link(file: Path) -> None:
    file.rename(file.parent / "elsewhere")
    file.symlink_to("elsewhere")


@needs_compiler
@needs_posix
@pytest.mark.parametrize("change", [another_content, another_writer, another_owner, a_link])
def test_what_is_not_trusted_is_not_loaded(
    made: Callable[..., list[Path]], change: Callable[[Path], None]
) -> None:
    if change is another_owner and os.geteuid() != 0:
        pytest.skip("only the superuser gives files away")
    assert len(made()) == 1
    (file,) = cache_folder().iterdir()
    change(file)
    assert len(made()) == 2
    assert len(made()) == 2
    assert stat.S_ISREG(file.lstat().st_mode) and stat.S_IMODE(file.stat().st_mode) == 0o600


@needs_posix
@pytest.mark.parametrize(
    ("owner", "mode", "message"),
    [(-1, 0o770, "others may write to it"), (1234, 0o700, "it belongs to somebody else")],
)
def test_a_folder_of_others_is_not_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, owner: int, mode: int, message: str
) -> None:
    if owner >= 0 and os.geteuid() != 0:
        pytest.skip("only the superuser gives folders away")
    monkeypatch.setenv("KINDSL_CACHE", str(tmp_path))
    os.chown(tmp_path, owner, -1)
    tmp_path.chmod(mode)
    with pytest.raises(CompileError, match=f"cannot be used: {message}$"):
        compiled_module("tiny", SOURCE)


@needs_posix
@pytest.mark.parametrize("compiler", [None, "no-such-cc -O2"])
def test_without_a_compiler_it_is_told_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, compiler: str | None
) -> None:
    mechanism = kindsl.load(EXAMPLE).mechanism()
    monkeypatch.setenv("KINDSL_CACHE", str(tmp_path))
    monkeypatch.setattr(sys, "platform", "linux")
    if compiler is None:
        monkeypatch.delenv("CC", raising=False)
        monkeypatch.setenv("PATH", str(tmp_path))
    else:
        monkeypatch.setenv("CC", compiler)
    with pytest.raises(kindsl.CompileError, match=r"needs a C compiler, and '.*' is .*apt inst"):
        mechanism.compiled()
    assert mechanism.joint_space_inertia([0.1] * mechanism.n_joints).shape == (6, 6)


def test_without_headers_it_is_told_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sysconfig, "get_path", lambda _: str(tmp_path))
    monkeypatch.setattr(shutil, "which", lambda name: name)
    monkeypatch.setattr(sys, "platform", "linux")
    with pytest.raises(CompileError, match="the C headers of Python: apt install python3-dev"):
        require_compiler()
