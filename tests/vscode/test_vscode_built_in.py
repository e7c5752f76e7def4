"""The extension on a machine without a Python that it can use: the built-in one runs the server."""

import json
import os
import shutil
import signal
import subprocess
import sys
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Locator, TimeoutError, expect
from tests.vscode import code_server, models
from tests.vscode.browser import missing
from tests.vscode.code_server import Machine
from tests.vscode.extension_host import OLD_PYTHON
from tests.vscode.workbench import GESTURES, SHOTS, Workbench

BUILT_IN = {"kindsl.interpreter": ["built-in"]}
# What the reach of the elbow is: said above the folder that is open.
CONFIGURATION = "parameters = { reach = 0.4 }\n"
BROKEN = models.BROKEN.replace("(0.4, 0.0, 0.0)", "(reach, 0.0, 0.0)")


@pytest.fixture(scope="module")
def workbench(
    browser: Browser, vsix: Path, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Workbench]:
    """One window that asks for the built-in Python, on a folder in that of its installation."""
    with window(browser, vsix, tmp_path_factory.mktemp("built-in"), BUILT_IN) as workbench:
        yield workbench


def test_a_machine_without_python_needs_nothing_and_passes_an_old_one_over(
    browser: Browser, vsix: Path, tmp_path: Path
) -> None:
    (tmp_path / "kindsl.toml").write_text(CONFIGURATION)
    with window(browser, vsix, tmp_path, {}, bare_machine(tmp_path)) as workbench:
        workbench.open("broken.kindsl", BROKEN)
        expect(workbench.squiggles("error")).to_have_count(2)
        # A warning of the unbound parameter, were the configuration above the folder not read.
        expect(workbench.squiggles("warning")).to_have_count(0)
        expect(language_status(workbench)).to_contain_text("built-in Python")
        workbench.press("Escape")
        workbench.open("arm.kindsl", models.ARM)
        workbench.run("Kinematics-DSL: Open Preview to the Side")
        page = preview_page(workbench)
        expect(page.locator("#robot")).to_have_text("arm")
        page.get_by_role("slider", name="elbow", exact=True).fill("1.2")
        turned = "() => Math.abs(kindsl.scene.q.get('elbow') - 1.2) < 0.01"
        workbench.eventually(lambda: page.evaluate(turned), "the arm turned")
        expect(workbench.notifications()).to_have_count(0)
        workbench.screenshot("built-in")
        # Another server draws the same picture, another robot is seen from where it fits.
        page.evaluate("kindsl.isOfArm = true")
        add_program(tmp_path, "python3", OLD_PYTHON)
        workbench.run("Kinematics-DSL: Restart Server")
        workbench.open("arm.kindsl")
        workbench.go_to_place(1, len("Robot arm") + 1)
        workbench.type("2")
        expect(page.locator("#robot")).to_have_text("arm2")
        assert page.evaluate(turned)
        workbench.open("other.kindsl", models.OTHER)
        expect(page.locator("#robot")).to_have_text("other")
        assert page.evaluate("kindsl.isOfArm") is None
        expect(language_status(workbench)).to_contain_text("built-in Python")
        expect(workbench.notifications()).to_have_count(0)
        workbench.press("Escape")
        workbench.open("broken.kindsl")
        add_program(tmp_path, "python3.12", f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')

        def find() -> None:
            # A Python that is slow to answer is not waited for.
            workbench.run("Kinematics-DSL: Restart Server")
            workbench.wait_until(lambda: host_processes(tmp_path) == [])
            expect(workbench.squiggles("error")).to_have_count(2)

        workbench.insist(find, "a server of the good Python")
        expect(language_status(workbench)).not_to_contain_text("built-in Python")


def test_where_neither_starts_the_user_is_told(
    browser: Browser, vsix: Path, tmp_path: Path
) -> None:
    spoilt = tmp_path / vsix.name
    with zipfile.ZipFile(vsix) as package, zipfile.ZipFile(spoilt, "w") as other:
        for name in package.namelist():
            content = package.read(name)
            is_cut = name.endswith("pyodide.asm.wasm")
            other.writestr(name, content[: len(content) // 2] if is_cut else content)
    machine = bare_machine(tmp_path, python3=OLD_PYTHON)
    with window(browser, spoilt, tmp_path, {}, machine) as workbench:
        workbench.open("broken.kindsl", models.BROKEN)
        message = workbench.notifications().first
        expect(message).to_contain_text("Kinematics-DSL needs Python 3.11 or later: ")
        expect(message).to_contain_text("python3: Python 3.8.10 is too old")
        expect(message).to_contain_text("the built-in Python does not start")
        expect(workbench.notifications()).to_have_count(1)
        workbench.screenshot("built-in-spoilt")


def test_a_server_that_is_killed_or_hangs_is_replaced(workbench: Workbench) -> None:
    work = workbench.folder.parent
    workbench.open("broken.kindsl", models.BROKEN)
    expect(workbench.squiggles("error")).to_have_count(2)
    (first,) = host_processes(work)
    os.kill(first, signal.SIGKILL)
    workbench.eventually(lambda: host_processes(work) not in ([], [first]), "another process")
    workbench.go_to_place(1, len("Robot arm") + 1)
    workbench.type(" {")
    expect(workbench.squiggles("error")).not_to_have_count(2)
    (second,) = host_processes(work)
    keep_busy(workbench, second)
    # Typed in vain, and not lost.
    workbench.press("Backspace")
    workbench.press("Backspace")
    workbench.run("Kinematics-DSL: Restart Server")
    workbench.eventually(lambda: host_processes(work) not in ([], [second]), "a third process")
    expect(workbench.squiggles("error")).to_have_count(2)
    expect(workbench.notifications()).to_have_count(0)


def test_a_workspace_that_is_not_trusted_chooses_no_program_and_runs_none_of_its_own(
    browser: Browser, vsix: Path, tmp_path: Path
) -> None:
    trust = {"enabled": True, "startupPrompt": "never"}
    settings = {f"security.workspace.trust.{name}": value for name, value in trust.items()}
    planted = tmp_path / "robots" / ".venv" / "bin" / "python"
    planted.parent.mkdir(parents=True)
    planted.write_text(f"#!/bin/sh\ntouch '{tmp_path}/has-run'\n")
    planted.chmod(0o755)
    chosen = tmp_path / "robots" / ".vscode" / "settings.json"
    chosen.parent.mkdir()
    chosen.write_text(json.dumps({"kindsl.path": ["/nowhere/server"]}))
    with window(browser, vsix, tmp_path, settings, bare_machine(tmp_path)) as workbench:
        expect(workbench.status("Restricted Mode")).to_be_visible()
        workbench.open("broken.kindsl", models.BROKEN)
        expect(workbench.squiggles("error")).to_have_count(2)
        expect(language_status(workbench)).to_contain_text("built-in Python")
        expect(workbench.notifications()).to_have_count(0)
        assert not (tmp_path / "has-run").exists()


def test_each_folder_of_a_workspace_has_its_configuration(
    browser: Browser, vsix: Path, tmp_path: Path
) -> None:
    names = ("bound", "free")
    for name in names:
        (tmp_path / name).mkdir()
        (tmp_path / name / f"{name}.kindsl").write_text(BROKEN)
    (tmp_path / "bound" / "kindsl.toml").write_text(CONFIGURATION)
    workspace = tmp_path / "all.code-workspace"
    workspace.write_text(json.dumps({"folders": [{"path": name} for name in names]}))
    with window(browser, vsix, tmp_path, BUILT_IN, opened=workspace) as workbench:
        for name, findings in zip(names, "23", strict=True):
            file_name = f"{name}.kindsl"
            folder, file = (
                workbench.page.get_by_role("treeitem", name=each, exact=True)
                for each in (name, file_name)
            )
            expect(folder.or_(file).first).to_be_visible()
            if not file.is_visible():
                workbench.click_until(folder, file)
            workbench.click_until(file, workbench.active_tab(file_name))
            count = workbench.problems().filter(has_text=file_name).locator(".monaco-count-badge")
            expect(count).to_have_text(findings)
        expect(workbench.notifications()).to_have_count(0)
        workbench.screenshot("built-in-folders")


def test_the_preview_opens_in_a_browser_too(workbench: Workbench) -> None:
    work = workbench.folder.parent
    workbench.open("arm.kindsl", models.ARM)
    expect(language_status(workbench)).to_contain_text("built-in Python")
    workbench.run("Kinematics-DSL: Open Preview to the Side")
    panel = preview_page(workbench)
    expect(panel.locator("#robot")).to_have_text("arm")
    page = workbench.page_in_browser()
    expect(page.locator("#state")).to_have_text("live")
    # Each shows what is done in the other.
    page.get_by_role("slider", name="elbow", exact=True).fill("1.2")
    turned = "() => Math.abs(kindsl.scene.q.get('elbow') - 1.2) < 0.01"
    workbench.eventually(lambda: panel.evaluate(turned), "the arm turned in the panel")
    # It comes back to a server that is another one.
    (first,) = host_processes(work)
    os.kill(first, signal.SIGKILL)
    workbench.eventually(lambda: host_processes(work) not in ([], [first]), "another process")
    workbench.open("arm.kindsl")
    workbench.go_to_place(1, len("Robot arm") + 1)
    workbench.type("2")
    expect(page.locator("#robot")).to_have_text("arm2")
    expect(page.locator("#state")).to_have_text("live")
    assert abs(page.evaluate("kindsl.scene.q.get('elbow')") - 1.2) < 0.01
    page.screenshot(path=SHOTS / "built-in-browser.png")


def bare_machine(work: Path, **programs: str) -> Machine:
    """Return a machine on which no Python is found but the programs, texts by their names."""
    probe = subprocess.run(["unshare", "--mount", "true"], capture_output=True, check=False)
    if not shutil.which("unshare") or probe.returncode != 0:
        missing("no program can be hidden from a server here")
    path, home, nothing = work / "path", work / "home", work / "nothing"
    path.mkdir()
    home.mkdir()
    nothing.touch()
    # VS Code takes its PATH from a login shell.
    (home / ".profile").write_text(f'PATH="{path}:/usr/bin:/bin"\n')
    for name, text in programs.items():
        add_program(work, name, text)
    installed = [
        python.resolve()
        for folder in ("/usr/bin", "/usr/local/bin")
        for python in Path(folder).glob("python3*")
        if not python.name.endswith("config")
    ]
    hidden = (f"mount --bind '{nothing}' '{python}'" for python in sorted(set(installed)))
    script = " && ".join([*hidden, 'exec "$@"'])
    before = ["unshare", "--mount", "sh", "-c", script, "sh"]
    return Machine(before, {"PATH": f"{path}:/usr/bin:/bin", "HOME": str(home), "SHELL": "/bin/sh"})


def add_program(work: Path, name: str, text: str) -> None:
    """Let a program be found on the machine."""
    program = work / "path" / name
    program.write_text(text)
    program.chmod(0o755)


@contextmanager
def window(
    browser: Browser,
    vsix: Path,
    work: Path,
    settings: Mapping[str, object],
    machine: Machine = Machine(),  # noqa: B008 (immutable)
    opened: Path | None = None,
) -> Iterator[Workbench]:
    """A window on a workspace, else on the folder `robots`, in an installation of its own."""
    folder = opened or work / "robots"
    if opened is None:
        folder.mkdir(exist_ok=True)
    with code_server.running(work / "data", settings, vsix, machine) as server:
        page = browser.new_page(viewport={"width": 1280, "height": 800})
        workbench = Workbench(page, server, folder)
        try:
            yield workbench
        except BaseException:
            workbench.screenshot(f"failed-{work.name}")
            raise
        page.close()


def host_processes(work: Path) -> list[int]:
    """Return the processes of the built-in Python of an installation."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            words = (process / "cmdline").read_bytes().decode().split("\0")
        except OSError:
            continue
        if any(word.startswith(str(work)) and word.endswith("server/host.js") for word in words):
            found.append(int(process.name))
    return found


def keep_busy(workbench: Workbench, process: int) -> None:
    """Let a process of Node run in a loop that never ends."""
    node = shutil.which("node")
    assert node is not None
    debugger = subprocess.Popen(
        [node, "inspect", "-p", str(process)], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL
    )
    assert debugger.stdin is not None
    try:
        for _ in range(GESTURES):
            debugger.stdin.write(b"exec for (;;) {}\n")
            debugger.stdin.flush()
            before = processor_ticks(process)
            with suppress(TimeoutError):
                workbench.wait_until(lambda since=before: processor_ticks(process) > since + 100)
                return
        raise AssertionError("not seen: a busy process")
    finally:
        debugger.kill()
        debugger.stdin.close()
        debugger.wait(60)


def processor_ticks(process: int) -> int:
    """Return how much a process has worked, in hundredths of a second."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return int(fields[11]) + int(fields[12])


def language_status(workbench: Workbench) -> Locator:
    """Return what the status bar's braces show, opened."""
    button = workbench.page.locator("#status\\.languageStatus")
    hover = workbench.page.locator(".monaco-hover:visible", has_text="Server running")

    def show() -> None:
        button.hover()
        hover.wait_for(timeout=10_000)

    workbench.insist(show, "the language status")
    return hover


def preview_page(workbench: Workbench) -> Locator:
    """Return the body of the panel's page, found again whenever the editor replaces its frames."""
    panel = workbench.page.frame_locator("iframe.webview.ready").frame_locator("#active-frame")
    return panel.locator("body")
